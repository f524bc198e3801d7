// SPDX-License-Identifier: Apache-2.0
#include "cli/render_summary.h"

#include <fmt/format.h>

#include <cmath>

#include "util/json.h"
#include "util/text.h"

namespace snell::cli {

static double MraysPerSecond(const RenderReport& report) {
  return report.renderSeconds > 0 ? double(report.Rays()) / report.renderSeconds * 1e-6 : 0;
}

static const char* EndText(RenderEnd end) {
  switch (end) {
    case RenderEnd::Samples: return "samples";
    case RenderEnd::Noise: return "noise";
    case RenderEnd::Time: return "time";
    case RenderEnd::Stopped: return "signal";
    case RenderEnd::Fault: return "fault";
  }
  return "";
}

std::string SamplesText(double samplesPerPixel) {
  const bool whole = samplesPerPixel == std::floor(samplesPerPixel);
  return whole ? fmt::format("{:.0f}", samplesPerPixel) : fmt::format("{:.2f}", samplesPerPixel);
}

static std::string SamplesPerPixel(const RenderReport& report) {
  const char* noun = report.samplesPerPixel == 1 ? "sample" : "samples";
  return fmt::format("{} {} per pixel", SamplesText(report.samplesPerPixel), noun);
}

std::string SummaryText(const RenderSummary& summary) {
  const RenderReport& r = summary.report;
  std::string text =
      fmt::format("{}: {} × {} pixels, {}; {}, {}\n", summary.scene, summary.width, summary.height,
                  SamplesPerPixel(r), r.device, Plural(std::uint64_t(r.threads), "thread"));
  const std::string denoise =
      r.denoiser.empty() ? ""
                         : fmt::format("denoise {} ({}), ", Duration(r.denoiseSeconds), r.denoiser);
  text +=
      fmt::format("  time     load {}, prepare {}, build {}, render {}, {}write {}; {} in all\n",
                  Duration(summary.loadSeconds), Duration(r.prepareSeconds),
                  Duration(r.buildSeconds), Duration(r.renderSeconds), denoise,
                  Duration(summary.writeSeconds), Duration(summary.totalSeconds));
  text += fmt::format(
      "  rays     {} camera, {} reflected, {} refracted, {} shadow; {} in all, {:.2f} Mrays/s\n",
      WithCommas(r.cameraRays), WithCommas(r.reflectedRays), WithCommas(r.refractedRays),
      WithCommas(r.shadowRays), WithCommas(r.Rays()), MraysPerSecond(r));
  text +=
      fmt::format("  memory   scene {}, BVH {}, film {}; {} at the peak\n", ByteSize(r.sceneBytes),
                  ByteSize(r.bvhBytes), ByteSize(r.filmBytes), ByteSize(summary.peakBytes));
  if (r.noise) {
    text += fmt::format("  noise    {:.2g} RMS, {:.2g} at most; {} above what was asked\n",
                        r.noise->rms, r.noise->largest, Plural(r.noise->pixels, "pixel"));
  }
  if (r.heldBack > 0) text += fmt::format("  clamped  {:.2g} % of the light\n", r.heldBack * 100);
  text += fmt::format("  written  {}\n", summary.files.empty()
                                             ? "nothing"
                                             : fmt::format("{}", fmt::join(summary.files, ", ")));
  return text;
}

std::string SummaryJson(const RenderSummary& summary) {
  const RenderReport& r = summary.report;
  JsonWriter json;
  json.Add("snell", Version());
  json.Add("scene", summary.scene);
  json.Add("device", r.device);
  json.Add("threads", r.threads);
  json.BeginObject("picture");
  json.Add("width", summary.width);
  json.Add("height", summary.height);
  json.Add("samples_per_pixel", r.samplesPerPixel);
  json.Add("complete", r.end == RenderEnd::Samples || r.end == RenderEnd::Noise);
  json.Add("ended_by", EndText(r.end));
  if (r.resumedSamples > 0) json.Add("resumed_samples_per_pixel", r.resumedSamples);
  json.End();
  if (r.noise) {
    json.BeginObject("noise");
    json.Add("rms", r.noise->rms);
    json.Add("largest", r.noise->largest);
    json.Add("pixels_above", r.noise->pixels);
    json.End();
  }
  if (r.heldBack > 0) json.Add("clamped_share", r.heldBack);
  json.BeginObject("seconds");
  json.Add("load", summary.loadSeconds);
  json.Add("prepare", r.prepareSeconds);
  json.Add("build", r.buildSeconds);
  json.Add("render", r.renderSeconds);
  if (!r.denoiser.empty()) json.Add("denoise", r.denoiseSeconds);
  json.Add("write", summary.writeSeconds);
  json.Add("total", summary.totalSeconds);
  json.End();
  json.BeginObject("rays");
  json.Add("camera", r.cameraRays);
  json.Add("reflected", r.reflectedRays);
  json.Add("refracted", r.refractedRays);
  json.Add("shadow", r.shadowRays);
  json.Add("total", r.Rays());
  json.End();
  json.Add("mrays_per_second", MraysPerSecond(r));
  json.BeginObject("bytes");
  json.Add("scene", r.sceneBytes);
  json.Add("bvh", r.bvhBytes);
  json.Add("film", r.filmBytes);
  json.Add("peak", summary.peakBytes);
  json.End();
  json.Add("files", summary.files);
  json.Add("warnings", summary.warnings);
  return json.Finish();
}

}  // namespace snell::cli
