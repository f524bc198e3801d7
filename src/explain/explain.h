// SPDX-License-Identifier: Apache-2.0
//
// Replays single samples of a render, bit for bit, by a compilation of the same kernel that tells what it does.
#pragma once

#include "cpu/prepare.h"
#include "explain/explanation.h"
#include "explain/names.h"
#include "render/renderer.h"

namespace snell::explain {

class Explainer {
 public:
  // Prepares the scene as a render of `request` does; the scene must outlive this. Throws Error.
  Explainer(const scene::Scene& scene, const render::RenderRequest& request);

  int width() const { return int(prepared_.flat().params.camera.resolution.x); }
  int height() const { return int(prepared_.flat().params.camera.resolution.y); }

  // How sample number `sample` of pixel (x, y), counted from the upper left corner, comes about.
  Explanation Explain(int x, int y, std::uint32_t sample) const;

 private:
  const scene::Scene& scene_;
  render::Statistics statistics_;
  render::Film film_;
  cpu::PreparedScene prepared_;
  Names names_;
};

}  // namespace snell::explain
