// SPDX-License-Identifier: Apache-2.0
#include "api/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "api/film_keeper.h"
#include "api/film_picture.h"
#include "api/render_on.h"
#include "api/version.h"
#include "render/noise.h"
#include "scene/framing.h"
#include "scene/settings.h"
#include "scene/validate.h"
#include "util/text.h"
#include "util/threads.h"
#include "util/timer.h"

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

// Refuse a picture that memory cannot hold before any is taken: the film, and copies for output.
void CheckMemory(const render::PixelRect& rect, std::uint64_t aovBytes) {
  const std::uint64_t BytesPerPixel = sizeof(render::Film::Pixel) + 12 + 12 + aovBytes;
  const std::uint64_t pixels = std::uint64_t(rect.Width()) * std::uint64_t(rect.Height());
  const std::uint64_t available = AvailableMemoryBytes();
  if (available > 0 && pixels * BytesPerPixel > available)
    throw Error(
        fmt::format("a picture of {}×{} pixels needs {} of memory; {} are available", rect.Width(),
                    rect.Height(), ByteSize(pixels * BytesPerPixel), ByteSize(available)),
        {}, "choose a smaller size, or render it in parts with a crop");
}

// Add the picture without noise to the result.
void Denoise(const render::Film& film, Denoiser denoiser, RenderResult& result) {
  const Timer timer;
  Denoised denoised = DenoisedOf(film, denoiser);
  result.denoised = std::move(denoised.picture);
  result.report.denoiser = denoised.by;
  result.report.denoiseSeconds = timer.Seconds();
}

RenderEnd EndOf(render::End end) {
  switch (end) {
    case render::End::Samples: return RenderEnd::Samples;
    case render::End::Noise: return RenderEnd::Noise;
    case render::End::Time: return RenderEnd::Time;
    case render::End::Stopped: return RenderEnd::Stopped;
    case render::End::Fault: return RenderEnd::Fault;
  }
  return RenderEnd::Stopped;
}

NoiseReport NoiseOf(const render::Film& film, const render::StopConditions& stop) {
  NoiseReport report;
  const std::vector<float> errors = render::DisplayErrors(film, stop.noiseScale);
  for (const float error : errors) {
    report.rms += double(error) * double(error) / double(errors.size());
    report.largest = std::max(report.largest, double(error));
    report.pixels += error > stop.noise ? 1 : 0;
  }
  report.rms = std::sqrt(report.rms);
  return report;
}

RenderReport ReportOf(const render::Statistics& statistics) {
  RenderReport report;
  report.device = statistics.device;
  report.threads = statistics.threads;
  report.end = EndOf(statistics.end);
  report.fault = statistics.fault;
  report.stopped = report.end == RenderEnd::Stopped;
  report.cameraRays = statistics.rays.camera;
  report.reflectedRays = statistics.rays.reflected;
  report.refractedRays = statistics.rays.refracted;
  report.shadowRays = statistics.rays.shadow;
  report.prepareSeconds = statistics.flattenSeconds;
  report.buildSeconds = statistics.buildSeconds;
  report.renderSeconds = statistics.renderSeconds;
  report.sceneBytes = statistics.sceneBytes;
  report.bvhBytes = statistics.bvhBytes;
  report.filmBytes = statistics.filmBytes;
  report.heldBack = statistics.heldBack;
  report.warnings = statistics.warnings;
  if (statistics.nonFiniteSamples > 0) {
    const render::NonFiniteSample& first = statistics.nonFinite.front();
    report.warnings.push_back(
        fmt::format("{} had a radiance that is not finite and count as black, the first at "
                    "pixel {},{} sample {}",
                    Plural(statistics.nonFiniteSamples, "sample"), first.x, first.y, first.sample));
  }
  if (statistics.droppedPrimitives > 0) {
    report.warnings.push_back(fmt::format("{} left out: a coordinate is not finite",
                                          Plural(statistics.droppedPrimitives, "primitive")));
  }
  if (statistics.droppedBranches > 0) {
    report.warnings.push_back(
        fmt::format("{} of ray trees left out: the trees are too wide; raise min_contribution",
                    Plural(statistics.droppedBranches, "branch")));
  }
  return report;
}

}  // namespace

std::vector<std::string> KnownAovs() {
  std::vector<std::string> names;
  for (const auto& [name, aov] : scene::AovNames()) names.push_back(name);
  return names;
}

RenderResult Render(const Scene& scene, const RenderOptions& options, Progress* progress,
                    const StopFlag* stop) {
  const Timer timer;
  const scene::Scene& contents = scene.contents();
  render::RenderRequest request;
  request.settings = SettingsOf(contents, options);
  request.camera =
      CameraOf(contents, options, double(request.settings.width) / request.settings.height);
  request.rect = RectOf(request.settings, options);
  const auto [firstSample, lastSample] = SamplesOf(request.settings, options);
  request.lastSample = lastSample;

  const ThreadLimit limit(options.threads);
  const std::vector<std::string> groups = scene::LightGroupsOf(contents);
  const bool hasAovs = !request.settings.aovs.Empty() || request.settings.denoise;
  CheckMemory(request.rect, hasAovs ? render::AovFilm::BytesPerPixel(request.settings.aovs, groups,
                                                                     request.settings.denoise)
                                    : 0);
  FilmKeeper keeper(options.film);
  render::Film film = keeper.Begin(request.rect, firstSample, request.settings);
  const double samplesBefore = SamplesPerPixel(film);
  std::optional<render::AovFilm> aovs;
  if (hasAovs) aovs.emplace(request.rect, request.settings.aovs, groups, request.settings.denoise);
  keeper.SetAovs(std::move(aovs), film);
  film.origin().notes = {{"scene", contents.name},
                         {"exposure", fmt::format("{}", request.settings.exposure)},
                         {"view", scene.view()},
                         {"spp", fmt::format("{}", request.settings.spp)}};
  request.stop.noise = options.noise.value_or(0);
  request.stop.noiseScale = std::exp2(double(options.exposure.value_or(request.settings.exposure)));
  request.wantsOrigin = keeper.Keeps();
  request.program = "Snell " + Version();
  request.filmFile = options.film.checkpoint.string();
  request.save = keeper.Plan();
  if (options.seconds) request.stop.seconds = *options.seconds - timer.Seconds();
  const render::Statistics statistics =
      RenderOnDevice(contents, options, request, film, progress, stop);

  RenderResult result;
  result.picture = PictureOf(film);
  result.report = ReportOf(statistics);
  result.report.samplesPerPixel = SamplesPerPixel(film);
  result.report.resumedSamples = samplesBefore;
  if (options.noise) result.report.noise = NoiseOf(film, request.stop);
  keeper.Finish(film, result.report.stopped || !result.report.fault.empty());
  result.report.checkpointSaved = keeper.saved();
  result.report.filmFault = keeper.outputFault();
  for (const std::string& warning : keeper.warnings()) result.report.warnings.push_back(warning);
  if (request.settings.denoise && !film.Empty()) Denoise(film, options.denoiser, result);
  return result;
}

}  // namespace snell
