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
  Refitter(const Geometry& geometry, const std::vector<Bounds>& treeBounds, WideArrays& arrays)
      : geometry_(geometry), treeBounds_(treeBounds), arrays_(arrays) {}

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
    for (std::uint32_t i = 0; i < CountOf(leaf); ++i) {
      const std::uint32_t item = arrays_.items[FirstOf(leaf) + i];
      if (KindOf(leaf) == LeafKind::Shapes) {
        box.Extend(BoxOf(ShapeBounds(geometry_.shapes[item])));
      } else {
        const kernel::Instance& instance = geometry_.instances[item];
        box.Extend(BoxOf(TransformedBounds(instance.toWorld, treeBounds_[instance.root])));
      }
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
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t place = k * BlockWidth + lane;
        box.Extend(Vec4{block.corner[0][place], block.corner[1][place], block.corner[2][place], 0});
      }
    }
    return box;
  }

  const Geometry& geometry_;
  const std::vector<Bounds>& treeBounds_;
  WideArrays& arrays_;
};

}  // namespace

Bounds RefitTree(ChildRef root, const Geometry& geometry, const std::vector<Bounds>& treeBounds,
                 WideArrays& arrays) {
  return BoundsOf(Refitter(geometry, treeBounds, arrays).Refit(root, 0));
}

}  // namespace snell::bvh
