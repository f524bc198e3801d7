// SPDX-License-Identifier: Apache-2.0
#include "cpu/light_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernel/math.h"

namespace snell::cpu {

using namespace kernel;

namespace {

constexpr int BinCount = 16;
// Deeper than this, sources are halved by number, so that the tree stays shallow whatever they are.
constexpr int MaxSplits = 40;
constexpr std::size_t ParallelSize = 4096;

// What is known of several sources together.
struct Group {
  bvh::Bounds box;
  LightCone cone;
  glm::dvec3 power{0.0};
  float reach = 0;
  std::size_t count = 0;

  void Add(const Group& b) {
    if (b.count == 0) return;
    cone = count == 0 ? b.cone : LightCone::Union(cone, b.cone);
    reach = count == 0 ? b.reach : reach > 0 && b.reach > 0 ? std::max(reach, b.reach) : 0;
    box.Extend(b.box);
    power += b.power;
    count += b.count;
  }
  double Cost() const {
    if (count == 0) return 0;
    return (power.x + power.y + power.z) * cone.Measure() * double(LengthSquared(box.Size()));
  }
};

Group GroupOf(const LightLeaf& leaf) { return {leaf.box, leaf.cone, leaf.power, leaf.reach, 1}; }

// Where to part the sources: those whose middles lie below the border of a bin along an axis go first.
struct Split {
  int axis = -1;  // -1: none
  int bin = 0;
  double cost = std::numeric_limits<double>::infinity();
};

// Puts the middles of sources into bins.
struct Binning {
  bvh::Bounds middles;

  explicit Binning(std::span<const LightLeaf> leaves) {
    for (const LightLeaf& leaf : leaves) middles.Extend(leaf.box.Center());
  }
  int Of(const LightLeaf& leaf, int axis) const {
    const float place = leaf.box.Center()[axis] - middles.lower[axis];
    return std::clamp(int(float(BinCount) * place / middles.Size()[axis]), 0, BinCount - 1);
  }
};

Split FindSplit(std::span<const LightLeaf> leaves, const Binning& binning) {
  const vec3 size = binning.middles.Size();
  const float longest = std::max({size.x, size.y, size.z});
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(size[axis] > 0) || !std::isfinite(size[axis])) continue;
    std::array<Group, BinCount> bins;
    for (const LightLeaf& leaf : leaves)
      bins[std::size_t(binning.Of(leaf, axis))].Add(GroupOf(leaf));

    // Costs of what lies above each border, then of what lies below, together
    std::array<double, BinCount> above = {};
    Group sum;
    for (std::size_t i = BinCount - 1; i > 0; --i) {
      sum.Add(bins[i]);
      above[i] = sum.Cost();
    }
    sum = {};
    for (std::size_t i = 1; i < BinCount; ++i) {
      sum.Add(bins[i - 1]);
      if (sum.count == 0 || sum.count == leaves.size()) continue;
      // Thin slices are worth less than they seem
      const double cost = (sum.Cost() + above[i]) * double(longest / size[axis]);
      if (cost < best.cost) best = {axis, int(i), cost};
    }
  }
  return best;
}

class Builder {
 public:
  Builder(std::span<LightLeaf> leaves, std::vector<LightNode>& nodes)
      : leaves_(leaves), nodes_(nodes) {
    for (const LightLeaf& leaf : leaves) total_ += leaf.Power();
  }

  // Make the node at `index` over the sources from `first` to before `last`; all below it lie from `below` on.
  Group Build(std::size_t index, std::size_t first, std::size_t last, std::size_t below,
              std::size_t parent, int depth) {
    if (last - first == 1) {
      const LightLeaf& leaf = leaves_[first];
      Write(index, GroupOf(leaf), leaf.center, leaf.radius, LIGHT_NODE_LEAF, leaf.source, parent);
      return GroupOf(leaf);
    }
    const std::size_t middle = Partition(first, last, depth);
    // A subtree of n sources has 2 n − 1 nodes
    const std::size_t belowSecond = below + 2 + 2 * (middle - first) - 2;
    Group a, b;
    const auto buildFirst = [&] { a = Build(below, first, middle, below + 2, index, depth + 1); };
    const auto buildSecond = [&] {
      b = Build(below + 1, middle, last, belowSecond, index, depth + 1);
    };
    if (last - first > ParallelSize) {
      tbb::parallel_invoke(buildFirst, buildSecond);
    } else {
      buildFirst();
      buildSecond();
    }
    a.Add(b);
    // A little wider than the box, for rounding
    const float radius = 0.5f * Length(a.box.Size()) * (1 + 1e-6f);
    Write(index, a, a.box.Center(), radius, 0, uint(below), parent);
    return a;
  }

 private:
  std::size_t Partition(std::size_t first, std::size_t last, int depth) {
    const std::span<LightLeaf> part = leaves_.subspan(first, last - first);
    const Binning binning(part);
    if (depth < MaxSplits) {
      const Split split = FindSplit(part, binning);
      if (split.axis >= 0) {
        const auto end = std::partition(part.begin(), part.end(), [&](const LightLeaf& leaf) {
          return binning.Of(leaf, split.axis) < split.bin;
        });
        return first + std::size_t(end - part.begin());
      }
    }
    return first + (last - first) / 2;
  }

  void Write(std::size_t index, const Group& group, vec3 center, float radius, uint flags,
             uint child, std::size_t parent) {
    LightNode& node = nodes_[index];
    node.center = center;
    node.radius = radius;
    node.axis = vec3(group.cone.axis);
    node.cosThetaO = float(std::cos(group.cone.thetaO));
    node.cosThetaE = float(std::cos(group.cone.thetaE));
    node.power = vec3(group.power / total_);
    node.reach = group.reach;
    node.flags = flags | (group.cone.twoSided ? LIGHT_NODE_TWO_SIDED : 0u);
    node.first = child;
    node.parent = uint(parent);
  }

  std::span<LightLeaf> leaves_;
  std::vector<LightNode>& nodes_;
  double total_ = 0;
};

}  // namespace

std::vector<LightNode> BuildLightTree(std::span<LightLeaf> leaves) {
  std::vector<LightNode> nodes;
  if (leaves.empty()) return nodes;
  nodes.resize(2 * leaves.size() - 1);
  Builder(leaves, nodes).Build(0, 0, leaves.size(), 1, 0, 0);
  return nodes;
}

}  // namespace snell::cpu
