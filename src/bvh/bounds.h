// SPDX-License-Identifier: Apache-2.0
//
// Axis-aligned boxes, as points and as vectors, and the boxes of the primitives.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

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
    // Sums and differences of such boxes' corners must not overflow either
    return sum.x + sum.y + sum.z < std::numeric_limits<float>::max() / 16;
  }
  vec3 Center() const { return (lower + upper) * 0.5f; }
  vec3 Size() const { return upper - lower; }
  // Half the surface area.
  float HalfArea() const {
    const vec3 s = Size();
    return s.x * (s.y + s.z) + s.y * s.z;
  }
};

// x, y, z and a lane to spare.
using Vec4 = float __attribute__((vector_size(16)));

inline Vec4 Min(Vec4 a, Vec4 b) { return a < b ? a : b; }
inline Vec4 Max(Vec4 a, Vec4 b) { return a > b ? a : b; }

// Empty until extended. What the fourth lanes hold does not matter.
struct Box {
  Vec4 lower = Vec4{} + std::numeric_limits<float>::infinity();
  Vec4 upper = Vec4{} - std::numeric_limits<float>::infinity();

  void Extend(const Box& box) {
    lower = Min(lower, box.lower);
    upper = Max(upper, box.upper);
  }
  void Extend(Vec4 p) {
    lower = Min(lower, p);
    upper = Max(upper, p);
  }
  // Half the surface area.
  float HalfArea() const {
    const Vec4 s = upper - lower;
    return s[0] * (s[1] + s[2]) + s[1] * s[2];
  }
};

inline Box BoxOf(const Bounds& bounds) {
  Box box;
  box.lower = Vec4{bounds.lower.x, bounds.lower.y, bounds.lower.z, 0};
  box.upper = Vec4{bounds.upper.x, bounds.upper.y, bounds.upper.z, 0};
  return box;
}
inline Bounds BoundsOf(const Box& box) {
  return {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
}

// Holds it at all moments if its mesh changes its shape. Not finite if a vertex is not.
Bounds TriangleBounds(const Geometry& geometry, std::uint32_t triangle);

// The box of an analytic shape, wide enough for rounding. Not finite for infinite planes. Of one that moves: in its
// object's space.
Bounds ShapeBounds(const kernel::Shape& shape);

// The box of a box after an affine map, wide enough for rounding.
Bounds TransformedBounds(const kernel::Transform& transform, const Bounds& local);
// The same for several boxes together, which is tighter than the box of the box around them.
Bounds TransformedBounds(const kernel::Transform& transform, std::span<const Bounds> parts);

// The boxes of shapes and instances in the world, which hold those that move from the first to the last moment.
Bounds PlacedBounds(const Geometry& geometry, const kernel::Shape& shape);
Bounds PlacedBounds(const Geometry& geometry, const kernel::Instance& instance,
                    std::span<const Bounds> parts);

}  // namespace snell::bvh
