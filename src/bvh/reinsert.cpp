// SPDX-License-Identifier: Apache-2.0
#include "bvh/reinsert.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace snell::bvh {

namespace {

constexpr int Iterations = 6;
// Of all nodes, this part is tried in each iteration: those of the largest areas.
constexpr std::uint32_t TriedPart = 6;
// If the tree becomes deeper, it stays as it was: traversal has a stack for so much.
constexpr int MaxDepth = 76;

// A node with links in both directions. A leaf covers the references [first, first + count).
struct Node {
  Box box;
  std::uint32_t parent;
  std::uint32_t left;  // the right child is the next node; 0: a leaf
  std::uint32_t first;
  std::uint32_t count;

  bool IsLeaf() const { return left == 0; }
};

struct Move {
  std::uint32_t node = 0;
  std::uint32_t target = 0;  // becomes the node's sibling; 0: there is no better place
  float gain = 0;            // of area
};

using SearchStack = std::vector<std::pair<float, std::uint32_t>>;

float MergedArea(const Box& a, const Box& b) {
  Box box = a;
  box.Extend(b);
  return box.HalfArea();
}

class Optimizer {
 public:
  Optimizer(BinaryTree& tree, HugeVector<PrimitiveRef>& references)
      : tree_(tree), references_(references) {}

  void Run() {
    nodes_.reserve(tree_.size());
    nodes_.push_back({});
    Unpack(0, 0, 0, 0);
    if (nodes_.size() < 8) return;
    for (int i = 0; i < Iterations; ++i) Improve();
    if (DepthOf(0) <= MaxDepth) Pack();
  }

 private:
  // Siblings lie side by side.
  void Unpack(std::uint32_t place, std::uint32_t index, std::uint32_t parent, std::uint32_t first) {
    const BinaryNode& node = tree_[index];
    nodes_[place] = {node.box, parent, 0, first, node.Count()};
    if (node.IsLeaf()) return;
    const std::uint32_t children = std::uint32_t(nodes_.size());
    nodes_[place].left = children;
    nodes_.resize(nodes_.size() + 2);
    Unpack(children, node.Left(), place, first);
    Unpack(children + 1, node.Right(), place, first + tree_[node.Left()].Count());
  }

  static std::uint32_t SiblingOf(std::uint32_t node) { return node % 2 == 1 ? node + 1 : node - 1; }

  void Improve() {
    // The largest nodes, but for the root and its children
    std::vector<std::pair<float, std::uint32_t>> largest(nodes_.size() - 3);
    tbb::parallel_for(std::size_t(0), largest.size(), [&](std::size_t i) {
      largest[i] = {-nodes_[i + 3].box.HalfArea(), std::uint32_t(i + 3)};
    });
    const std::size_t tried = std::max<std::size_t>(largest.size() / TriedPart, 1);
    std::nth_element(largest.begin(), largest.begin() + std::ptrdiff_t(tried - 1), largest.end());

    std::vector<Move> moves(tried);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tried, 64), [&](const auto& range) {
      SearchStack stack;
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        moves[i] = BestMove(largest[i].second, stack);
    });
    std::erase_if(moves, [](const Move& move) { return move.target == 0; });
    std::ranges::sort(moves, [](const Move& a, const Move& b) {
      return a.gain != b.gain ? a.gain > b.gain : a.node < b.node;
    });

    // Do the best ones that do not touch the same nodes
    std::vector<bool> touched(nodes_.size(), false);
    for (const Move& move : moves) {
      const std::uint32_t involved[] = {move.node,
                                        SiblingOf(move.node),
                                        nodes_[move.node].parent,
                                        nodes_[nodes_[move.node].parent].parent,
                                        move.target,
                                        nodes_[move.target].parent};
      if (std::ranges::any_of(involved, [&](std::uint32_t i) { return touched[i]; })) continue;
      if (IsAbove(move.node, move.target)) continue;
      for (const std::uint32_t i : involved) touched[i] = true;
      Apply(move);
    }
    Refit(0, 0);
  }

  // An earlier move may have put the target below the node.
  bool IsAbove(std::uint32_t node, std::uint32_t below) const {
    while (below != 0 && below != node) below = nodes_[below].parent;
    return below == node;
  }

  int DepthOf(std::uint32_t place) const {
    const Node& node = nodes_[place];
    return node.IsLeaf() ? 1 : 1 + std::max(DepthOf(node.left), DepthOf(node.left + 1));
  }

  // Search the whole tree for the place where a node costs least area.
  Move BestMove(std::uint32_t node, SearchStack& stack) const {
    const Box& box = nodes_[node].box;
    const float area = box.HalfArea();
    Move best{node, 0, 0};
    const std::uint32_t parent = nodes_[node].parent;
    // What is gained above when the node is gone: its parent first
    float gain = nodes_[parent].box.HalfArea();
    Box pivotBox = nodes_[SiblingOf(node)].box;
    std::uint32_t sibling = SiblingOf(node), pivot = parent;
    for (;;) {
      stack.emplace_back(gain, sibling);
      while (!stack.empty()) {
        const auto [above, index] = stack.back();
        stack.pop_back();
        if (above - area <= best.gain) continue;
        const Node& target = nodes_[index];
        const float here = above - MergedArea(target.box, box);
        if (here > best.gain && index != SiblingOf(node)) best = {node, index, here};
        if (!target.IsLeaf()) {
          const float below = here + target.box.HalfArea();
          stack.emplace_back(below, target.left);
          stack.emplace_back(below, target.left + 1);
        }
      }
      if (pivot != parent) {
        pivotBox.Extend(nodes_[sibling].box);
        gain += nodes_[pivot].box.HalfArea() - pivotBox.HalfArea();
      }
      if (pivot == 0) return best;
      sibling = SiblingOf(pivot);
      pivot = nodes_[pivot].parent;
    }
  }

  // The sibling takes its parent's place; the pair of places that became free takes target and node.
  void Apply(const Move& move) {
    const std::uint32_t node = move.node, sibling = SiblingOf(node);
    const std::uint32_t parent = nodes_[node].parent, target = move.target;
    const Node moved = nodes_[node];
    const std::uint32_t pair = std::min(node, sibling);
    Place(parent, Node(nodes_[sibling]));
    Place(pair, Node(nodes_[target]));
    Place(pair + 1, moved);
    Node& inner = nodes_[target];
    inner.left = pair;
    inner.box.Extend(moved.box);
    nodes_[pair].parent = nodes_[pair + 1].parent = target;
  }

  // Put a node to another place, but for its link upwards.
  void Place(std::uint32_t place, Node node) {
    node.parent = nodes_[place].parent;
    nodes_[place] = node;
    if (!node.IsLeaf()) nodes_[node.left].parent = nodes_[node.left + 1].parent = place;
  }

  // Boxes and counts from the bottom up.
  void Refit(std::uint32_t place, int depth) {
    Node& node = nodes_[place];
    if (node.IsLeaf()) return;
    if (depth < 6) {
      tbb::parallel_for(0u, 2u, [&](std::uint32_t i) { Refit(node.left + i, depth + 1); });
    } else {
      Refit(node.left, depth + 1);
      Refit(node.left + 1, depth + 1);
    }
    node.box = nodes_[node.left].box;
    node.box.Extend(nodes_[node.left + 1].box);
    node.count = nodes_[node.left].count + nodes_[node.left + 1].count;
  }

  void Pack() {
    HugeVector<PrimitiveRef> sorted(references_.size());
    tree_.resize(nodes_.size() + 1);
    PackNode(0, 0, sorted);
    references_ = std::move(sorted);
  }

  // The root is node 0 of both trees, and its children, nodes 1 and 2 here, are 2 and 3 there.
  static std::uint32_t Packed(std::uint32_t place) { return place == 0 ? 0 : place + 1; }

  void PackNode(std::uint32_t place, std::uint32_t first, HugeVector<PrimitiveRef>& sorted) {
    const Node& node = nodes_[place];
    if (node.IsLeaf()) {
      tree_[Packed(place)].Set(node.box, node.count, 0);
      std::copy_n(references_.begin() + node.first, node.count, sorted.begin() + first);
      return;
    }
    const std::uint32_t leftCount = nodes_[node.left].count;
    tree_[Packed(place)].Set(node.box, node.count, Packed(node.left));
    const auto packLeft = [&] { PackNode(node.left, first, sorted); };
    const auto packRight = [&] { PackNode(node.left + 1, first + leftCount, sorted); };
    if (node.count > 8192) {
      tbb::parallel_for(0, 2, [&](int i) { i == 0 ? packLeft() : packRight(); });
    } else {
      packLeft();
      packRight();
    }
  }

  BinaryTree& tree_;
  HugeVector<PrimitiveRef>& references_;
  HugeVector<Node> nodes_;
};

}  // namespace

void ReinsertSubtrees(BinaryTree& tree, HugeVector<PrimitiveRef>& references) {
  Optimizer(tree, references).Run();
}

}  // namespace snell::bvh
