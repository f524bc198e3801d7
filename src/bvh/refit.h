// SPDX-License-Identifier: Apache-2.0
//
// New boxes for a tree whose geometry has moved; what is in which leaf stays.
#pragma once

#include "bvh/build_wide.h"

namespace snell::bvh {

// Returns the tree's bounds. `treeBoxes` are the OuterBoxes of the trees that instances place.
Bounds RefitTree(ChildRef root, const Geometry& geometry,
                 const std::vector<std::vector<Bounds>>& treeBoxes, WideArrays& arrays);

}  // namespace snell::bvh
