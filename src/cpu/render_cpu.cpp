// SPDX-License-Identifier: Apache-2.0
#include "cpu/render_cpu.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

#include "cpu/aov_names.h"
#include "cpu/bind_kernel.h"
#include "cpu/origin.h"
#include "render/film_file.h"
#include "render/tiles.h"
#include "util/check.h"
#include "util/error.h"
#include "util/threads.h"
#include "util/timer.h"

namespace snell::cpu {

namespace {

constexpr int TileSize = 16;
constexpr std::size_t NonFiniteKept = 8;

// What one worker counts; padded so that workers do not share cache lines.
struct alignas(64) WorkerCounts {
  render::RayTotals rays;
  std::uint64_t samples = 0;
  std::uint64_t nonFiniteSamples = 0;
  std::vector<render::NonFiniteSample> nonFinite;
  std::uint64_t droppedBranches = 0;
  render::ExactSum light;     // added to the film, over all pixels
  render::ExactSum heldBack;  // and not added
};

// The sample being computed, for the message of a failed check.
struct Replay {
  const scene::Scene* scene;
  int x;
  int y;
  std::uint32_t sample;

  static void Describe(const void* data, char* text, int size) {
    const Replay& r = *static_cast<const Replay*>(data);
    const auto end = fmt::format_to_n(
        text, std::size_t(size - 1),
        "while rendering pixel {},{} sample {}; to replay it: snell render {} "
        "--crop {},{},{},{} --samples {}:{}",
        r.x, r.y, r.sample, r.scene->name, r.x, r.y, r.x + 1, r.y + 1, r.sample, r.sample + 1);
    *end.out = '\0';
  }
};

bool IsFinite(Spectrum L) { return std::isfinite(L.x) && std::isfinite(L.y) && std::isfinite(L.z); }

// A better tree costs a fraction of a second per million triangles. The choice depends on the scene alone, so
// that a part of a picture is made as the whole.
bvh::BuildQuality QualityFor(const FlatScene& flat) {
  return flat.triangles.size() < 4000000 ? bvh::BuildQuality::High : bvh::BuildQuality::Fast;
}

// What one sample of a pixel gave.
struct Traced {
  Spectrum L;
  RayCounts rays;
  uint dropped;
  float held;
};

// Follow the ray tree to its end.
Traced TraceWhitted(Kernel& kernel, uvec2 pixel, std::uint32_t sample) {
  WhittedState state;
  kernel.WhittedBegin(state, pixel, sample);
  while (state.alive == 1) kernel.WhittedStep(state);
  return {state.L, state.rays, state.dropped, 0.0f};
}

// Follow the path to its end.
Traced TracePath(Kernel& kernel, uvec2 pixel, std::uint32_t sample) {
  PathState state;
  kernel.PathBegin(state, pixel, sample);
  while (state.alive == 1) kernel.PathStep(state);
  return {state.L, state.rays, 0, state.held};
}

// Bring the tile's pixels to their goals, or as far as time allows.
void RenderTile(Kernel kernel, scene::Integrator integrator, render::PixelRect tile,
                const std::function<bool()>& interrupted, Replay& replay, render::Film& film,
                WorkerCounts& counts) {
  WhittedBranch branches[WhittedStackSize];
  kernel.branches = branches;
  AovSample aov = {};
  kernel.aovs = &aov;
  const auto trace = integrator == scene::Integrator::Path ? TracePath : TraceWhitted;
  for (int y = tile.y0; y < tile.y1 && !interrupted(); ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const render::Film::Pixel& pixel = film.At(x, y);
      while (pixel.count < pixel.goal) {
        const std::uint32_t sample = film.firstSample() + pixel.count;
        replay.x = x;
        replay.y = y;
        replay.sample = sample;

        const Traced traced = trace(kernel, uvec2(uint(x), uint(y)), sample);

        // Count and locate what went wrong, never hide it
        Spectrum L = traced.L;
        if (!IsFinite(L)) {
          ++counts.nonFiniteSamples;
          if (counts.nonFinite.size() < NonFiniteKept) counts.nonFinite.push_back({x, y, sample});
          L = Spectrum(0.0f);
          aov.direct = L;
          for (Spectrum& group : aov.groups) group = L;
        }
        film.Add(x, y, sample, L);
        if (film.aovs()) film.aovs()->Add(x, y, sample, L, aov);
        counts.rays.Add(traced.rays);
        counts.droppedBranches += traced.dropped;
        if (kernel.params.clampIndirect > 0) {
          counts.light.Add(render::Film::Brightness(glm::dvec3(L)));
          counts.heldBack.Add(IsFinite(Spectrum(traced.held)) ? double(traced.held) : 0.0);
        }
        ++counts.samples;
      }
    }
  }
}

// Tells progress in samples, or, where time or noise may end the render sooner, in millionths of it.
class Meter {
 public:
  Meter(Progress* progress, const render::StopConditions& stop, const render::PassPlan& plan)
      : progress_(progress), stop_(stop), plain_(!(stop.noise > 0) && std::isinf(stop.seconds)) {
    Plan(plan);
    if (progress_) progress_->Begin("rendering", plain_ ? plan.remaining : Millionths);
  }
  ~Meter() {
    if (progress_) progress_->End();
  }
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  // Between passes.
  void Plan(const render::PassPlan& plan) { expected_ = samples_ + plan.remaining; }

  // For any thread.
  void Add(std::uint64_t newSamples, std::uint64_t newRays) {
    const std::uint64_t samples = samples_ += newSamples;
    const std::uint64_t rays = rays_ += newRays;
    if (!progress_) return;
    const double share =
        std::max(double(samples) / double(expected_), timer_.Seconds() / stop_.seconds);
    progress_->Update(plain_ ? samples : std::uint64_t(std::min(share, 1.0) * Millionths), rays);
  }

 private:
  static constexpr std::uint64_t Millionths = 1000000;

  Progress* const progress_;
  const render::StopConditions& stop_;
  const bool plain_;
  Timer timer_;
  std::uint64_t expected_ = 0;
  std::atomic<std::uint64_t> samples_{0};
  std::atomic<std::uint64_t> rays_{0};
};

// Samples of another picture must not be added to the film's.
void CheckOrigin(const FlatScene& flat, const render::RenderRequest& request, render::Film& film) {
  const render::FilmOrigin origin{SamplesDependOn(flat, request.settings, request.program), {}};
  if (film.origin().samples.empty()) {
    film.origin().samples = origin.samples;
    return;
  }
  const std::string difference = render::Difference(origin, film.origin());
  if (!difference.empty())
    throw Error(fmt::format("the film is of another render: now there is {}", difference),
                {request.filmFile}, "to begin anew, leave out --resume");
}

}  // namespace

render::Statistics CpuRenderer::Render(const scene::Scene& scene,
                                       const render::RenderRequest& request, render::Film& film,
                                       Progress* progress, const StopFlag* stop) {
  render::Interruptions interruptions(request.stop, request.save, stop);
  render::Statistics statistics;
  statistics.device = fmt::format("CPU, {}", bvh::NameOf(bvh::BestInstructionSet()));
  statistics.threads = ActiveThreads();

  // Prepare the scene
  if (progress) progress->Begin("building", 0);
  Timer timer;
  FlatScene flat = Flatten(scene, request.settings, request.camera);
  statistics.flattenSeconds = timer.Seconds();
  statistics.warnings = flat.warnings;
  if (request.wantsOrigin) CheckOrigin(flat, request, film);
  timer = {};
  const bvh::Bvh bvh(flat.Geometry(), QualityFor(flat));
  statistics.buildSeconds = timer.Seconds();
  statistics.droppedPrimitives = bvh.droppedPrimitives();
  statistics.sceneBytes = flat.MemoryBytes();
  statistics.bvhBytes = bvh.MemoryBytes();
  statistics.filmBytes = film.MemoryBytes() + (film.aovs() ? film.aovs()->MemoryBytes() : 0);
  if (progress) progress->End();

  // Render pass by pass, tile by tile
  timer = {};
  const Kernel kernel = BindKernel(flat, bvh);
  if (film.aovs() && !film.aovs()->SetNames(AovNamesOf(scene, flat)))
    throw Error("the film is of another render: objects or materials have other names",
                {request.filmFile}, "to begin anew, leave out --resume");
  const std::vector<render::PixelRect> tiles = render::TilesInOrder(request.rect, TileSize);
  const std::size_t workerCount = std::size_t(HardwareThreads());
  std::vector<WorkerCounts> workers(workerCount);
  render::PassPlan plan = render::PlanPass(film, request.lastSample, request.stop);
  {
    Meter meter(progress, request.stop, plan);
    while (plan.samples > 0 && !interruptions.Stopped() &&
           !interruptions.TimeIsOver(plan.hasPicture)) {
      const auto interrupted = [&] { return interruptions.Any(plan.hasPicture); };
      ParallelInOrder(tiles.size(), [&](std::uint64_t i, int worker) {
        if (interrupted()) return;
        WorkerCounts& counts = workers[std::size_t(worker)];
        const std::uint64_t samplesBefore = counts.samples;
        const std::uint64_t raysBefore = counts.rays.Sum();
        Replay replay{&scene, 0, 0, 0};
        const CheckContext context(Replay::Describe, &replay);
        RenderTile(kernel, flat.integrator, tiles[i], interrupted, replay, film, counts);
        meter.Add(counts.samples - samplesBefore, counts.rays.Sum() - raysBefore);
      });
      interruptions.SaveIfDue(film);
      plan = render::PlanPass(film, request.lastSample, request.stop);
      meter.Plan(plan);
    }
  }
  if (plan.samples > 0)
    statistics.end = interruptions.Stopped() ? render::End::Stopped : render::End::Time;
  else
    statistics.end =
        plan.resting == film.pixels().size() ? render::End::Noise : render::End::Samples;

  // Add up what the workers counted
  render::ExactSum light, heldBack;
  for (const WorkerCounts& counts : workers) {
    statistics.rays.Add(counts.rays);
    statistics.samples += counts.samples;
    statistics.nonFiniteSamples += counts.nonFiniteSamples;
    statistics.droppedBranches += counts.droppedBranches;
    light.Add(counts.light);
    heldBack.Add(counts.heldBack);
    for (const render::NonFiniteSample& sample : counts.nonFinite) {
      if (statistics.nonFinite.size() < NonFiniteKept) statistics.nonFinite.push_back(sample);
    }
  }
  if (heldBack.Value() > 0)
    statistics.heldBack = heldBack.Value() / (light.Value() + heldBack.Value());
  statistics.renderSeconds = timer.Seconds();
  return statistics;
}

}  // namespace snell::cpu
