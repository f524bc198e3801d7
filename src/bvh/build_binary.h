// SPDX-License-Identifier: Apache-2.0
//
// The first half of the build: a binary tree over boxes by the surface area heuristic on binned centroids
// (Wald 2007, "On fast construction of SAH-based bounding volume hierarchies"), in parallel, with the same
// result at any number of threads.
#pragma once

#include <cstdint>

#include "bvh/references.h"

namespace snell::bvh {

// A node covers the references [first, first + count); those of its left child come first. Siblings lie side
// by side, the left one at an even place.
struct BinaryNode {
  Box box;

  std::uint32_t Count() const { return std::bit_cast<std::uint32_t>(box.lower[3]); }
  // The left child; 0: a leaf.
  std::uint32_t Left() const { return std::bit_cast<std::uint32_t>(box.upper[3]); }
  std::uint32_t Right() const { return Left() + 1; }
  bool IsLeaf() const { return Left() == 0; }
  void Set(const Box& bounds, std::uint32_t count, std::uint32_t left) {
    box = bounds;
    box.lower[3] = std::bit_cast<float>(count);
    box.upper[3] = std::bit_cast<float>(left);
  }
};

// The root is the first node; some places are unused. Where in the array a node lies may differ from one build
// to the next, but not how the nodes hang together.
using BinaryTree = HugeVector<BinaryNode>;

// Pairs of triangles, shapes or instances in one leaf, at most.
inline constexpr std::uint32_t MaxLeafCount = BlockWidth;

// Builds the tree and brings `references` into the order of its leaves. Every leaf holds primitives of one
// kind, at most MaxLeafCount of them. `references` must not be empty and all boxes must be finite.
BinaryTree BuildBinaryTree(HugeVector<PrimitiveRef>& references);

}  // namespace snell::bvh
