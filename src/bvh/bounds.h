// SPDX-License-Identifier: Apache-2.0
//
// Axis-aligned boxes, and the boxes of the primitives.
#pragma once

#include <algorithm>
#include <limits>

#include "bvh/geometry.h"
#include "kernel/transform.h"

namespace snell::bvh {

using kernel::vec3;

// Empty until extended.
struct Bounds {
  vec3 lower{std::numeric_limits<float>::infinity()};
  vec3 upper{-std::numeric_limits<float>::infinity()};

  void Extend(vec3 p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
  void Extend(const Bounds& b) {
    lower = {std::min(lower.x, b.lower.x), std::min(lower.y, b.lower.y),
             std::min(lower.z, b.lower.z)};
    upper = {std::max(upper.x, b.upper.x), std::max(upper.y, b.upper.y),
             std::max(upper.z, b.upper.z)};
  }
  bool Empty() const { return !(lower.x <= upper.x); }
  bool Finite() const {
    const vec3 sum = kernel::Abs(lower) + kernel::Abs(upper);
    return sum.x + sum.y + sum.z < std::numeric_limits<float>::max();
  }
  vec3 Center() const { return (lower + upper) * 0.5f; }
  vec3 Size() const { return upper - lower; }
  // Half the surface area.
  float HalfArea() const {
    const vec3 s = Size();
    return s.x * (s.y + s.z) + s.y * s.z;
  }
};

// Not finite if a vertex is not.
Bounds TriangleBounds(const Geometry& geometry, std::uint32_t triangle);

// The box of an analytic shape, wide enough for rounding. Not finite for infinite planes.
Bounds ShapeBounds(const kernel::Shape& shape);

// The box of a box after an affine map, wide enough for rounding.
Bounds TransformedBounds(const kernel::Transform& transform, const Bounds& local);

}  // namespace snell::bvh
