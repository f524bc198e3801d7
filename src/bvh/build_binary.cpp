// SPDX-License-Identifier: Apache-2.0
#include "bvh/build_binary.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>

#include "util/check.h"

namespace snell::bvh {

namespace {

using Int4 = std::int32_t __attribute__((vector_size(16)));

constexpr int MaxBins = 32;
// Cost of visiting one level of the binary tree for a ray, relative to testing a block of triangles.
constexpr float TraversalCost = 0.4f;
// Cost of testing one primitive of a kind, in pairs of triangles: a shape, or a triangle that changes its shape, is
// tested alone, an instance is a whole tree. At these weights they get leaves of their own, so that the node's boxes
// sort them out, eight at once. The largest sum, of 2^25 instances, fits.
constexpr std::uint32_t WeightOf(LeafKind kind) {
  return kind == LeafKind::Triangles   ? 1
         : kind == LeafKind::Instances ? 16 * BlockWidth
                                       : 4 * BlockWidth;
}
// Beyond this depth the tree is split at medians, so that no input can make it deep.
constexpr int MaxSahDepth = 48;
// Ranges of more references are worked on by several threads.
constexpr std::uint32_t ParallelSize = 32768;
constexpr std::uint32_t TaskSize = 2048;
// Nodes that a task takes at a time.
constexpr std::uint32_t NodesAtATime = 64;

// Bounds of a range, of its centroids (doubled), its primitives' weight, and which kinds it holds.
struct Extent {
  Box box;
  Box centroids;
  std::uint32_t weight = 0;
  std::uint32_t kinds = 0;

  void Extend(const PrimitiveRef& ref) {
    box.Extend(ref.box);
    centroids.Extend(ref.Centroid2());
    const LeafKind kind = ref.Kind();
    weight += WeightOf(kind);
    kinds |= 1u << std::uint32_t(kind);
  }
  void Extend(const Extent& other) {
    box.Extend(other.box);
    centroids.Extend(other.centroids);
    weight += other.weight;
    kinds |= other.kinds;
  }
};

// References of one of the builder's two arrays.
struct Range {
  std::uint32_t first;
  std::uint32_t last;
  bool inScratch = false;
  Extent extent;
  std::uint32_t Count() const { return last - first; }
};

// Maps doubled centroids to bins; an axis without extent gets the scale 0.
struct BinMap {
  int count;
  Vec4 origin;
  Vec4 scale;

  explicit BinMap(const Range& range)
      : count(std::min(MaxBins, 4 + int(std::min(range.extent.weight, 4096u) / 16))),
        origin(range.extent.centroids.lower) {
    for (int axis = 0; axis < 3; ++axis) {
      const float size = range.extent.centroids.upper[axis] - origin[axis];
      scale[axis] = size > 0 ? std::min(float(count) * 0.99999f / size, 1e30f) : 0.0f;
    }
    scale[3] = 0;
  }
  Int4 Bins(const PrimitiveRef& ref) const {
    return __builtin_convertvector((ref.Centroid2() - origin) * scale, Int4);
  }
  int Bin(const PrimitiveRef& ref, int axis) const {
    return int((ref.Centroid2()[axis] - origin[axis]) * scale[axis]);
  }
};

struct Bins {
  Box boxes[3][MaxBins];
  Int4 weights[MaxBins];  // by axis

  void Clear(int count) {
    for (int bin = 0; bin < count; ++bin) {
      for (auto& axis : boxes) axis[bin] = Box();
      weights[bin] = Int4{};
    }
  }
  void Add(const PrimitiveRef& ref, const BinMap& map) {
    const Int4 bins = map.Bins(ref);
    const std::int32_t weight = std::int32_t(WeightOf(ref.Kind()));
    for (int axis = 0; axis < 3; ++axis) {
      const int bin = bins[axis];
      boxes[axis][bin].Extend(ref.box);
      weights[bin][axis] += weight;
    }
  }
  void Add(const Bins& other, int count) {
    for (int bin = 0; bin < count; ++bin) {
      for (int axis = 0; axis < 3; ++axis) boxes[axis][bin].Extend(other.boxes[axis][bin]);
      weights[bin] += other.weights[bin];
    }
  }
};

// The costs of three boxes, one for each axis: half their areas times how many blocks they need.
Vec4 Costs(const Box (&sides)[3], Int4 weights) {
  const Vec4 x = sides[0].upper - sides[0].lower;
  const Vec4 y = sides[1].upper - sides[1].lower;
  const Vec4 z = sides[2].upper - sides[2].lower;
  const Vec4 xyLow = __builtin_shufflevector(x, y, 0, 4, 1, 5);
  const Vec4 xyHigh = __builtin_shufflevector(x, y, 2, 6, 2, 6);
  const Vec4 a = __builtin_shufflevector(xyLow, z, 0, 1, 4, 4);
  const Vec4 b = __builtin_shufflevector(xyLow, z, 2, 3, 5, 5);
  const Vec4 c = __builtin_shufflevector(xyHigh, z, 0, 1, 6, 6);
  const Int4 blocks = (weights + (BlockWidth - 1)) / BlockWidth;
  return (a * (b + c) + b * c) * __builtin_convertvector(blocks, Vec4);
}

struct Split {
  float cost = std::numeric_limits<float>::infinity();  // times the node's half area
  int axis = -1;
  int bin = 0;  // bins below this one go left
};

Split BestSplit(const Bins& bins, const BinMap& map) {
  // Sweep from the right for the costs of the right sides, then from the left
  Vec4 rightCosts[MaxBins];
  Box sides[3];
  Int4 weights{};
  for (int bin = map.count - 1; bin > 0; --bin) {
    for (int axis = 0; axis < 3; ++axis) sides[axis].Extend(bins.boxes[axis][bin]);
    weights += bins.weights[bin];
    rightCosts[bin] = Costs(sides, weights);
  }
  for (Box& side : sides) side = Box();
  weights = Int4{};
  Vec4 bestCosts = Vec4{} + std::numeric_limits<float>::infinity();
  Int4 bestBins{};
  for (int bin = 1; bin < map.count; ++bin) {
    for (int axis = 0; axis < 3; ++axis) sides[axis].Extend(bins.boxes[axis][bin - 1]);
    weights += bins.weights[bin - 1];
    // An empty side makes its cost a NaN, which is not less
    const Vec4 costs = Costs(sides, weights) + rightCosts[bin];
    const Int4 better = costs < bestCosts;
    bestCosts = better ? costs : bestCosts;
    bestBins = better ? Int4{} + bin : bestBins;
  }
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    if (map.scale[axis] > 0 && bestCosts[axis] < best.cost)
      best = {bestCosts[axis], axis, bestBins[axis]};
  }
  return best;
}

class Builder {
 public:
  explicit Builder(HugeVector<PrimitiveRef>& references)
      : references_(references), tree_(2 * references.size()) {}

  BinaryTree Build() {
    const std::uint32_t count = std::uint32_t(references_.size());
    if (count >= ParallelSize) scratch_.resize(count);
    Places places(*this, count);
    BuildNode(0, {0, count, false, ExtentOf(0, count, false)}, 0, places);
    tree_.resize(used_);
    return std::move(tree_);
  }

 private:
  // Hands out places for the nodes that a task makes: for all those below a node over n references, which are
  // 2n − 2 at most, or for the children of a node that are tasks themselves.
  class Places {
   public:
    Places(Builder& builder, std::uint32_t references)
        : builder_(builder), left_(references > TaskSize ? 2 : 2 * references - 2) {}
    std::uint32_t TakePair() {
      if (next_ == end_) {
        const std::uint32_t count = std::min(NodesAtATime, left_);
        left_ -= count;
        next_ = builder_.used_.fetch_add(count, std::memory_order_relaxed);
        end_ = next_ + count;
      }
      next_ += 2;
      return next_ - 2;
    }

   private:
    Builder& builder_;
    std::uint32_t left_;
    std::uint32_t next_ = 0, end_ = 0;
  };

  void BuildNode(std::uint32_t index, Range range, int depth, Places& places) {
    if (range.inScratch && range.Count() < ParallelSize) BringBack(range);
    const std::uint32_t kinds = range.extent.kinds;
    const bool mixed = (kinds & (kinds - 1)) != 0;
    const bool mayBeLeaf = range.Count() <= MaxLeafCount && !mixed;
    const float leafCost = float((range.extent.weight + BlockWidth - 1) / BlockWidth);
    Range left, right;
    if (range.Count() == 1 || !Part(range, mixed, mayBeLeaf, leafCost, depth, left, right)) {
      tree_[index].Set(range.extent.box, range.Count(), 0);
      return;
    }
    const std::uint32_t children = places.TakePair();
    tree_[index].Set(range.extent.box, range.Count(), children);
    if (range.Count() > TaskSize) {
      const auto build = [&](std::uint32_t child, const Range& its) {
        Places own(*this, its.Count());
        BuildNode(child, its, depth + 1, own);
      };
      tbb::parallel_invoke([&] { build(children, left); }, [&] { build(children + 1, right); });
    } else {
      BuildNode(children, left, depth + 1, places);
      BuildNode(children + 1, right, depth + 1, places);
    }
  }

  HugeVector<PrimitiveRef>& ArrayOf(bool scratch) { return scratch ? scratch_ : references_; }

  void BringBack(Range& range) {
    std::copy(scratch_.begin() + range.first, scratch_.begin() + range.last,
              references_.begin() + range.first);
    range.inScratch = false;
  }

  // Part the references by the best split, else by kind, else in the middle. Returns false if a leaf is
  // better.
  bool Part(const Range& range, bool mixed, bool mayBeLeaf, float leafCost, int depth, Range& left,
            Range& right) {
    if (depth < MaxSahDepth) {
      const BinMap map(range);
      const Split split = FindSplit(range, map);
      const float area = std::max(range.extent.box.HalfArea(), std::numeric_limits<float>::min());
      if (mayBeLeaf && leafCost <= TraversalCost + split.cost / area) return false;
      if (split.axis >= 0) {
        const auto goesLeft = [&](const PrimitiveRef& ref) {
          return map.Bin(ref, split.axis) < split.bin;
        };
        if (Partition(range, goesLeft, left, right)) return true;
      }
    } else if (mayBeLeaf) {
      return false;
    }
    if (mixed) {
      const LeafKind kind = ArrayOf(range.inScratch)[range.first].Kind();
      const auto isKind = [&](const PrimitiveRef& ref) { return ref.Kind() == kind; };
      if (Partition(range, isKind, left, right)) return true;
    }
    const std::uint32_t middle = range.first + range.Count() / 2;
    const bool scratch = range.inScratch;
    left = {range.first, middle, scratch, ExtentOf(range.first, middle, scratch)};
    right = {middle, range.last, scratch, ExtentOf(middle, range.last, scratch)};
    return true;
  }

  Extent ExtentOf(std::uint32_t first, std::uint32_t last, bool inScratch) {
    const PrimitiveRef* references = ArrayOf(inScratch).data();
    const auto scan = [&](std::uint32_t from, std::uint32_t to, Extent extent) {
      for (std::uint32_t i = from; i < to; ++i) extent.Extend(references[i]);
      return extent;
    };
    if (last - first < ParallelSize) return scan(first, last, {});
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(first, last, ParallelSize / 4), Extent{},
        [&](const auto& part, Extent extent) { return scan(part.begin(), part.end(), extent); },
        [](Extent a, const Extent& b) {
          a.Extend(b);
          return a;
        });
  }

  Split FindSplit(const Range& range, const BinMap& map) {
    const PrimitiveRef* references = ArrayOf(range.inScratch).data();
    Bins bins;
    bins.Clear(map.count);
    if (range.Count() < ParallelSize) {
      for (std::uint32_t i = range.first; i < range.last; ++i) bins.Add(references[i], map);
      return BestSplit(bins, map);
    }
    bins = tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(range.first, range.last, ParallelSize / 4), bins,
        [&](const auto& part, Bins sum) {
          for (std::uint32_t i = part.begin(); i < part.end(); ++i) sum.Add(references[i], map);
          return sum;
        },
        [&](Bins a, const Bins& b) {
          a.Add(b, map.count);
          return a;
        });
    return BestSplit(bins, map);
  }

  // Bring those that go left to the front. Returns false if all go to one side.
  template <class GoesLeft>
  bool Partition(const Range& range, const GoesLeft& goesLeft, Range& left, Range& right) {
    left = {range.first, range.first, false, {}};
    right = {range.last, range.last, false, {}};
    if (range.Count() < ParallelSize) {
      std::uint32_t next = range.first;
      while (next < right.first) {
        PrimitiveRef& ref = references_[next];
        if (goesLeft(ref)) {
          left.extent.Extend(ref);
          ++next;
        } else {
          right.extent.Extend(ref);
          std::swap(ref, references_[--right.first]);
        }
      }
      left.last = next;
    } else {
      PartitionInParallel(range, goesLeft, left, right);
    }
    return left.Count() > 0 && right.Count() > 0;
  }

  // From one array to the other. The order on both sides is kept, so that it does not depend on the threads.
  template <class GoesLeft>
  void PartitionInParallel(const Range& range, const GoesLeft& goesLeft, Range& left,
                           Range& right) {
    constexpr std::uint32_t ChunkSize = ParallelSize / 4;
    const std::uint32_t chunkCount = (range.Count() + ChunkSize - 1) / ChunkSize;
    struct Chunk {
      std::uint32_t lefts = 0;
      Extent left, right;
    };
    std::vector<Chunk> chunks(chunkCount);
    const PrimitiveRef* from = ArrayOf(range.inScratch).data();
    PrimitiveRef* to = ArrayOf(!range.inScratch).data();
    left.inScratch = right.inScratch = !range.inScratch;
    const auto chunkFirst = [&](std::uint32_t c) {
      return std::min(range.first + c * ChunkSize, range.last);
    };
    tbb::parallel_for(0u, chunkCount, [&](std::uint32_t c) {
      for (std::uint32_t i = chunkFirst(c); i < chunkFirst(c + 1); ++i)
        chunks[c].lefts += goesLeft(from[i]) ? 1 : 0;
    });
    std::vector<std::uint32_t> lefts(chunkCount + 1, 0);
    for (std::uint32_t c = 0; c < chunkCount; ++c) lefts[c + 1] = lefts[c] + chunks[c].lefts;
    const std::uint32_t middle = range.first + lefts[chunkCount];
    left.last = right.first = middle;
    tbb::parallel_for(0u, chunkCount, [&](std::uint32_t c) {
      Chunk chunk;
      std::uint32_t toLeft = range.first + lefts[c];
      std::uint32_t toRight = middle + (chunkFirst(c) - range.first) - lefts[c];
      for (std::uint32_t i = chunkFirst(c); i < chunkFirst(c + 1); ++i) {
        const bool isLeft = goesLeft(from[i]);
        (isLeft ? chunk.left : chunk.right).Extend(from[i]);
        to[isLeft ? toLeft++ : toRight++] = from[i];
      }
      chunks[c] = chunk;
    });
    for (const Chunk& chunk : chunks) {
      left.extent.Extend(chunk.left);
      right.extent.Extend(chunk.right);
    }
  }

  HugeVector<PrimitiveRef>& references_;
  HugeVector<PrimitiveRef> scratch_;
  BinaryTree tree_;
  std::atomic<std::uint32_t> used_ = 2;  // the root is alone
};

}  // namespace

BinaryTree BuildBinaryTree(HugeVector<PrimitiveRef>& references) {
  CHECK(!references.empty());
  return Builder(references).Build();
}

}  // namespace snell::bvh
