// SPDX-License-Identifier: Apache-2.0
//
// Which vertices of a mesh lie at the same place: seams of texture coordinates and hard edges make several
// vertices of what is one point of the surface.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace snell::scene {

// The bits of a coordinate; of both zeros those of +0. Unlike by ==, NaNs can be equal, so that a table
// of them does not grow without bounds.
inline std::uint32_t CoordinateBits(float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); }

inline uvec3 PositionBits(const vec3& p) {
  return {CoordinateBits(p.x), CoordinateBits(p.y), CoordinateBits(p.z)};
}

// The place of each vertex: the number of the first vertex that lies there.
std::vector<std::uint32_t> FindPlaces(const std::vector<vec3>& positions);

}  // namespace snell::scene
