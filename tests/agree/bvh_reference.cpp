// SPDX-License-Identifier: Apache-2.0
#include "agree/bvh_reference.h"

#include "cpu/kernel.h"

namespace snell::agree {

using namespace kernel;

std::vector<Spectrum> RenderByBvh(const cpu::FlatScene& scene, const bvh::Bvh& bvh,
                                  std::uint32_t sample, std::vector<AovSample>* aovs) {
  cpu::Kernel kernel = cpu::BindKernel(scene, bvh);
  const uvec2 resolution = scene.params.camera.resolution;
  std::vector<Spectrum> radiance;
  WhittedState state;
  PathState path;
  WhittedBranch branches[WhittedStackSize];
  kernel.branches = branches;
  AovSample aov = {};
  kernel.aovs = &aov;
  for (uint y = 0; y < resolution.y; ++y) {
    for (uint x = 0; x < resolution.x; ++x) {
      if (scene.integrator == scene::Integrator::Path) {
        kernel.PathBegin(path, uvec2(x, y), sample);
        while (path.alive == 1) kernel.PathStep(path);
        radiance.push_back(path.L);
        if (aovs) aovs->push_back(aov);
        continue;
      }
      kernel.WhittedBegin(state, uvec2(x, y), sample);
      while (state.alive == 1) kernel.WhittedStep(state);
      radiance.push_back(state.L);
      if (aovs) aovs->push_back(aov);
    }
  }
  return radiance;
}

}  // namespace snell::agree
