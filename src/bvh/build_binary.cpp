// SPDX-License-Identifier: Apache-2.0
#include "bvh/build_binary.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>

#include "util/check.h"

namespace snell::bvh {

namespace {

constexpr int BinCount = 16;
// Cost of visiting one level of the wide tree for a ray, relative to testing a block of triangles.
constexpr float TraversalCost = 1.0f;
// Cost of testing one primitive of a kind, in triangles: a shape is tested alone, an instance is a whole
// tree. At these weights they get leaves of their own, so that the node's boxes sort them out, eight at once.
constexpr std::uint32_t WeightOf(LeafKind kind) {
  return kind == LeafKind::Triangles ? 1
         : kind == LeafKind::Shapes  ? 4 * BlockWidth
                                     : 16 * BlockWidth;
}
// Beyond this depth the tree is split at medians, so that no input can make it deep.
constexpr int MaxSahDepth = 48;
// Ranges of more references are worked on by several threads.
constexpr std::uint32_t ParallelSize = 16384;
constexpr std::uint32_t TaskSize = 2048;

Bounds BoundsOf(const PrimitiveRef& ref) { return {ref.lower, ref.upper}; }
vec3 CentroidOf(const PrimitiveRef& ref) { return (ref.lower + ref.upper) * 0.5f; }

struct Range {
  std::uint32_t first;
  std::uint32_t last;
  std::uint32_t Count() const { return last - first; }
};

// Bounds of a range, of its centroids, its primitives' weight, and which kinds it holds.
struct Extent {
  Bounds bounds;
  Bounds centroids;
  std::uint64_t weight = 0;
  std::uint32_t kinds = 0;

  void Extend(const PrimitiveRef& ref) {
    bounds.Extend(BoundsOf(ref));
    centroids.Extend(CentroidOf(ref));
    weight += WeightOf(ref.kind);
    kinds |= 1u << std::uint32_t(ref.kind);
  }
  void Extend(const Extent& other) {
    bounds.Extend(other.bounds);
    centroids.Extend(other.centroids);
    weight += other.weight;
    kinds |= other.kinds;
  }
};

// Maps centroids to bins; an axis without extent gets the scale 0.
struct BinMap {
  vec3 origin;
  vec3 scale;

  explicit BinMap(const Bounds& centroids) : origin(centroids.lower) {
    for (int axis = 0; axis < 3; ++axis) {
      const float size = centroids.upper[axis] - centroids.lower[axis];
      scale[axis] = size > 0 ? std::min(float(BinCount) * 0.99999f / size, 1e30f) : 0.0f;
    }
  }
  int Bin(const PrimitiveRef& ref, int axis) const {
    const int bin = int((CentroidOf(ref)[axis] - origin[axis]) * scale[axis]);
    return std::clamp(bin, 0, BinCount - 1);
  }
};

struct Bins {
  std::array<std::array<Bounds, BinCount>, 3> bounds;
  std::array<std::array<std::uint64_t, BinCount>, 3> weights{};

  void Add(const PrimitiveRef& ref, const BinMap& map) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t bin = std::size_t(map.Bin(ref, axis));
      bounds[std::size_t(axis)][bin].Extend(BoundsOf(ref));
      weights[std::size_t(axis)][bin] += WeightOf(ref.kind);
    }
  }
  void Add(const Bins& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t bin = 0; bin < BinCount; ++bin) {
        bounds[axis][bin].Extend(other.bounds[axis][bin]);
        weights[axis][bin] += other.weights[axis][bin];
      }
    }
  }
};

struct Split {
  float cost = std::numeric_limits<float>::infinity();  // relative to the node's area
  int axis = -1;
  int bin = 0;  // bins below this one go left
};

class Builder {
 public:
  Builder(std::vector<PrimitiveRef>& references, std::uint32_t maxLeafPrimitives)
      : references_(references),
        scratch_(references.size()),
        maxLeafPrimitives_(maxLeafPrimitives) {
    tree_.nodes.resize(2 * references.size() - 1);
  }

  BinaryTree Build() {
    const Range all{0, std::uint32_t(references_.size())};
    BuildNode(0, all, ExtentOf(all), 0);
    return std::move(tree_);
  }

 private:
  // A subtree over n references takes the 2n − 1 nodes from `index` on, whichever thread builds it.
  void BuildNode(std::uint32_t index, Range range, const Extent& extent, int depth) {
    BinaryNode& node = tree_.nodes[index];
    node.bounds = extent.bounds;
    node.first = range.first;
    node.count = range.Count();

    const bool mixed = (extent.kinds & (extent.kinds - 1)) != 0;
    const bool mayBeLeaf = range.Count() <= maxLeafPrimitives_ && !mixed;
    if (range.Count() == 1) return;
    const Split split = depth < MaxSahDepth ? FindSplit(range, extent) : Split{};
    const float leafCost = LeafCost(extent.weight);
    if (mayBeLeaf && leafCost <= TraversalCost + split.cost) return;

    // Part the references: by the split, else by kind, else in the middle
    std::uint32_t middle = range.first;
    if (split.axis >= 0) {
      const BinMap map(extent.centroids);
      middle = Partition(
          range, [&](const PrimitiveRef& ref) { return map.Bin(ref, split.axis) < split.bin; });
    } else if (mixed) {
      const LeafKind kind = references_[range.first].kind;
      middle = Partition(range, [&](const PrimitiveRef& ref) { return ref.kind == kind; });
    }
    if (middle == range.first || middle == range.last) middle = range.first + range.Count() / 2;

    const Range left{range.first, middle};
    const Range right{middle, range.last};
    node.right = index + 2 * left.Count();
    const auto buildLeft = [&] { BuildNode(index + 1, left, ExtentOf(left), depth + 1); };
    const auto buildRight = [&] { BuildNode(node.right, right, ExtentOf(right), depth + 1); };
    if (range.Count() > TaskSize) {
      tbb::parallel_invoke(buildLeft, buildRight);
    } else {
      buildLeft();
      buildRight();
    }
  }

  Extent ExtentOf(Range range) const {
    const auto scan = [&](std::uint32_t first, std::uint32_t last, Extent extent) {
      for (std::uint32_t i = first; i < last; ++i) extent.Extend(references_[i]);
      return extent;
    };
    if (range.Count() < ParallelSize) return scan(range.first, range.last, {});
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(range.first, range.last, ParallelSize / 4), Extent{},
        [&](const auto& part, Extent extent) { return scan(part.begin(), part.end(), extent); },
        [](Extent a, const Extent& b) {
          a.Extend(b);
          return a;
        });
  }

  Split FindSplit(Range range, const Extent& extent) const {
    const BinMap map(extent.centroids);
    const auto scan = [&](std::uint32_t first, std::uint32_t last, Bins bins) {
      for (std::uint32_t i = first; i < last; ++i) bins.Add(references_[i], map);
      return bins;
    };
    const Bins bins =
        range.Count() < ParallelSize
            ? scan(range.first, range.last, {})
            : tbb::parallel_reduce(
                  tbb::blocked_range<std::uint32_t>(range.first, range.last, ParallelSize / 4),
                  Bins{},
                  [&](const auto& part, Bins sum) { return scan(part.begin(), part.end(), sum); },
                  [](Bins a, const Bins& b) {
                    a.Add(b);
                    return a;
                  });

    Split best;
    const float area = std::max(extent.bounds.HalfArea(), std::numeric_limits<float>::min());
    for (int axis = 0; axis < 3; ++axis) {
      if (map.scale[axis] == 0.0f) continue;
      const auto& bounds = bins.bounds[std::size_t(axis)];
      const auto& weights = bins.weights[std::size_t(axis)];

      // Sweep from the right for the costs of the right sides, then from the left
      std::array<float, BinCount> rightCost;
      Bounds side;
      std::uint64_t weight = 0;
      for (std::size_t bin = BinCount - 1; bin > 0; --bin) {
        side.Extend(bounds[bin]);
        weight += weights[bin];
        rightCost[bin] = SideCost(side, weight);
      }
      side = {};
      weight = 0;
      for (std::size_t bin = 1; bin < BinCount; ++bin) {
        side.Extend(bounds[bin - 1]);
        weight += weights[bin - 1];
        const float cost = (SideCost(side, weight) + rightCost[bin]) / area;
        const bool parts = weight > 0 && weight < extent.weight;
        if (parts && cost < best.cost) best = {cost, axis, int(bin)};
      }
    }
    return best;
  }

  // Blocks of triangles, or as much work.
  static float LeafCost(std::uint64_t weight) {
    return float((weight + BlockWidth - 1) / BlockWidth);
  }
  static float SideCost(const Bounds& bounds, std::uint64_t weight) {
    return weight == 0 ? 0.0f : bounds.HalfArea() * LeafCost(weight);
  }

  // Bring those that go left to the front, keeping the order on both sides; returns where the right begins.
  template <class GoesLeft>
  std::uint32_t Partition(Range range, const GoesLeft& goesLeft) {
    if (range.Count() < ParallelSize) {
      std::uint32_t left = range.first;
      std::uint32_t right = range.first;
      for (std::uint32_t i = range.first; i < range.last; ++i) {
        if (goesLeft(references_[i])) {
          references_[left++] = references_[i];
        } else {
          scratch_[right++] = references_[i];
        }
      }
      std::copy(scratch_.begin() + range.first, scratch_.begin() + right,
                references_.begin() + left);
      return left;
    }

    // Count by chunk, then let every chunk copy to its own places
    constexpr std::uint32_t Chunk = ParallelSize / 4;
    const std::uint32_t chunks = (range.Count() + Chunk - 1) / Chunk;
    std::vector<std::uint32_t> lefts(chunks + 1, 0);
    const auto chunkRange = [&](std::uint32_t c) {
      return Range{range.first + c * Chunk, std::min(range.first + (c + 1) * Chunk, range.last)};
    };
    tbb::parallel_for(0u, chunks, [&](std::uint32_t c) {
      const Range part = chunkRange(c);
      for (std::uint32_t i = part.first; i < part.last; ++i)
        lefts[c + 1] += goesLeft(references_[i]) ? 1 : 0;
    });
    for (std::uint32_t c = 0; c < chunks; ++c) lefts[c + 1] += lefts[c];
    const std::uint32_t middle = range.first + lefts[chunks];
    tbb::parallel_for(0u, chunks, [&](std::uint32_t c) {
      const Range part = chunkRange(c);
      std::uint32_t left = range.first + lefts[c];
      std::uint32_t right = middle + (part.first - range.first) - lefts[c];
      for (std::uint32_t i = part.first; i < part.last; ++i)
        scratch_[goesLeft(references_[i]) ? left++ : right++] = references_[i];
    });
    tbb::parallel_for(0u, chunks, [&](std::uint32_t c) {
      const Range part = chunkRange(c);
      std::copy(scratch_.begin() + part.first, scratch_.begin() + part.last,
                references_.begin() + part.first);
    });
    return middle;
  }

  std::vector<PrimitiveRef>& references_;
  std::vector<PrimitiveRef> scratch_;
  std::uint32_t maxLeafPrimitives_;
  BinaryTree tree_;
};

}  // namespace

BinaryTree BuildBinaryTree(std::vector<PrimitiveRef>& references, std::uint32_t maxLeafPrimitives) {
  CHECK(!references.empty());
  return Builder(references, maxLeafPrimitives).Build();
}

}  // namespace snell::bvh
