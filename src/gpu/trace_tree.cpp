// SPDX-License-Identifier: Apache-2.0
#include "gpu/trace_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "bvh/blocks.h"
#include "util/error.h"

namespace snell::gpu {

using namespace kernel;

namespace {

std::uint32_t LeafOf(std::uint32_t kind, std::size_t first, std::size_t count) {
  if (first + count > TRACE_FIRST_MASK)
    throw Error("the scene has more triangles than a GPU's tree can hold", {}, "use --device cpu");
  return TRACE_LEAF | kind << TRACE_KIND_SHIFT | std::uint32_t(count - 1) << TRACE_COUNT_SHIFT |
         std::uint32_t(first);
}

// The least power of two, as a float's exponent, of which 255 steps are as long as `extent`.
std::uint32_t ExponentFor(double extent) {
  int exponent = 0;
  std::frexp(extent / 255.0, &exponent);  // below 2 to the exponent
  return std::uint32_t(std::clamp(exponent + 127, 1, 254));
}

// The slot of each child: greedily, those first that lie farthest to a side.
std::array<int, bvh::Width> SlotsOf(const bvh::WideNode& node, const bvh::Bounds& all) {
  std::array<int, bvh::Width> slots;
  slots.fill(-1);
  bool taken[bvh::Width] = {};
  const vec3 middle = all.Center();
  for (int round = 0; round < bvh::Width; ++round) {
    int bestChild = -1, bestSlot = -1;
    double best = 0;
    for (int child = 0; child < bvh::Width; ++child) {
      const bvh::Bounds box = bvh::ChildBounds(node, child);
      if (slots[std::size_t(child)] >= 0 || box.Empty()) continue;
      const vec3 side = box.Center() - middle;
      for (int slot = 0; slot < bvh::Width; ++slot) {
        if (taken[slot]) continue;
        double fit = 0;
        for (int axis = 0; axis < 3; ++axis)
          fit += (slot >> axis & 1) != 0 ? double(side[axis]) : -double(side[axis]);
        if (bestChild >= 0 && fit <= best) continue;
        bestChild = child;
        bestSlot = slot;
        best = fit;
      }
    }
    if (bestChild < 0) break;
    slots[std::size_t(bestChild)] = bestSlot;
    taken[bestSlot] = true;
  }
  return slots;
}

class Converter {
 public:
  Converter(const bvh::Bvh& bvh, const bvh::Geometry& geometry, TraceArrays& arrays)
      : bvh_(bvh), geometry_(geometry), arrays_(arrays) {}

  void Convert() {
    const bvh::View& view = bvh_.view();
    arrays_.shapes.assign(view.unbounded, view.unbounded + view.unboundedCount);
    arrays_.triangles.assign(1, TraceTriangle{});  // its mask is 0
    std::vector<std::uint32_t> roots(bvh_.trees().size(), None);
    std::uint32_t deepest = 0;
    for (std::size_t tree = bvh_.trees().size(); tree-- > 0;) {
      if (bvh_.trees()[tree].root == bvh::None) continue;
      isWorld_ = tree == 0;
      if (isWorld_) roots_ = roots;
      std::uint32_t depth = 0;
      roots[tree] = Child(bvh_.trees()[tree].root, 0, depth);
      if (isWorld_) depth += deepest + 1;
      deepest = std::max(deepest, depth);
    }
    if (deepest > TraceStackSize)
      throw Error(
          fmt::format("the scene's tree has {} levels; GPUs walk {}", deepest, TraceStackSize), {},
          "use --device cpu");
    arrays_.world.tree = PlaceOf(0, roots[0]);
    arrays_.world.tree.instance = None;
    arrays_.world.tree.mask = view.treeMask;
    arrays_.world.unboundedCount = view.unboundedCount;
  }

 private:
  TraceTree PlaceOf(std::size_t tree, std::uint32_t root) const {
    const float* slack = bvh_.trees()[tree].slack;
    return {root, None, 0, vec3(slack[0], slack[1], slack[2]) * 2.0f};
  }

  // Convert what a child leads to, at `level` of its tree; `depth` becomes that of the deepest.
  std::uint32_t Child(bvh::ChildRef ref, std::uint32_t level, std::uint32_t& depth) {
    depth = std::max(depth, level);
    if (!bvh::IsLeaf(ref)) return Node(ref, level, depth);
    const std::uint32_t first = bvh::FirstOf(ref), count = bvh::CountOf(ref);
    switch (bvh::KindOf(ref)) {
      case bvh::LeafKind::Triangles: return Triangles(bvh_.arrays().blocks[first]);
      case bvh::LeafKind::Shapes:
      case bvh::LeafKind::Deforming: {
        const std::uint32_t* shapes = bvh_.view().leafShapes + first;
        arrays_.shapes.insert(arrays_.shapes.end(), shapes, shapes + count);
        const bool isShape = bvh::KindOf(ref) == bvh::LeafKind::Shapes;
        return LeafOf(isShape ? TRACE_SHAPES : TRACE_DEFORMING, arrays_.shapes.size() - count,
                      count);
      }
      case bvh::LeafKind::Instances: break;
    }
    for (std::uint32_t i = first; i < first + count; ++i) {
      const bvh::PlacedTree& placed = bvh_.view().placed[i];
      TraceTree tree = PlaceOf(placed.tree, roots_[placed.tree]);
      tree.instance = placed.instance;
      tree.mask = placed.mask;
      arrays_.trees.push_back(tree);
    }
    return LeafOf(TRACE_INSTANCES, arrays_.trees.size() - count, count);
  }

  std::uint32_t Triangles(const bvh::PairBlock& block) {
    const std::size_t first = arrays_.triangles.size();
    for (const std::uint32_t id : block.id) {
      if (id == bvh::None) continue;
      const std::uint32_t index = bvh::TriangleOf(id);
      const Triangle& triangle = geometry_.triangles[index];
      const std::uint32_t mask =
          isWorld_ ? geometry_.objects[geometry_.meshes[triangle.mesh].object].mask : ~0u;
      arrays_.triangles.push_back({geometry_.positions[triangle.v0],
                                   geometry_.positions[triangle.v1],
                                   geometry_.positions[triangle.v2], index, mask});
    }
    const std::size_t count = arrays_.triangles.size() - first;
    return count == 0 ? TRACE_LEAF : LeafOf(TRACE_TRIANGLES, first, count);
  }

  std::uint32_t Node(std::uint32_t index, std::uint32_t level, std::uint32_t& depth) {
    const bvh::WideNode& wide = bvh_.arrays().nodes[index];
    bvh::Bounds all;
    for (int child = 0; child < bvh::Width; ++child) {
      const bvh::Bounds box = bvh::ChildBounds(wide, child);
      if (!box.Empty()) all.Extend(box);
    }
    TraceNode node = {};
    node.origin = all.lower;
    for (std::uint32_t word = 0; word < 12; ++word) node.planes[word] = word % 4 < 2 ? ~0u : 0u;
    std::fill(std::begin(node.child), std::end(node.child), TRACE_LEAF);
    for (int axis = 0; axis < 3; ++axis)
      node.exponents |= ExponentFor(double(all.upper[axis]) - double(all.lower[axis]))
                        << (8 * axis);

    // Its place comes before its children's
    const std::size_t place = arrays_.nodes.size();
    if (place >= TRACE_LEAF) throw Error("the scene's tree has too many nodes for a GPU");
    arrays_.nodes.push_back(node);
    const std::array<int, bvh::Width> slots = SlotsOf(wide, all);
    for (int child = 0; child < bvh::Width; ++child) {
      const int slot = slots[std::size_t(child)];
      if (slot < 0) continue;
      SetBox(node, std::uint32_t(slot), bvh::ChildBounds(wide, child));
      node.child[slot] = Child(wide.child[child], level + 1, depth);
    }
    arrays_.nodes[place] = node;
    return std::uint32_t(place);
  }

  // Round a box outwards to steps.
  static void SetBox(TraceNode& node, std::uint32_t slot, const bvh::Bounds& box) {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const double step = std::ldexp(1.0, int(node.exponents >> (8 * axis) & 255u) - 127);
      const double origin = double(node.origin[int(axis)]);
      const double lower = std::floor((double(box.lower[int(axis)]) - origin) / step);
      const double upper = std::ceil((double(box.upper[int(axis)]) - origin) / step);
      SetPlane(node.planes[4 * axis + slot / 4], slot, lower);
      SetPlane(node.planes[4 * axis + 2 + slot / 4], slot, upper);
    }
  }
  static void SetPlane(std::uint32_t& word, std::uint32_t slot, double plane) {
    const std::uint32_t shift = 8 * (slot % 4);
    word = (word & ~(255u << shift)) | std::uint32_t(std::clamp(plane, 0.0, 255.0)) << shift;
  }

  const bvh::Bvh& bvh_;
  const bvh::Geometry& geometry_;
  TraceArrays& arrays_;
  std::vector<std::uint32_t> roots_;  // of the meshes' trees
  bool isWorld_ = false;
};

template <class T>
std::uint64_t BytesOf(const std::vector<T>& array) {
  return array.size() * sizeof(T);
}

}  // namespace

std::uint64_t TraceArrays::MemoryBytes() const {
  return BytesOf(nodes) + BytesOf(triangles) + BytesOf(trees) + BytesOf(shapes);
}

TraceArrays ToTraceArrays(const bvh::Bvh& bvh, const bvh::Geometry& geometry) {
  TraceArrays arrays;
  Converter(bvh, geometry, arrays).Convert();
  return arrays;
}

}  // namespace snell::gpu
