// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/cut.h"

#include <glm/geometric.hpp>

#include "io/mesh/polygon.h"

namespace snell::io {
namespace {

using glm::dvec3;
using scene::uvec3;
using scene::vec3;

// Whether a quadrilateral is to be cut from corner 1 to 3 instead of from 0 to 2.
bool CutsFromOneToThree(std::span<const vec3> places) {
  const dvec3 a(places[0]), b(places[1]), c(places[2]), d(places[3]);
  const dvec3 normal = glm::cross(c - a, d - b);

  // A diagonal lies inside if both of its triangles face the way the quadrilateral does
  const auto facesAlong = [&](const dvec3& p, const dvec3& q, const dvec3& r) {
    return glm::dot(glm::cross(q - p, r - p), normal) > 0;
  };
  const bool fromZero = facesAlong(a, b, c) && facesAlong(a, c, d);
  const bool fromOne = facesAlong(a, b, d) && facesAlong(b, c, d);
  if (fromZero != fromOne) return fromOne;

  // Rounding of equal diagonals must not make a pattern in a regular grid
  return glm::dot(d - b, d - b) < 0.999 * glm::dot(c - a, c - a);
}

}  // namespace

void FaceCutter::Cut(std::span<const vec3> places, std::uint32_t firstCorner,
                     std::vector<uvec3>& triangles) {
  const std::size_t count = places.size();
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles.push_back(uvec3(firstCorner + a, firstCorner + b, firstCorner + c));
  };

  if (count == 3) {
    add(0, 1, 2);
  } else if (count == 4 && CutsFromOneToThree(places)) {
    add(0, 1, 3);
    add(1, 2, 3);
  } else if (count == 4) {
    add(0, 1, 2);
    add(0, 2, 3);
  } else if (workLeft_ -= double(count) * double(count); workLeft_ < 0) {
    for (std::uint32_t i = 2; i < count; ++i) add(0, i - 1, i);
    ++fans_;
  } else {
    const PolygonTriangles cut = TriangulatePolygon(places);
    for (const uvec3& triangle : cut.triangles) add(triangle.x, triangle.y, triangle.z);
    if (!cut.simple) ++crossing_;
  }
}

}  // namespace snell::io
