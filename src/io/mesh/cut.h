// SPDX-License-Identifier: Apache-2.0
//
// Cuts a mesh's polygons into triangles. Concave polygons are cut rightly (polygon.h); quadrilaterals, by
// far the most frequent, along the diagonal that stays inside and, if both do, is the shorter one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace snell::io {

class FaceCutter {
 public:
  // Append the triangles of the face with these corners, at least three, in finite places. They index
  // corners: `firstCorner` is the face's first one, and the others follow it. Faces without any area may
  // give none.
  void Cut(std::span<const scene::vec3> places, std::uint32_t firstCorner,
           std::vector<scene::uvec3>& triangles);

  // Polygons so far whose outline crosses itself, and those cut as fans because the time that intricate
  // polygons may take, in all, was used up.
  std::uint64_t crossing() const { return crossing_; }
  std::uint64_t fans() const { return fans_; }

 private:
  std::uint64_t crossing_ = 0;
  std::uint64_t fans_ = 0;
  double workLeft_ = 4e9;  // squared corners: about ten seconds at worst
};

}  // namespace snell::io
