// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: rendering. Installed as <snell/api/render.h>.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../util/progress.h"
#include "picture.h"
#include "scene.h"

namespace snell {

// Overrides what the scene says; whatever is empty stays as the scene has it.
struct RenderOptions {
  std::optional<int> width;
  std::optional<int> height;
  std::optional<int> spp;
  std::optional<int> maxDepth;
  std::optional<float> minContribution;
  std::optional<std::string> integrator;  // "whitted" or "path"; else by the materials
  std::optional<std::string> camera;      // by name; else the first one
  std::optional<std::array<int, 4>>
      crop;  // x0, y0, x1, y1 in pixels; the picture has just these pixels
  std::optional<std::pair<std::uint32_t, std::uint32_t>>
      samples;      // [first, last) instead of [0, spp)
  int threads = 0;  // 0: all processors
};

struct RenderReport {
  std::string device;
  int threads = 0;
  bool stopped = false;        // by the stop flag, before all samples were done
  double samplesPerPixel = 0;  // that were done
  std::uint64_t cameraRays = 0;
  std::uint64_t reflectedRays = 0;
  std::uint64_t refractedRays = 0;
  std::uint64_t shadowRays = 0;
  double prepareSeconds = 0;  // flattening the scene
  double buildSeconds = 0;    // the BVH
  double renderSeconds = 0;
  std::uint64_t sceneBytes = 0;
  std::uint64_t bvhBytes = 0;
  std::uint64_t filmBytes = 0;
  std::vector<std::string>
      warnings;  // of what happened while rendering: samples that were not finite, …

  std::uint64_t Rays() const { return cameraRays + reflectedRays + refractedRays + shadowRays; }
};

struct RenderResult {
  Picture picture;
  RenderReport report;
};

// Render a scene. `progress` and `stop` may be null; raising `stop` ends the render early with the picture
// so far. Throws Error.
SNELL_EXPORT RenderResult Render(const Scene& scene, const RenderOptions& options = {},
                                 Progress* progress = nullptr, const StopFlag* stop = nullptr);

}  // namespace snell
