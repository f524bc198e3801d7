// SPDX-License-Identifier: Apache-2.0
#include "api/request.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "api/camera_view.h"
#include "scene/framing.h"
#include "scene/settings.h"
#include "scene/validate.h"
#include "util/text.h"

namespace snell {

namespace {

scene::Aov AovNamed(const std::string& name) {
  for (const auto& [known, aov] : scene::AovNames()) {
    if (known == name) return aov;
  }
  throw Error(fmt::format("there is no AOV '{}'", name), {},
              fmt::format("the AOVs are: {}", fmt::join(KnownAovs(), ", ")));
}

scene::Caustics CausticsNamed(const std::string& name) {
  if (name == "full") return scene::Caustics::Full;
  if (name == "regularized") return scene::Caustics::Regularized;
  if (name == "none") return scene::Caustics::None;
  throw Error(fmt::format("there are no caustics '{}'", name), {},
              "the choices are: full, regularized, none");
}

scene::RenderSettings SettingsOf(const scene::Scene& scene, const RenderOptions& options) {
  scene::RenderSettings settings = scene.settings;
  // One of width and height given alone keeps the aspect ratio
  if (options.width && !options.height) {
    settings.height =
        std::max(1, int(double(settings.height) * *options.width / settings.width + 0.5));
  } else if (options.height && !options.width) {
    settings.width =
        std::max(1, int(double(settings.width) * *options.height / settings.height + 0.5));
  }
  settings.width = options.width.value_or(settings.width);
  settings.height = options.height.value_or(settings.height);
  settings.spp = options.spp.value_or(settings.spp);
  settings.maxDepth = options.maxDepth.value_or(settings.maxDepth);
  settings.maxDiffuseDepth = options.maxDiffuseDepth.value_or(settings.maxDiffuseDepth);
  settings.maxSpecularDepth = options.maxSpecularDepth.value_or(settings.maxSpecularDepth);
  settings.maxTransmissionDepth =
      options.maxTransmissionDepth.value_or(settings.maxTransmissionDepth);
  if (options.caustics) settings.caustics = CausticsNamed(*options.caustics);
  settings.minContribution = options.minContribution.value_or(settings.minContribution);
  settings.clampIndirect = options.clampIndirect.value_or(settings.clampIndirect);
  if (options.integrator) {
    const bool isPath = *options.integrator == "path";
    if (!isPath && *options.integrator != "whitted")
      throw Error(fmt::format("there is no integrator '{}'", *options.integrator), {},
                  "the integrators are: whitted, path");
    settings.integrator = isPath ? scene::Integrator::Path : scene::Integrator::Whitted;
  }
  if (options.aovs) {
    settings.aovs = {};
    for (const std::string& name : *options.aovs) settings.aovs.Add(AovNamed(name));
  }
  settings.denoise = options.denoiser != Denoiser::None;
  scene::Resolve(scene, settings);
  scene::Validate(settings);
  return settings;
}

scene::Camera CameraOf(const scene::Scene& scene, const RenderOptions& options, double aspect) {
  if (options.camera) {
    std::vector<std::string> names;
    for (const scene::Camera& camera : scene.cameras) {
      if (camera.name == *options.camera) return camera;
      if (!camera.name.empty()) names.push_back(camera.name);
    }
    std::string hint = DidYouMean(*options.camera, names);
    if (hint.empty())
      hint = names.empty() ? "its cameras have no names"
                           : fmt::format("its cameras are: {}", fmt::join(names, ", "));
    throw Error(fmt::format("the scene has no camera '{}'", *options.camera), {scene.name}, hint);
  }
  return scene.cameras.empty() ? scene::DefaultCamera(scene, aspect) : scene.cameras.front();
}

render::PixelRect RectOf(const scene::RenderSettings& settings, const RenderOptions& options) {
  if (!options.crop) return {0, 0, settings.width, settings.height};
  const auto [x0, y0, x1, y1] = *options.crop;
  const render::PixelRect rect{x0, y0, x1, y1};
  if (rect.Empty() || x0 < 0 || y0 < 0 || x1 > settings.width || y1 > settings.height)
    throw Error(fmt::format("the crop {},{},{},{} is empty or outside the picture of {}×{} pixels",
                            x0, y0, x1, y1, settings.width, settings.height));
  return rect;
}

// [first, last): without a limit where noise or time was asked for instead.
std::pair<std::uint32_t, std::uint32_t> SamplesOf(scene::RenderSettings& settings,
                                                  const RenderOptions& options) {
  if (options.samples) {
    const auto [first, last] = *options.samples;
    if (first >= last) throw Error(fmt::format("the range of samples {}:{} is empty", first, last));
    return {first, last};
  }
  constexpr int Most = std::numeric_limits<int>::max();
  constexpr int MostForNoise = 1 << 16;
  if (!options.spp && (options.seconds || options.noise))
    settings.spp = options.seconds ? Most : MostForNoise;
  return {0, std::uint32_t(settings.spp)};
}

}  // namespace

std::pair<render::RenderRequest, std::uint32_t> RequestOf(const scene::Scene& scene,
                                                          const RenderOptions& options) {
  render::RenderRequest request;
  request.settings = SettingsOf(scene, options);
  request.camera =
      CameraOf(scene, options, double(request.settings.width) / request.settings.height);
  if (options.cameraView) request.camera = CameraSeenFrom(request.camera, *options.cameraView);
  request.rect = RectOf(request.settings, options);
  const auto [firstSample, lastSample] = SamplesOf(request.settings, options);
  request.lastSample = lastSample;
  return {std::move(request), firstSample};
}

}  // namespace snell
