// SPDX-License-Identifier: Apache-2.0
//
// Polygons become triangles: by ear clipping (Meisters 1975, "Polygons have ears"; the bookkeeping that
// makes it quadratic is O'Rourke's, "Computational geometry in C", section 1.4). A convex polygon comes out
// as the fan around its first corner.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"

namespace snell::io {

// What TriangulatePolygon finds. `triangles` index the corners and are wound like the polygon.
struct PolygonTriangles {
  std::vector<scene::uvec3> triangles;  // none if the polygon has no area
  scene::vec3 normal{0.0f};  // unit length; the corners count counter-clockwise around it
  bool simple = true;        // false: the outline crosses itself, the triangles are a guess
};

// Split a flat polygon, convex or not, given by its corners in order. Takes time proportional to the number
// of corners times the number of reflex ones; callers limit the former. Corners must be finite.
PolygonTriangles TriangulatePolygon(std::span<const scene::vec3> corners);

}  // namespace snell::io
