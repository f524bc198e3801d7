// SPDX-License-Identifier: Apache-2.0
#include "api/render.h"

#include <fmt/format.h>

#include <cmath>

#include "api/film_keeper.h"
#include "api/film_picture.h"
#include "api/render_on.h"
#include "api/request.h"
#include "api/version.h"
#include "render/noise.h"
#include "scene/settings.h"
#include "util/text.h"
#include "util/threads.h"
#include "util/timer.h"

namespace snell {

namespace {

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
  auto [request, firstSample] = RequestOf(contents, options);

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
