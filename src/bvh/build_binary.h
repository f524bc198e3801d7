// SPDX-License-Identifier: Apache-2.0
//
// The first half of the build: a binary tree over boxes by the surface area heuristic on binned centroids
// (Wald 2007, "On fast construction of SAH-based bounding volume hierarchies"), in parallel, with the same
// result at any number of threads.
#pragma once

#include <cstdint>
#include <vector>

#include "bvh/bounds.h"
#include "bvh/node.h"

namespace snell::bvh {

// One primitive to be placed in the tree.
struct PrimitiveRef {
  vec3 lower;
  std::uint32_t id;
  vec3 upper;
  LeafKind kind;
};

// A node covers the references [first, first + count). It is a leaf if `right` is 0; else its left child is
// the next node and `right` the index of the other one.
struct BinaryNode {
  Bounds bounds;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t right = 0;
};

struct BinaryTree {
  std::vector<BinaryNode> nodes;  // the root is the first; unused ones lie between (count 0)
};

// Builds the tree and brings `references` into the order of its leaves. Every leaf holds primitives of one
// kind, at most `maxLeafPrimitives` of them. `references` must not be empty and all boxes must be finite.
BinaryTree BuildBinaryTree(std::vector<PrimitiveRef>& references, std::uint32_t maxLeafPrimitives);

}  // namespace snell::bvh
