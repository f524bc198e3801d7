// SPDX-License-Identifier: Apache-2.0
//
// What every device offers: prepare a scene once, then render samples of it into a film.
#pragma once

#include <memory>

#include "render/aov_film.h"
#include "render/film.h"
#include "render/statistics.h"
#include "scene/scene.h"
#include "util/progress.h"

namespace snell::render {

// What to render of a scene, and how; what the scene itself says about that is only a default.
struct RenderRequest {
  scene::RenderSettings settings;  // valid (scene/validate.h)
  scene::Camera camera;
  PixelRect rect;  // pixels to render; within the picture
  std::uint32_t firstSample = 0;
  std::uint32_t lastSample = 0;  // one past the last
  AovFilm* aovs = nullptr;       // receives what settings.aovs asks for, of the same pixels
};

class Renderer {
 public:
  virtual ~Renderer() = default;

  // Render into `film`, which covers `request.rect`. Samples are added in passes over the whole picture,
  // so that a render that is stopped early leaves a complete, coarser picture. Returns what was done;
  // throws Error on faults of the scene, the device or memory.
  virtual Statistics Render(const scene::Scene& scene, const RenderRequest& request, Film& film,
                            Progress* progress, const StopFlag* stop) = 0;
};

}  // namespace snell::render
