// SPDX-License-Identifier: Apache-2.0
#include "scene/settings.h"

#include <algorithm>

namespace snell::scene {

Integrator IntegratorFor(const Scene& scene) {
  const bool isPhysical = std::ranges::any_of(scene.objects, [&](const Object& object) {
    return object.material >= 0 && scene.materials[std::size_t(object.material)].physical;
  });
  return isPhysical ? Integrator::Path : Integrator::Whitted;
}

int SamplesFor(Integrator integrator) {
  return integrator == Integrator::Path ? PathSamples : WhittedSamples;
}

void Resolve(const Scene& scene, RenderSettings& settings) {
  if (!settings.integrator) settings.integrator = IntegratorFor(scene);
  if (settings.spp == 0) settings.spp = SamplesFor(*settings.integrator);
}

}  // namespace snell::scene
