// SPDX-License-Identifier: Apache-2.0
#include "bvh/refit.h"

#include <tbb/parallel_for.h>

#include "bvh/blocks.h"

namespace snell::bvh {

namespace {

// Down to this depth, children are refitted by several threads.
constexpr int ParallelDepth = 4;

class Refitter {
 public:
  Refitter(const Geometry& geometry, const std::vector<std::vector<Bounds>>& treeBoxes,
           WideArrays& arrays)
      : geometry_(geometry), treeBoxes_(treeBoxes), arrays_(arrays) {}

  Box Refit(ChildRef ref, int depth) {
    if (IsLeaf(ref)) return RefitLeaf(ref);
    WideNode& node = arrays_.nodes[ref];
    Box boxes[Width];
    const auto refitChild = [&](int i) { boxes[i] = Refit(node.child[i], depth + 1); };
    if (depth < ParallelDepth) {
      tbb::parallel_for(0, Width, refitChild);
    } else {
      for (int i = 0; i < Width; ++i) refitChild(i);
    }
    Box all;
    for (int i = 0; i < Width; ++i) {
      SetChildBox(node, i, boxes[i]);
      all.Extend(boxes[i]);
    }
    return all;
  }

 private:
  Box RefitLeaf(ChildRef leaf) {
    Box box;
    if (leaf == NoChild) return box;
    if (KindOf(leaf) == LeafKind::Triangles) return RefitBlock(arrays_.blocks[FirstOf(leaf)]);
    for (std::uint32_t i = FirstOf(leaf); i < FirstOf(leaf) + CountOf(leaf); ++i) {
      Bounds bounds;
      if (KindOf(leaf) == LeafKind::Shapes) {
        bounds = PlacedBounds(geometry_, geometry_.shapes[arrays_.shapes[i]]);
      } else if (KindOf(leaf) == LeafKind::Deforming) {
        bounds = TriangleBounds(geometry_, arrays_.shapes[i]);
      } else {
        PlacedTree& placed = arrays_.placed[i];
        PackInstance(placed, placed.instance, geometry_);
        bounds =
            PlacedBounds(geometry_, geometry_.instances[placed.instance], treeBoxes_[placed.tree]);
      }
      if (bounds.Finite()) box.Extend(BoxOf(bounds));
    }
    return box;
  }

  Box RefitBlock(PairBlock& block) {
    Box box;
    for (std::uint32_t lane = 0; lane < BlockWidth; ++lane) {
      const std::uint32_t first = block.id[lane], second = block.id[BlockWidth + lane];
      if (first == None) continue;
      PackPair(block, lane, TriangleOf(first), second == None ? MaxTriangles : TriangleOf(second),
               geometry_);
      for (const std::uint32_t id : {first, second}) {
        if (id == None) continue;
        const Bounds bounds = TriangleBounds(geometry_, TriangleOf(id));
        if (bounds.Finite()) box.Extend(BoxOf(bounds));
      }
    }
    return box;
  }

  const Geometry& geometry_;
  const std::vector<std::vector<Bounds>>& treeBoxes_;
  WideArrays& arrays_;
};

}  // namespace

Bounds RefitTree(ChildRef root, const Geometry& geometry,
                 const std::vector<std::vector<Bounds>>& treeBoxes, WideArrays& arrays) {
  return BoundsOf(Refitter(geometry, treeBoxes, arrays).Refit(root, 0));
}

}  // namespace snell::bvh
