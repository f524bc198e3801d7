// SPDX-License-Identifier: Apache-2.0
//
// The CPU as a device: all cores, through oneTBB, with the same picture bit for bit at any number of them.
#pragma once

#include "cpu/prepare.h"
#include "render/renderer.h"

namespace snell::cpu {

class CpuRenderer : public render::Renderer {
 public:
  render::Statistics Render(const scene::Scene& scene, const render::RenderRequest& request,
                            render::Film& film, Progress* progress, const StopFlag* stop) override;
};

// Render a scene that is prepared for the request's camera and settings, as often as wanted; adds to what preparing has
// told.
void RenderPrepared(const scene::Scene& scene, const PreparedScene& prepared,
                    const render::RenderRequest& request, render::Film& film, Progress* progress,
                    const StopFlag* stop, render::Statistics& statistics);

}  // namespace snell::cpu
