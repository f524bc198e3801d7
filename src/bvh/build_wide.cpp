// SPDX-License-Identifier: Apache-2.0
#include "bvh/build_wide.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <vector>

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
  std::uint32_t shapes = 0;
  std::uint32_t placed = 0;

  Usage& operator+=(const Usage& other) {
    nodes += other.nodes;
    blocks += other.blocks;
    shapes += other.shapes;
    placed += other.placed;
    return *this;
  }
};

// How many of i + 1 places the left child gets; 0: the node is better not opened.
struct Choice {
  std::uint8_t toLeft[Width];
};

// What the tasks that write a subtree must know beforehand: where its parts begin. Small subtrees have no parts.
struct Layout {
  Usage usage;
  std::vector<Layout> parts;
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
    choices_.resize(tree.size());
    leastArea_ = std::max(tree[0].box.HalfArea() * 1e-9f, 1e-30f);
  }

  ChildRef Collapse() {
    Choose(0);
    const Layout layout = Plan(0, 0);
    const Usage& total = layout.usage;
    Usage start{std::uint32_t(arrays_.nodes.size()), std::uint32_t(arrays_.blocks.size()),
                std::uint32_t(arrays_.shapes.size()), std::uint32_t(arrays_.placed.size())};
    const std::uint64_t elements = std::max({std::uint64_t(start.blocks) + total.blocks,
                                             std::uint64_t(start.shapes) + total.shapes,
                                             std::uint64_t(start.placed) + total.placed});
    if (elements > MaxElementIndex)
      throw Error(fmt::format("the scene has more geometry than a BVH holds ({} leaf elements)",
                              MaxElementIndex));
    arrays_.nodes.resize(start.nodes + total.nodes);
    arrays_.blocks.resize(start.blocks + total.blocks);
    arrays_.shapes.resize(start.shapes + total.shapes);
    arrays_.placed.resize(start.placed + total.placed);
    ChildRef root = NoChild;
    Emit(0, 0, layout, start, root);
    return root;
  }

 private:
  // The least sum of the areas of wide nodes that a subtree needs if it may be up to i + 1 children of the
  // node above it.
  struct Areas {
    float at[Width];
  };

  // Find the best way to put a subtree's nodes together (after Ylitie, Karras and Laine 2017, "Efficient
  // incoherent ray traversal on GPUs through compressed wide BVHs", section 3.1).
  Areas Choose(std::uint32_t index) {
    const BinaryNode& node = tree_[index];
    if (node.IsLeaf()) return {};
    Areas left, right;
    const auto chooseLeft = [&] { left = Choose(node.Left()); };
    const auto chooseRight = [&] { right = Choose(node.Right()); };
    if (node.Count() > TaskSize) {
      tbb::parallel_invoke(chooseLeft, chooseRight);
    } else {
      chooseLeft();
      chooseRight();
    }
    Areas opened;
    Choice& choice = choices_[index];
    for (int i = 1; i < Width; ++i) {
      // Areas may be infinite, all of them
      opened.at[i] = left.at[0] + right.at[i - 1];
      choice.toLeft[i] = 1;
      for (int toLeft = 1; toLeft < i; ++toLeft) {
        const float area = left.at[toLeft] + right.at[i - 1 - toLeft];
        if (area < opened.at[i]) {
          opened.at[i] = area;
          choice.toLeft[i] = std::uint8_t(toLeft + 1);
        }
      }
    }
    const float own = std::max(node.box.HalfArea(), leastArea_) + opened.at[Width - 1];
    Areas areas{{own}};
    for (int i = 1; i < Width; ++i) {
      areas.at[i] = std::min(own, opened.at[i]);
      // The last entry serves the node itself, which is opened in any case
      if (!(opened.at[i] < own) && i < Width - 1) choice.toLeft[i] = 0;
    }
    choice.toLeft[0] = 0;
    return areas;
  }

  // The children of the wide node that a binary one becomes.
  Children ChildrenOf(std::uint32_t parent, std::uint32_t firstReference) const {
    Children children;
    Open(parent, firstReference, Width, children);
    return children;
  }

  void Open(std::uint32_t index, std::uint32_t firstReference, int places,
            Children& children) const {
    const int toLeft = choices_[index].toLeft[places - 1];
    const BinaryNode& node = tree_[index];
    Add(node.Left(), firstReference, toLeft, children);
    Add(node.Right(), firstReference + tree_[node.Left()].Count(), places - toLeft, children);
  }

  void Add(std::uint32_t index, std::uint32_t firstReference, int places,
           Children& children) const {
    if (!tree_[index].IsLeaf() && places > 1 && choices_[index].toLeft[places - 1] > 0)
      return Open(index, firstReference, places, children);
    children.index[children.count] = index;
    children.first[children.count++] = firstReference;
  }

  static Usage UsageOfLeaf(LeafKind kind, std::uint32_t count) {
    Usage usage;
    (kind == LeafKind::Triangles   ? usage.blocks
     : kind == LeafKind::Instances ? usage.placed
                                   : usage.shapes) = kind == LeafKind::Triangles ? 1 : count;
    return usage;
  }

  // What a subtree will take.
  Usage UsageOf(std::uint32_t index, std::uint32_t firstReference) const {
    const BinaryNode& node = tree_[index];
    if (node.IsLeaf()) return UsageOfLeaf(references_[firstReference].Kind(), node.Count());
    const Children children = ChildrenOf(index, firstReference);
    Usage usage{.nodes = 1};
    for (int i = 0; i < children.count; ++i) usage += UsageOf(children.index[i], children.first[i]);
    return usage;
  }

  Layout Plan(std::uint32_t index, std::uint32_t firstReference) const {
    if (tree_[index].Count() <= TaskSize) return {UsageOf(index, firstReference), {}};
    const Children children = ChildrenOf(index, firstReference);
    Layout layout{{.nodes = 1}, std::vector<Layout>(std::size_t(children.count))};
    tbb::parallel_for(0, children.count, [&](int i) {
      layout.parts[std::size_t(i)] = Plan(children.index[i], children.first[i]);
    });
    for (const Layout& part : layout.parts) layout.usage += part.usage;
    return layout;
  }

  // Write a subtree to its place, from `next` on, which moves behind it. Returns its surface, the sum over its
  // primitives.
  float Emit(std::uint32_t index, std::uint32_t firstReference, const Layout& layout, Usage& next,
             ChildRef& ref) {
    const BinaryNode& node = tree_[index];
    if (node.IsLeaf()) {
      const LeafKind kind = references_[firstReference].Kind();
      if (kind == LeafKind::Triangles) {
        ref = LeafRef(kind, next.blocks, 1);
        return PackBlock(next.blocks++, firstReference, node.Count());
      }
      const bool isPlaced = kind == LeafKind::Instances;
      ref = LeafRef(kind, isPlaced ? next.placed : next.shapes, node.Count());
      for (std::uint32_t i = 0; i < node.Count(); ++i) {
        const std::uint32_t id = references_[firstReference + i].First();
        if (isPlaced) {
          PackInstance(arrays_.placed[next.placed++], id, geometry_);
        } else {
          arrays_.shapes[next.shapes++] = id;
        }
      }
      return node.box.HalfArea();
    }

    const Children children = ChildrenOf(index, firstReference);
    ref = next.nodes++;
    ChildRef refs[Width];
    float surfaces[Width];
    const auto emit = [&](int i, const Layout& part, Usage& from) {
      surfaces[i] = Emit(children.index[i], children.first[i], part, from, refs[i]);
    };
    if (layout.parts.empty()) {
      for (int i = 0; i < children.count; ++i) emit(i, layout, next);
    } else {
      Usage starts[Width];
      for (int i = 0; i < children.count; ++i) {
        starts[i] = next;
        next += layout.parts[std::size_t(i)].usage;
      }
      tbb::parallel_for(0, children.count,
                        [&](int i) { emit(i, layout.parts[std::size_t(i)], starts[i]); });
    }

    // Put last what is likely to stop a shadow ray at little cost
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
      for (int j = i; j > 0 && worth[order[j - 1]] > worth[order[j]]; --j)
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
  HugeVector<Choice> choices_;
  float leastArea_;  // so that nodes without extent cost something, too
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
