// SPDX-License-Identifier: Apache-2.0
#include "bvh/build_wide.h"

#include <fmt/format.h>

#include <limits>

#include "util/check.h"
#include "util/error.h"

namespace snell::bvh {

namespace {

class Collapser {
 public:
  Collapser(const BinaryTree& tree, const std::vector<PrimitiveRef>& references,
            const Geometry& geometry, WideArrays& arrays)
      : tree_(tree), references_(references), geometry_(geometry), arrays_(arrays) {}

  ChildRef Collapse(std::uint32_t index) {
    const BinaryNode& node = tree_.nodes[index];
    if (node.right == 0) return PackLeaf(node);

    // Open the inner child of the largest area until there are eight
    std::uint32_t children[Width] = {index + 1, node.right};
    int count = 2;
    while (count < Width) {
      int largest = -1;
      float largestArea = -1.0f;
      for (int i = 0; i < count; ++i) {
        const BinaryNode& child = tree_.nodes[children[i]];
        if (child.right != 0 && child.bounds.HalfArea() > largestArea) {
          largest = i;
          largestArea = child.bounds.HalfArea();
        }
      }
      if (largest < 0) break;
      const std::uint32_t opened = children[largest];
      children[largest] = opened + 1;
      children[count++] = tree_.nodes[opened].right;
    }

    // Reserve the place first, so that parents come before their children
    const std::uint32_t place = std::uint32_t(arrays_.nodes.size());
    CHECK(place < LeafBit);
    arrays_.nodes.push_back(EmptyNode());
    for (int i = 0; i < count; ++i) {
      const Bounds& bounds = tree_.nodes[children[i]].bounds;
      const ChildRef ref = Collapse(children[i]);
      WideNode& wide = arrays_.nodes[place];
      for (int axis = 0; axis < 3; ++axis) {
        wide.bounds[axis][i] = bounds.lower[axis];
        wide.bounds[3 + axis][i] = bounds.upper[axis];
      }
      wide.child[i] = ref;
    }
    return place;
  }

 private:
  static WideNode EmptyNode() {
    WideNode node;
    for (int i = 0; i < Width; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        node.bounds[axis][i] = std::numeric_limits<float>::infinity();
        node.bounds[3 + axis][i] = -std::numeric_limits<float>::infinity();
      }
      node.child[i] = NoChild;
    }
    return node;
  }

  ChildRef PackLeaf(const BinaryNode& leaf) {
    const LeafKind kind = references_[leaf.first].kind;
    if (kind == LeafKind::Triangles) return PackTriangles(leaf);
    const std::size_t first = arrays_.items.size();
    CheckIndex(first + leaf.count);
    for (std::uint32_t i = 0; i < leaf.count; ++i)
      arrays_.items.push_back(references_[leaf.first + i].id);
    return LeafRef(kind, std::uint32_t(first), leaf.count);
  }

  ChildRef PackTriangles(const BinaryNode& leaf) {
    const std::uint32_t blockCount = (leaf.count + BlockWidth - 1) / BlockWidth;
    const std::size_t first = arrays_.blocks.size();
    CheckIndex(first + blockCount);
    for (std::uint32_t b = 0; b < blockCount; ++b) {
      TriangleBlock block = {};
      for (std::uint32_t lane = 0; lane < BlockWidth; ++lane) {
        const std::uint32_t i = b * BlockWidth + lane;
        block.id[lane] = None;
        if (i >= leaf.count) continue;
        block.id[lane] = references_[leaf.first + i].id;
        const kernel::Triangle& triangle = geometry_.triangles[block.id[lane]];
        const vec3 p[3] = {geometry_.positions[triangle.v0], geometry_.positions[triangle.v1],
                           geometry_.positions[triangle.v2]};
        for (int v = 0; v < 3; ++v) {
          for (int axis = 0; axis < 3; ++axis) block.vertex[3 * v + axis][lane] = p[v][axis];
        }
      }
      arrays_.blocks.push_back(block);
    }
    return LeafRef(LeafKind::Triangles, std::uint32_t(first), blockCount);
  }

  static void CheckIndex(std::size_t end) {
    if (end > MaxElementIndex)
      throw Error(fmt::format("the scene has more geometry than a BVH holds ({} leaf elements)",
                              MaxElementIndex));
  }

  const BinaryTree& tree_;
  const std::vector<PrimitiveRef>& references_;
  const Geometry& geometry_;
  WideArrays& arrays_;
};

}  // namespace

ChildRef AppendWideTree(const BinaryTree& tree, const std::vector<PrimitiveRef>& references,
                        const Geometry& geometry, WideArrays& arrays) {
  // The block that missing children lead to
  if (arrays.blocks.empty()) arrays.blocks.push_back({{}, {None, None, None, None}});
  return Collapser(tree, references, geometry, arrays).Collapse(0);
}

}  // namespace snell::bvh
