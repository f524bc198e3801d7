// SPDX-License-Identifier: Apache-2.0
//
// What the builders sort: boxes of pairs of triangles, of shapes and of instances, in four-lane vectors whose
// last lanes carry what the box is of.
#pragma once

#include <bit>
#include <cstdint>

#include "bvh/bounds.h"
#include "bvh/huge_pages.h"
#include "bvh/node.h"

namespace snell::bvh {

// One thing to be placed in the tree: a triangle, alone or with a neighbour, a shape or an instance.
struct PrimitiveRef {
  Box box;

  PrimitiveRef() = default;
  PrimitiveRef(const Box& bounds, LeafKind kind, std::uint32_t first,
               std::uint32_t second = MaxTriangles)
      : box(bounds) {
    box.lower[3] = std::bit_cast<float>(first);
    box.upper[3] = std::bit_cast<float>(std::uint32_t(kind) << 30 | second);
  }
  LeafKind Kind() const { return LeafKind(std::bit_cast<std::uint32_t>(box.upper[3]) >> 30); }
  // The index of the shape, the instance or the first triangle.
  std::uint32_t First() const { return std::bit_cast<std::uint32_t>(box.lower[3]); }
  // The neighbour's index; MaxTriangles: there is none.
  std::uint32_t Second() const { return std::bit_cast<std::uint32_t>(box.upper[3]) & MaxTriangles; }
  // Twice the middle.
  Vec4 Centroid2() const { return box.lower + box.upper; }
};

// The triangles [first, first + count), paired along shared edges where a pair's box is no worse than two
// boxes. Adds the number of those that were left out, because a coordinate is not finite, to `dropped`.
HugeVector<PrimitiveRef> PairTriangles(const Geometry& geometry, std::uint32_t first,
                                       std::uint32_t count, std::uint64_t& dropped);

// The same triangles one by one, in boxes for all moments, of a mesh that changes its shape.
HugeVector<PrimitiveRef> DeformingTriangles(const Geometry& geometry, std::uint32_t first,
                                            std::uint32_t count, std::uint64_t& dropped);

// How two triangles share an edge: it runs from vertex `a` of the one to the next, and from vertex `b` of
// the other to the next in the opposite sense. `a` is 3 if they share none so.
struct SharedEdge {
  std::uint32_t a = 3;
  std::uint32_t b = 3;
};
inline SharedEdge FindSharedEdge(const kernel::Triangle& s, const kernel::Triangle& t) {
  const std::uint32_t p[4] = {s.v0, s.v1, s.v2, s.v0}, q[4] = {t.v0, t.v1, t.v2, t.v0};
  for (std::uint32_t a = 0; a < 3; ++a) {
    for (std::uint32_t b = 0; b < 3; ++b) {
      if (p[a] == q[b + 1] && p[a + 1] == q[b]) return {a, b};
    }
  }
  return {};
}

}  // namespace snell::bvh
