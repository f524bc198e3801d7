// SPDX-License-Identifier: Apache-2.0
#include "cpu/origin.h"

#include <fmt/format.h>

#include "util/hash.h"

namespace snell::cpu {

template <class T>
static std::string Sum(const T& record) {
  Hasher hasher;
  hasher.Add(&record, sizeof record);
  return "#" + hasher.Text();
}

render::Properties SamplesDependOn(const FlatScene& flat, const scene::RenderSettings& settings,
                                   const std::string& program) {
  Hasher scene;
  flat.VisitBuffers([&](const auto& buffer) {
    const std::uint64_t count = buffer.size();
    scene.Add(&count, sizeof count);
    scene.Add(buffer.data(), buffer.size() * sizeof buffer[0]);
  });

  // Everything of the parameters that has no name of its own
  kernel::RenderParams others = flat.params;
  others.camera = {};
  others.coneWidth = others.coneSpread = 0;
  others.maxDepth = others.seed = others.aovs = 0;
  others.minContribution = others.clampIndirect = 0;
  kernel::Camera camera = flat.params.camera;
  camera.resolution = {0, 0};
  const bool isPath = settings.integrator == scene::Integrator::Path;
  return {{"program", program},
          {"scene", "#" + scene.Text()},
          {"camera", Sum(camera)},
          {"size", fmt::format("{}×{}", settings.width, settings.height)},
          {"integrator", isPath ? "path" : "whitted"},
          {"maximum depth", fmt::format("{}", settings.maxDepth)},
          {"minimum contribution", fmt::format("{}", settings.minContribution)},
          {"limit of indirect light", fmt::format("{}", settings.clampIndirect)},
          {"seed", fmt::format("{}", settings.seed)},
          // Textures are filtered for it
          {"number of samples (--spp)", fmt::format("{}", settings.spp)},
          {"filter or other settings", Sum(others)}};
}

}  // namespace snell::cpu
