// SPDX-License-Identifier: Apache-2.0
//
// The CPU as a device: all cores, through oneTBB, with the same picture bit for bit at any number of them.
#pragma once

#include "render/renderer.h"

namespace snell::cpu {

class CpuRenderer : public render::Renderer {
 public:
  render::Statistics Render(const scene::Scene& scene, const render::RenderRequest& request,
                            render::Film& film, Progress* progress, const StopFlag* stop) override;
};

}  // namespace snell::cpu
