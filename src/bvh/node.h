// SPDX-License-Identifier: Apache-2.0
//
// The memory layout of the BVH: wide nodes of eight children and leaves of triangle blocks, lists of
// analytic shapes, of instances or of triangles that change their shape. Plain data without pointers, so that it can be copied to a device.
#pragma once

#include <cstdint>

#include "kernel/math.h"

namespace snell::bvh {

using kernel::None;

// Where a child leads. Bit 31 marks a leaf; a leaf's bits 29–30 tell its kind, bits 25–28 its count less
// one, bits 0–24 where its first element is. An inner child is the index of its node. A leaf of triangles is
// one block.
using ChildRef = std::uint32_t;

enum class LeafKind : std::uint32_t { Triangles = 0, Shapes = 1, Instances = 2, Deforming = 3 };

inline constexpr ChildRef LeafBit = 0x80000000u;
inline constexpr std::uint32_t MaxLeafElements = 16;
inline constexpr std::uint32_t MaxElementIndex = (1u << 25) - 1;

constexpr ChildRef LeafRef(LeafKind kind, std::uint32_t first, std::uint32_t count) {
  return LeafBit | std::uint32_t(kind) << 29 | (count - 1) << 25 | first;
}
constexpr bool IsLeaf(ChildRef ref) { return (ref & LeafBit) != 0; }
constexpr LeafKind KindOf(ChildRef leaf) { return LeafKind((leaf >> 29) & 3u); }
constexpr std::uint32_t CountOf(ChildRef leaf) { return ((leaf >> 25) & 15u) + 1; }
constexpr std::uint32_t FirstOf(ChildRef leaf) { return leaf & MaxElementIndex; }

// The first block holds no triangle.
inline constexpr ChildRef NoChild = LeafRef(LeafKind::Triangles, 0, 1);

inline constexpr int Width = 8;

// Bounds of eight children: planes[axis] are the eight lower bounds along the axis and then the eight upper
// ones times −1, so that rays treat both alike. A missing child has inverted bounds, which only rays meet
// whose numbers overflow or are none; for their sake it is the leaf NoChild. Children that are likely to stop
// a shadow ray cheaply come last.
struct alignas(64) WideNode {
  float planes[3][2 * Width];
  ChildRef child[Width];
  std::uint32_t unused[8];  // 0
};

inline constexpr int BlockWidth = 4;

// Four pairs of triangles that share an edge: corners p0 p1 p2 p3 are the triangles p0 p1 p2 and p0 p2 p3.
// corner[axis][4·k + lane] is corner k of the pair in that lane. A triangle without a partner has p3 = p2; the
// corners of a missing pair are NaN. Four cache lines.
struct alignas(64) PairBlock {
  float corner[3][4 * BlockWidth];
  // The triangles p0 p1 p2 of each lane, then those p0 p2 p3. Bits 0–29 are a triangle's index, bits 30–31
  // tell which of the three corners is its own first vertex. None: there is none.
  std::uint32_t id[2 * BlockWidth];
  // No smaller than the sizes of a lane's two triangles in kernel::StartsOnPlane
  float size[BlockWidth];
  std::uint32_t unused[4];  // 0
};
inline constexpr std::uint32_t MaxTriangles = (1u << 30) - 1;
constexpr std::uint32_t TriangleOf(std::uint32_t id) { return id & MaxTriangles; }
constexpr std::uint32_t TurnOf(std::uint32_t id) { return id >> 30; }

// A mesh's tree placed in the world, for rays on their way in: from kernel::Instance::toWorld the x of its
// three rows, their y, their z, and the origin. One cache line.
struct alignas(64) PlacedTree {
  float map[12];
  std::uint32_t tree;
  std::uint32_t instance;
  std::uint32_t mask;   // of the object
  std::uint32_t mover;  // the object if it moves, whose place the map is not; else None
};

// The root of one tree, and along each axis how far its bounds reach from the origin, times kernel::Gamma(8).
struct Tree {
  float slack[4] = {0, 0, 0, 0};
  ChildRef root = None;  // None: the tree is empty
  // The masks of the objects of the world's triangles: what all have in common, and what any has
  std::uint32_t commonMask = 0;
  std::uint32_t anyMask = 0;
  std::uint32_t deforms = 0;  // 1: of a mesh that changes its shape
};

}  // namespace snell::bvh
