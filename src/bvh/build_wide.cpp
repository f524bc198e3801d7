// SPDX-License-Identifier: Apache-2.0
#include "bvh/build_wide.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>

#include "bvh/blocks.h"
#include "util/check.h"
#include "util/error.h"

namespace snell::bvh {

namespace {

// Subtrees over more references are collapsed by tasks of their own.
constexpr std::uint32_t TaskSize = 4096;

// How much of each array a subtree takes.
struct Usage {
  std::uint32_t nodes = 0;
  std::uint32_t blocks = 0;
  std::uint32_t items = 0;

  Usage& operator+=(const Usage& other) {
    nodes += other.nodes;
    blocks += other.blocks;
    items += other.items;
    return *this;
  }
};

struct Children {
  std::uint32_t index[Width];
  std::uint32_t first[Width];  // where their references begin
  int count = 0;
};

class Collapser {
 public:
  Collapser(const BinaryTree& tree, const HugeVector<PrimitiveRef>& references,
            const Geometry& geometry, WideArrays& arrays)
      : tree_(tree), references_(references), geometry_(geometry), arrays_(arrays) {
    usages_.resize(tree.size());
  }

  ChildRef Collapse() {
    const Usage total = Plan(0, 0);
    Usage start{std::uint32_t(arrays_.nodes.size()), std::uint32_t(arrays_.blocks.size()),
                std::uint32_t(arrays_.items.size())};
    const std::uint64_t elements = std::max(std::uint64_t(start.blocks) + total.blocks,
                                            std::uint64_t(start.items) + total.items);
    if (elements > MaxElementIndex)
      throw Error(fmt::format("the scene has more geometry than a BVH holds ({} leaf elements)",
                              MaxElementIndex));
    arrays_.nodes.resize(start.nodes + total.nodes);
    arrays_.blocks.resize(start.blocks + total.blocks);
    arrays_.items.resize(start.items + total.items);
    ChildRef root = NoChild;
    Emit(0, 0, start, root);
    return root;
  }

 private:
  // Open the inner child of the largest area until there are eight.
  Children ChildrenOf(std::uint32_t parent, std::uint32_t firstReference) const {
    Children children;
    const auto add = [&](int at, std::uint32_t index, std::uint32_t first) {
      children.index[at] = index;
      children.first[at] = first;
    };
    float areas[Width];
    const auto measure = [&](int at) {
      const BinaryNode& node = tree_[children.index[at]];
      areas[at] = node.IsLeaf() ? -1.0f : node.box.HalfArea();
    };
    add(0, parent + 1, firstReference);
    add(1, tree_[parent].Right(), firstReference + tree_[parent + 1].Count());
    measure(0);
    measure(1);
    children.count = 2;
    while (children.count < Width) {
      const int largest = int(std::max_element(areas, areas + children.count) - areas);
      if (areas[largest] < 0.0f) break;
      const std::uint32_t opened = children.index[largest], first = children.first[largest];
      add(largest, opened + 1, first);
      add(children.count, tree_[opened].Right(), first + tree_[opened + 1].Count());
      measure(largest);
      measure(children.count++);
    }
    return children;
  }

  // What a subtree will take.
  Usage Plan(std::uint32_t index, std::uint32_t firstReference) {
    Usage usage;
    const BinaryNode& node = tree_[index];
    if (node.IsLeaf()) {
      if (references_[firstReference].Kind() == LeafKind::Triangles) {
        usage.blocks = 1;
      } else {
        usage.items = node.Count();
      }
      return usage;
    }
    const Children children = ChildrenOf(index, firstReference);
    usage.nodes = 1;
    if (node.Count() > TaskSize) {
      Usage parts[Width];
      tbb::parallel_for(0, children.count,
                        [&](int i) { parts[i] = Plan(children.index[i], children.first[i]); });
      for (int i = 0; i < children.count; ++i) usage += parts[i];
    } else {
      for (int i = 0; i < children.count; ++i) usage += Plan(children.index[i], children.first[i]);
    }
    return usages_[index] = usage;
  }

  // Write a subtree to its place. Returns its surface, the sum over its primitives.
  float Emit(std::uint32_t index, std::uint32_t firstReference, Usage start, ChildRef& ref) {
    const BinaryNode& node = tree_[index];
    if (node.IsLeaf()) {
      const LeafKind kind = references_[firstReference].Kind();
      if (kind == LeafKind::Triangles) {
        ref = LeafRef(kind, start.blocks, 1);
        return PackBlock(start.blocks, firstReference, node.Count());
      }
      ref = LeafRef(kind, start.items, node.Count());
      for (std::uint32_t i = 0; i < node.Count(); ++i)
        arrays_.items[start.items + i] = references_[firstReference + i].First();
      return node.box.HalfArea();
    }

    const Children children = ChildrenOf(index, firstReference);
    ref = start.nodes++;
    Usage starts[Width];
    for (int i = 0; i < children.count; ++i) {
      starts[i] = start;
      const BinaryNode& child = tree_[children.index[i]];
      if (!child.IsLeaf()) {
        start += usages_[children.index[i]];
      } else if (references_[children.first[i]].Kind() == LeafKind::Triangles) {
        ++start.blocks;
      } else {
        start.items += child.Count();
      }
    }
    ChildRef refs[Width];
    float surfaces[Width];
    const auto emit = [&](int i) {
      surfaces[i] = Emit(children.index[i], children.first[i], starts[i], refs[i]);
    };
    if (node.Count() > TaskSize) {
      tbb::parallel_for(0, children.count, emit);
    } else {
      for (int i = 0; i < children.count; ++i) emit(i);
    }

    // Put first what is likely to stop a shadow ray at little cost
    int order[Width];
    float worth[Width];
    float surface = 0;
    for (int i = 0; i < children.count; ++i) {
      order[i] = i;
      const BinaryNode& child = tree_[children.index[i]];
      worth[i] =
          std::min(surfaces[i], child.box.HalfArea()) / (1.0f + std::log2(float(child.Count())));
      surface += surfaces[i];
    }
    for (int i = 1; i < children.count; ++i) {
      for (int j = i; j > 0 && worth[order[j - 1]] < worth[order[j]]; --j)
        std::swap(order[j - 1], order[j]);
    }
    WideNode& wide = arrays_.nodes[ref];
    for (int i = 0; i < Width; ++i) {
      const bool missing = i >= children.count;
      SetChildBox(wide, i, missing ? Box() : tree_[children.index[order[i]]].box);
      wide.child[i] = missing ? NoChild : refs[order[i]];
    }
    std::ranges::fill(wide.unused, 0u);
    return surface;
  }

  // Returns the pairs' area.
  float PackBlock(std::uint32_t place, std::uint32_t first, std::uint32_t count) {
    PairBlock& block = arrays_.blocks[place];
    ClearBlock(block);
    float area = 0;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const PrimitiveRef& ref = references_[first + lane];
      area += PackPair(block, lane, ref.First(), ref.Second(), geometry_);
    }
    return area;
  }

  const BinaryTree& tree_;
  const HugeVector<PrimitiveRef>& references_;
  const Geometry& geometry_;
  WideArrays& arrays_;
  HugeVector<Usage> usages_;
};

}  // namespace

ChildRef AppendWideTree(const BinaryTree& tree, const HugeVector<PrimitiveRef>& references,
                        const Geometry& geometry, WideArrays& arrays) {
  if (arrays.blocks.empty()) {
    // The block that missing children lead to
    arrays.blocks.resize(1);
    ClearBlock(arrays.blocks[0]);
  }
  return Collapser(tree, references, geometry, arrays).Collapse();
}

}  // namespace snell::bvh
