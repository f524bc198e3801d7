// SPDX-License-Identifier: Apache-2.0
//
// The memory layout of the BVH: wide nodes of eight children and leaves of triangle blocks, lists of
// analytic shapes or lists of instances. Plain data without pointers, so that it can be copied to a device.
#pragma once

#include <cstdint>

#include "kernel/math.h"

namespace snell::bvh {

using kernel::None;

// Where a child leads. Bit 31 marks a leaf; a leaf's bits 29–30 tell its kind, bits 25–28 its count less
// one, bits 0–24 where its first element is. An inner child is the index of its node.
using ChildRef = std::uint32_t;

enum class LeafKind : std::uint32_t { Triangles = 0, Shapes = 1, Instances = 2 };

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

// Bounds of eight children by axis: bounds[axis] are the lower and bounds[3 + axis] the upper ones. A
// missing child has inverted bounds, which only rays meet whose numbers overflow or are none; for their sake
// it is the leaf NoChild.
struct alignas(32) WideNode {
  float bounds[6][Width];
  ChildRef child[Width];
};

inline constexpr int BlockWidth = 4;

// Four triangles, vertex by vertex: vertex[3·i + axis]. A missing triangle is a point and has id None.
struct alignas(16) TriangleBlock {
  float vertex[9][BlockWidth];
  std::uint32_t id[BlockWidth];  // indices into the triangles
};

// The root of one tree, and how far its bounds reach from the origin along each axis.
struct Tree {
  ChildRef root = None;  // None: the tree is empty
  float reach[3] = {0, 0, 0};
  // The mask that all world triangles of the tree share, or MixedMask
  std::uint32_t triangleMask = 0;
};
inline constexpr std::uint32_t MixedMask = None;

}  // namespace snell::bvh
