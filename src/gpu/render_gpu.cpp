// SPDX-License-Identifier: Apache-2.0
#include "gpu/render_gpu.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <future>

#include "cpu/prepare.h"
#include "gpu/choose.h"
#include "gpu/sample_tracer.h"
#include "gpu/work.h"
#include "render/meter.h"
#include "render/tally.h"
#include "util/threads.h"
#include "util/timer.h"

namespace snell::gpu {

namespace {

// Systems take a device away from programs that keep it busy for seconds; screens freeze much sooner.
constexpr double BatchSeconds = 0.05;
constexpr std::uint32_t FirstLimit = 4096;

// How large batches are, so that each takes about so long.
class Pace {
 public:
  explicit Pace(std::uint32_t most) : most_(most), limit_(std::min(FirstLimit, most)) {}

  std::uint32_t limit() const { return limit_; }
  // A batch of `samples` has taken so long.
  void Learn(std::size_t samples, double seconds) {
    const double factor = std::clamp(BatchSeconds / std::max(seconds, 1e-6), 0.25, 4.0);
    if (factor > 1 && samples < limit_ / 2) return;  // the end of a pass tells little
    const double limit = double(limit_) * factor;
    limit_ = std::uint32_t(std::clamp(limit, double(Work::LeastLimit), double(most_)));
  }

 private:
  std::uint32_t most_;
  std::uint32_t limit_;
};

// The film that samples go to, and who counts them.
struct Sums {
  render::Film& film;
  bool clamps;
  std::vector<render::Tally> tallies;  // by worker

  void Add(const Batch& batch, const SampleTracer::Results& results, render::Meter& meter) {
    ParallelInOrder(batch.shares.size(), [&](std::uint64_t i, int worker) {
      render::Tally& tally = tallies[std::size_t(worker)];
      const std::uint64_t raysBefore = tally.rays.Sum();
      kernel::AovSample aov = {};
      for (std::size_t k = batch.shares[i].first; k < batch.shares[i].last; ++k) {
        const kernel::SampleRequest& request = batch.requests[k];
        const kernel::SampleResult& result = results.samples[k];
        if (film.aovs()) aov = results.aovs[k];
        tally.Add(int(request.pixel.x), int(request.pixel.y), request.index,
                  {result.L, result.rays, result.dropped, result.held}, clamps, film, aov);
      }
      meter.Add(batch.shares[i].last - batch.shares[i].first, tally.rays.Sum() - raysBefore);
    });
  }
};

// Bring the film's pixels to their goals, or as far as time allows.
template <class Interrupted>
void RenderPass(SampleTracer& tracer, Interrupted interrupted, Pace& pace, Sums& sums,
                render::Meter& meter) {
  struct UnderWay {
    Batch batch;
    std::size_t slot;
    Timer timer;
  };
  Work work(sums.film);
  std::deque<UnderWay> underWay;
  std::size_t started = 0;
  Timer sinceFinished;
  for (;;) {
    // Keep the device busy
    while (underWay.size() < SampleTracer::Slots && !interrupted()) {
      Batch batch = work.Next(pace.limit());
      if (batch.requests.empty()) break;
      const std::size_t slot = started++ % SampleTracer::Slots;
      tracer.Start(slot, batch.requests);
      underWay.push_back({std::move(batch), slot, {}});
    }
    if (underWay.empty()) return;

    // Add up the batch that was started first
    const UnderWay& first = underWay.front();
    const SampleTracer::Results results = tracer.Finish(first.slot);
    pace.Learn(first.batch.requests.size(),
               std::min(first.timer.Seconds(), sinceFinished.Seconds()));
    sinceFinished = {};
    sums.Add(first.batch, results, meter);
    underWay.pop_front();
  }
}

}  // namespace

GpuRenderer::GpuRenderer(const GpuOptions& options)
    : instance_(options.validate), device_(instance_, ChooseDevice(instance_, options.device)) {}

render::Statistics GpuRenderer::Render(const scene::Scene& scene,
                                       const render::RenderRequest& request, render::Film& film,
                                       Progress* progress, const StopFlag* stop) {
  render::Interruptions interruptions(request.stop, request.save, stop);
  render::Statistics statistics;
  statistics.device = fmt::format("{}, {}", physical().name, physical().driver);
  statistics.threads = ActiveThreads();

  // Compile while the scene is prepared
  PipelineCache cache(device_);
  const std::span<const std::uint32_t> shader =
      ShaderOf(request.settings.integrator.value_or(scene::Integrator::Whitted));
  auto compiled = std::async(std::launch::async, [&] {
    return physical().Software()
               ? std::make_unique<VulkanProgram>(device_, WithNoContraction(shader), &cache)
               : std::make_unique<VulkanProgram>(device_, shader, &cache);
  });
  const cpu::PreparedScene prepared(scene, request, film, progress, statistics);
  const TraceArrays tree = ToTraceArrays(prepared.bvh(), prepared.geometry());
  statistics.bvhBytes = tree.MemoryBytes();
  statistics.filmBytes = film.MemoryBytes() + (film.aovs() ? film.aovs()->MemoryBytes() : 0);
  if (progress) progress->Begin("compiling", 0);
  const std::unique_ptr<VulkanProgram> program = compiled.get();
  cache.Save();
  if (!cache.warning().empty()) statistics.warnings.push_back(cache.warning());
  const std::uint64_t most =
      film.pixels().size() * std::uint64_t(request.lastSample - film.firstSample());
  SampleTracer tracer(device_, *program, prepared.flat(), tree, most);
  if (progress) progress->End();

  // Render pass by pass
  const Timer timer;
  Sums sums{film, request.settings.clampIndirect > 0,
            std::vector<render::Tally>(std::size_t(HardwareThreads()))};
  Pace pace(tracer.capacity());
  render::PassPlan plan = render::PlanPass(film, request.lastSample, request.stop);
  try {
    render::Meter meter(progress, request.stop, plan);
    while (plan.samples > 0 && !interruptions.Stopped() &&
           !interruptions.TimeIsOver(plan.hasPicture)) {
      RenderPass(
          tracer, [&] { return interruptions.Any(plan.hasPicture); }, pace, sums, meter);
      interruptions.SaveIfDue(film);
      plan = render::PlanPass(film, request.lastSample, request.stop);
      meter.Plan(plan);
    }
    statistics.end = interruptions.Ended(plan, film);
  } catch (const Error& error) {
    statistics.end = render::End::Fault;
    statistics.fault = error.what();
  }
  render::AddUp(sums.tallies, statistics);
  for (const std::string& finding : instance_.TakeFindings())
    statistics.warnings.push_back("Vulkan validation: " + finding);
  statistics.renderSeconds = timer.Seconds();
  return statistics;
}

}  // namespace snell::gpu
