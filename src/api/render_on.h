// SPDX-License-Identifier: Apache-2.0
//
// Rendering on the device that was asked for, and on the processor if no other will do.
#pragma once

#include "api/render.h"
#include "render/renderer.h"

namespace snell {

// As render::Renderer::Render, on the device of `options`.
render::Statistics RenderOnDevice(const scene::Scene& scene, const RenderOptions& options,
                                  const render::RenderRequest& request, render::Film& film,
                                  Progress* progress, const StopFlag* stop);

}  // namespace snell
