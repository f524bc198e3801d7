// SPDX-License-Identifier: Apache-2.0
//
// The second half of the build: the binary tree collapsed into nodes of eight children, leaves packed into
// triangle blocks and lists.
#pragma once

#include "bvh/build_binary.h"

namespace snell::bvh {

// The arrays that all trees of a BVH share.
struct WideArrays {
  HugeVector<WideNode> nodes;
  HugeVector<PairBlock> blocks;
  std::vector<std::uint32_t> shapes;  // of leaves
  HugeVector<PlacedTree> placed;      // instances of leaves
};

// Append a tree to the arrays; returns its root. `references` are in the order of the tree's leaves.
ChildRef AppendWideTree(const BinaryTree& tree, const HugeVector<PrimitiveRef>& references,
                        const Geometry& geometry, WideArrays& arrays);

}  // namespace snell::bvh
