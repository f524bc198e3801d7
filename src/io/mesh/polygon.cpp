// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/polygon.h"

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>

namespace snell::io {
namespace {

using glm::dvec2;
using glm::dvec3;
using scene::uvec3;
using scene::vec3;

// The sum of the cross products of successive corners: twice the area, along the normal (Newell's method).
// Corners are taken relative to the first one, so that distance from the origin costs no precision.
dvec3 AreaVector(std::span<const vec3> corners) {
  const dvec3 origin(corners[0]);
  dvec3 sum(0.0);
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += glm::cross(dvec3(corners[i - 1]) - origin, dvec3(corners[i]) - origin);
  return sum;
}

// The corners seen along the normal's largest axis, so that they count counter-clockwise.
std::vector<dvec2> Flatten(std::span<const vec3> corners, const dvec3& normal) {
  const dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<dvec2> points;
  points.reserve(corners.size());
  for (const vec3& corner : corners)
    points.emplace_back(double(corner[u]) - double(corners[0][u]),
                        double(corner[v]) - double(corners[0][v]));
  return points;
}

// Twice the area of a triangle, positive if it turns left.
double Turn(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Cuts ears off a polygon until three corners are left. Cutting one only makes the inside smaller, so a
// corner's being an ear can change only beside the cut.
class EarClipper {
 public:
  // `points` are the corners as seen along the polygon's normal.
  EarClipper(std::span<const vec3> places, std::vector<dvec2> points)
      : places_(places), points_(std::move(points)) {
    const std::uint32_t count = std::uint32_t(points_.size());
    corners_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      corners_[i].before = i == 0 ? count - 1 : i - 1;
      corners_[i].after = i + 1 == count ? 0 : i + 1;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      corners_[i].reflex = TurnAt(i) <= 0;
      if (corners_[i].reflex) reflex_.push_back(i);
    }
    for (std::uint32_t i = 0; i < count; ++i) corners_[i].ear = IsEar(i);
  }

  void Clip(PolygonTriangles& result) {
    std::uint32_t at = 1;
    std::size_t left = points_.size();
    std::size_t fruitless = 0;
    while (left > 3) {
      if (!corners_[at].ear) {
        at = corners_[at].after;
        if (++fruitless < left) continue;
        at = Leftover(at, result);
      }
      const std::uint32_t after = corners_[at].after;
      Cut(at, result);
      at = after;
      --left;
      fruitless = 0;
    }
    if (TurnAt(at) < 0) result.simple = false;
    if (HasArea(at)) Emit(at, result);
  }

 private:
  struct Corner {
    std::uint32_t before = 0;
    std::uint32_t after = 0;
    bool reflex = false;  // or straight
    bool ear = false;
  };

  double TurnAt(std::uint32_t i) const {
    return Turn(points_[corners_[i].before], points_[i], points_[corners_[i].after]);
  }

  // Whether there is a triangle at a corner, also one seen from its edge, as in a polygon that is not flat.
  bool HasArea(std::uint32_t i) const {
    if (TurnAt(i) != 0) return true;
    const dvec3 a = dvec3(places_[corners_[i].before]) - dvec3(places_[i]);
    const dvec3 b = dvec3(places_[corners_[i].after]) - dvec3(places_[i]);
    return glm::length(glm::cross(a, b)) > 1e-5 * (glm::dot(a, a) + glm::dot(b, b));
  }

  // An ear is a convex corner whose triangle contains no other corner. Only reflex ones need a look, and
  // not those that touch a corner of the triangle, as where a cut joins a hole to the outline.
  bool IsEar(std::uint32_t i) const {
    const dvec2 a = points_[corners_[i].before], b = points_[i], c = points_[corners_[i].after];
    if (Turn(a, b, c) <= 0) return false;
    for (const std::uint32_t other : reflex_) {
      const dvec2 p = points_[other];
      if (!corners_[other].reflex || p == a || p == b || p == c) continue;
      if (Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  // The corner to cut where a full round found no ear: a straight one, which takes no area with it; else the
  // outline crosses itself, and any that turns left has to do.
  std::uint32_t Leftover(std::uint32_t at, PolygonTriangles& result) const {
    std::uint32_t convex = at;
    std::uint32_t i = at;
    do {
      const double turn = TurnAt(i);
      if (turn == 0) return i;
      if (turn > 0) convex = i;
      i = corners_[i].after;
    } while (i != at);
    result.simple = false;
    return convex;
  }

  void Emit(std::uint32_t i, PolygonTriangles& result) const {
    result.triangles.push_back(uvec3(corners_[i].before, i, corners_[i].after));
  }

  void Cut(std::uint32_t i, PolygonTriangles& result) {
    if (HasArea(i)) Emit(i, result);
    const std::uint32_t before = corners_[i].before, after = corners_[i].after;
    corners_[before].after = after;
    corners_[after].before = before;
    corners_[i].reflex = false;
    corners_[i].ear = false;
    for (const std::uint32_t neighbour : {before, after})
      corners_[neighbour].reflex = corners_[neighbour].reflex && TurnAt(neighbour) <= 0;
    for (const std::uint32_t neighbour : {before, after})
      corners_[neighbour].ear = IsEar(neighbour);
  }

  std::span<const vec3> places_;
  std::vector<dvec2> points_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> reflex_;  // those that were so at the start
};

}  // namespace

PolygonTriangles TriangulatePolygon(std::span<const vec3> corners) {
  PolygonTriangles result;
  if (corners.size() < 3) return result;
  const dvec3 area = AreaVector(corners);
  const double length = glm::length(area);
  if (!(length > 0)) return result;
  result.normal = vec3(area / length);

  if (corners.size() == 3) {
    result.triangles.push_back(uvec3(0, 1, 2));
  } else {
    result.triangles.reserve(corners.size() - 2);
    EarClipper(corners, Flatten(corners, area)).Clip(result);
  }
  return result;
}

}  // namespace snell::io
