// SPDX-License-Identifier: Apache-2.0
//
// Filling the elements of the layout (node.h).
#pragma once

#include "bvh/node.h"
#include "bvh/references.h"

namespace snell::bvh {

// Four missing pairs.
void ClearBlock(PairBlock& block);

// Put a triangle and, unless it is MaxTriangles, its neighbour into a lane. Returns their area.
float PackPair(PairBlock& block, std::uint32_t lane, std::uint32_t first, std::uint32_t second,
               const Geometry& geometry);

// Place an instance's tree.
void PackInstance(PlacedTree& placed, std::uint32_t instance, const Geometry& geometry);

inline void SetChildBox(WideNode& node, int child, const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    node.planes[axis][child] = box.lower[axis] + 0.0f;  // no −0
    node.planes[axis][Width + child] = 0.0f - box.upper[axis];
  }
}

// The box of a child; empty if it is missing.
inline Bounds ChildBounds(const WideNode& node, int child) {
  const auto lower = [&](int axis) { return node.planes[axis][child]; };
  const auto upper = [&](int axis) { return -node.planes[axis][Width + child]; };
  return {{lower(0), lower(1), lower(2)}, {upper(0), upper(1), upper(2)}};
}

// At most 64 boxes that hold all of a tree whose bounds are given.
std::vector<Bounds> OuterBoxes(ChildRef root, const Bounds& bounds,
                               const HugeVector<WideNode>& nodes);

}  // namespace snell::bvh
