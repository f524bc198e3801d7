// SPDX-License-Identifier: Apache-2.0
//
// What options ask of a render, with what the scene says for the rest.
#pragma once

#include <cstdint>
#include <utility>

#include "api/render.h"
#include "render/renderer.h"

namespace snell {

// With the number of the first sample; without conditions to stop, films and checkpoints. Throws Error if there is no
// such camera, AOV …, or a number is out of range.
std::pair<render::RenderRequest, std::uint32_t> RequestOf(const scene::Scene& scene,
                                                          const RenderOptions& options);

}  // namespace snell
