// SPDX-License-Identifier: Apache-2.0
//
// What every device offers: prepare a scene once, then render samples of it into a film.
#pragma once

#include <memory>
#include <string>

#include "render/film.h"
#include "render/schedule.h"
#include "render/statistics.h"
#include "scene/scene.h"
#include "util/progress.h"

namespace snell::render {

// What to render of a scene, and how; what the scene itself says about that is only a default.
struct RenderRequest {
  scene::RenderSettings settings;  // valid (scene/validate.h)
  scene::Camera camera;
  PixelRect rect;                // pixels to render; within the picture
  std::uint32_t lastSample = 0;  // one past the last; the film says which is the first
  StopConditions stop = {};
  SavePlan save = {};
  // Compare what samples depend on with what the film says, or enter it there if that says nothing
  bool wantsOrigin = false;
  std::string program = {};   // its name and version, for that
  std::string filmFile = {};  // that the film was read from, for messages
};

class Renderer {
 public:
  virtual ~Renderer() = default;

  // Render into `film`, which covers `request.rect`, and has AOVs if the settings ask for them. Samples are added in passes over the whole picture,
  // so that a render that is stopped early leaves a complete, coarser picture. A film with samples is gone on
  // with. Returns what was done; throws Error on faults of the scene, the device or memory.
  virtual Statistics Render(const scene::Scene& scene, const RenderRequest& request, Film& film,
                            Progress* progress, const StopFlag* stop) = 0;
};

}  // namespace snell::render
