// SPDX-License-Identifier: Apache-2.0
//
// Improves a binary tree by taking subtrees out and putting them back where the tree's surface area becomes
// least (Meister and Bittner 2018, "Parallel reinsertion for bounding volume hierarchy optimization").
#pragma once

#include "bvh/build_binary.h"

namespace snell::bvh {

// Changes the tree and brings `references` into the new order of its leaves. The result does not depend on
// the number of threads.
void ReinsertSubtrees(BinaryTree& tree, HugeVector<PrimitiveRef>& references);

}  // namespace snell::bvh
