// SPDX-License-Identifier: Apache-2.0
#include "api/render_on.h"

#include <fmt/format.h>

#include <optional>

#include "cpu/render_cpu.h"
#include "gpu/choose.h"
#include "gpu/render_gpu.h"
#include "util/timer.h"

namespace snell {

namespace {

// None if "auto" finds no GPU that is hardware and can render, which is no fault.
std::unique_ptr<gpu::GpuRenderer> OpenGpu(const RenderOptions& options) {
  if (options.device == "auto" && !options.gpuDebug && !gpu::MayHaveHardware()) return nullptr;
  try {
    return std::make_unique<gpu::GpuRenderer>(gpu::GpuOptions{options.device, options.gpuDebug});
  } catch (const Error&) {
    if (options.device != "auto" || options.gpuDebug) throw;
    return nullptr;
  }
}

// What one device did before another one went on.
void AddEarlier(const render::Statistics& earlier, render::Statistics& statistics) {
  statistics.rays.Add(earlier.rays);
  statistics.samples += earlier.samples;
  statistics.nonFiniteSamples += earlier.nonFiniteSamples;
  statistics.nonFinite.insert(statistics.nonFinite.begin(), earlier.nonFinite.begin(),
                              earlier.nonFinite.end());
  statistics.droppedBranches += earlier.droppedBranches;
  statistics.flattenSeconds += earlier.flattenSeconds;
  statistics.buildSeconds += earlier.buildSeconds;
  statistics.renderSeconds += earlier.renderSeconds;
  if (earlier.samples > 0)
    statistics.device = fmt::format("{}; then {}", earlier.device, statistics.device);
}

}  // namespace

render::Statistics RenderOnDevice(const scene::Scene& scene, const RenderOptions& options,
                                  const render::RenderRequest& request, render::Film& film,
                                  Progress* progress, const StopFlag* stop) {
  const Timer timer;
  cpu::CpuRenderer cpu;
  if (options.device == "cpu") return cpu.Render(scene, request, film, progress, stop);
  render::Statistics onGpu;
  std::string fault;
  {
    const std::unique_ptr<gpu::GpuRenderer> gpu = OpenGpu(options);
    if (!gpu) return cpu.Render(scene, request, film, progress, stop);
    try {
      onGpu = gpu->Render(scene, request, film, progress, stop);
      if (onGpu.end != render::End::Fault || options.device != "auto") return onGpu;
      fault = onGpu.fault;
    } catch (const Error& error) {
      if (options.device != "auto") throw;
      fault = error.what();
    }
  }

  // Go on with what there is; a fault of the scene comes again
  render::RenderRequest rest = request;
  rest.stop.seconds -= timer.Seconds();
  render::Statistics statistics = cpu.Render(scene, rest, film, progress, stop);
  statistics.warnings.push_back(fault + "; the processor has rendered instead");
  AddEarlier(onGpu, statistics);
  return statistics;
}

}  // namespace snell
