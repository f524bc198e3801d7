// SPDX-License-Identifier: Apache-2.0
#include "cpu/render_cpu.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "cpu/kernel.h"
#include "render/meter.h"
#include "render/tally.h"
#include "render/tiles.h"
#include "util/check.h"
#include "util/threads.h"
#include "util/timer.h"

namespace snell::cpu {

namespace {

constexpr int TileSize = 16;

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

// Follow the ray tree to its end.
render::TracedSample TraceWhitted(Kernel& kernel, uvec2 pixel, std::uint32_t sample) {
  WhittedState state;
  kernel.WhittedBegin(state, pixel, sample);
  while (state.alive == 1) kernel.WhittedStep(state);
  return {state.L, state.rays, state.dropped, 0.0f};
}

// Follow the path to its end.
render::TracedSample TracePath(Kernel& kernel, uvec2 pixel, std::uint32_t sample) {
  PathState state;
  kernel.PathBegin(state, pixel, sample);
  while (state.alive == 1) kernel.PathStep(state);
  return {state.L, state.rays, 0, state.held};
}

// Bring the tile's pixels to their goals, or as far as time allows.
void RenderTile(Kernel kernel, scene::Integrator integrator, render::PixelRect tile,
                const std::function<bool()>& interrupted, Replay& replay, render::Film& film,
                render::Tally& tally) {
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

        const render::TracedSample traced = trace(kernel, uvec2(uint(x), uint(y)), sample);
        tally.Add(x, y, sample, traced, kernel.params.clampIndirect > 0, film, aov);
      }
    }
  }
}

}  // namespace

// `interruptions` may have begun to measure time before.
static void RenderPasses(const scene::Scene& scene, const PreparedScene& prepared,
                         const render::RenderRequest& request, render::Film& film,
                         Progress* progress, render::Interruptions& interruptions,
                         render::Statistics& statistics) {
  statistics.device = fmt::format("CPU, {}", bvh::NameOf(bvh::BestInstructionSet()));
  statistics.threads = ActiveThreads();
  const FlatScene& flat = prepared.flat();
  statistics.filmBytes = film.MemoryBytes() + (film.aovs() ? film.aovs()->MemoryBytes() : 0);

  // Render pass by pass, tile by tile
  const Timer timer;
  const Kernel kernel = BindKernel(flat, prepared.bvh());
  const std::vector<render::PixelRect> tiles = render::TilesInOrder(request.rect, TileSize);
  const std::size_t workerCount = std::size_t(HardwareThreads());
  std::vector<render::Tally> workers(workerCount);
  render::PassPlan plan = render::PlanPass(film, request.lastSample, request.stop);
  {
    render::Meter meter(progress, request.stop, plan);
    while (plan.samples > 0 && !interruptions.Stopped() &&
           !interruptions.TimeIsOver(plan.hasPicture)) {
      const auto interrupted = [&] { return interruptions.Any(plan.hasPicture); };
      ParallelInOrder(tiles.size(), [&](std::uint64_t i, int worker) {
        if (interrupted()) return;
        render::Tally& tally = workers[std::size_t(worker)];
        const std::uint64_t samplesBefore = tally.samples;
        const std::uint64_t raysBefore = tally.rays.Sum();
        Replay replay{&scene, 0, 0, 0};
        const CheckContext context(Replay::Describe, &replay);
        RenderTile(kernel, flat.integrator, tiles[i], interrupted, replay, film, tally);
        meter.Add(tally.samples - samplesBefore, tally.rays.Sum() - raysBefore);
      });
      interruptions.SaveIfDue(film);
      plan = render::PlanPass(film, request.lastSample, request.stop);
      meter.Plan(plan);
    }
  }
  statistics.end = interruptions.Ended(plan, film);
  render::AddUp(workers, statistics);
  statistics.renderSeconds = timer.Seconds();
}

void RenderPrepared(const scene::Scene& scene, const PreparedScene& prepared,
                    const render::RenderRequest& request, render::Film& film, Progress* progress,
                    const StopFlag* stop, render::Statistics& statistics) {
  render::Interruptions interruptions(request.stop, request.save, stop);
  RenderPasses(scene, prepared, request, film, progress, interruptions, statistics);
}

render::Statistics CpuRenderer::Render(const scene::Scene& scene,
                                       const render::RenderRequest& request, render::Film& film,
                                       Progress* progress, const StopFlag* stop) {
  render::Interruptions interruptions(request.stop, request.save, stop);
  render::Statistics statistics;
  const PreparedScene prepared(scene, request, film, progress, statistics);
  RenderPasses(scene, prepared, request, film, progress, interruptions, statistics);
  return statistics;
}

}  // namespace snell::cpu
