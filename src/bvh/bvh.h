// SPDX-License-Identifier: Apache-2.0
//
// The bounding volume hierarchy over triangles, analytic shapes and instances of meshes, and its two
// queries. All instruction sets and numbers of threads give the same hits: of hits at the same t, the one
// with the smaller instance and then the smaller primitive wins.
//
// The room is a library of its own; examples/rays shows it at work without the rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/build_wide.h"
#include "bvh/geometry.h"
#include "bvh/instruction_set.h"
#include "bvh/node.h"
#include "bvh/view.h"

namespace snell::bvh {

enum class BuildQuality {
  Fast,  // binned surface area heuristic
  High,  // then subtrees put where they cost rays less: a few times the building time
};

class Bvh {
 public:
  // Builds over `geometry`, whose arrays must outlive the BVH and stay where they are. Instances of the
  // same range of triangles share one tree. Throws Error if there is more geometry than the node format can
  // address.
  explicit Bvh(const Geometry& geometry, BuildQuality quality = BuildQuality::Fast);
  Bvh(const Bvh&) = delete;
  Bvh& operator=(const Bvh&) = delete;

  // The nearest hit at 0 < t ≤ tMax (in units of d's length) on an object whose mask shares a bit with
  // `mask`. Any number of threads may ask at once.
  Intersection Closest(const kernel::Ray& ray, float tMax, std::uint32_t mask = ~0u) const {
    Intersection found;
    traversal_->closest(view_, ray, tMax, mask, found);
    return found;
  }
  // Whether there is any such hit.
  bool Any(const kernel::Ray& ray, float tMax, std::uint32_t mask = ~0u) const {
    return traversal_->any(view_, ray, tMax, mask);
  }

  // The same for many rays, with the same answers: `found` and `hit` have a place for each query. Rays are
  // under way together, which pays where the tree is larger than the caches and the rays go different ways; by
  // itself each ray takes a little longer. Call it from several threads for parts of a hundred rays or more.
  void Closest(std::span<const Query> queries, Intersection* found,
               std::uint32_t mask = ~0u) const {
    traversal_->closestMany(view_, queries.data(), queries.size(), mask, found);
  }
  void Any(std::span<const Query> queries, bool* hit, std::uint32_t mask = ~0u) const {
    traversal_->anyMany(view_, queries.data(), queries.size(), mask, hit);
  }

  // Ask `filter` about every hit before it counts, for instance whether an alpha texture has a hole there.
  void SetFilter(const HitFilter& filter);

  // Follow geometry that has moved: positions, instances' transforms and shapes may have changed, but not
  // their numbers, the shapes' kinds, or what the triangles connect. Much faster than a new BVH, and rays are slower the more
  // the neighbours have parted. A triangle that is no longer finite is not hit until it is again; one that
  // was not finite when the BVH was built stays out.
  void Refit();

  // Use another instruction set than the best one; it must be Supported.
  void Use(InstructionSet set) { traversal_ = &TraversalFor(set); }

  // Primitives that are not in the tree because a coordinate is not finite.
  std::uint64_t droppedPrimitives() const { return dropped_; }
  // Bytes of nodes, blocks and lists.
  std::uint64_t MemoryBytes() const;

  // The arrays themselves, for devices that take a copy.
  const WideArrays& arrays() const { return arrays_; }
  const std::vector<Tree>& trees() const { return trees_; }
  const View& view() const { return view_; }

 private:
  // Also tells the tree's OuterBoxes.
  Tree BuildTree(HugeVector<PrimitiveRef>& references, std::vector<Bounds>& boxes);
  std::uint32_t MaskOf(std::uint32_t object) const;
  void FindTriangleMasks();
  void FindPlainMask();

  Geometry geometry_;
  BuildQuality quality_;
  WideArrays arrays_;
  std::vector<Tree> trees_;
  std::vector<std::uint32_t> unbounded_;
  View view_;
  std::uint64_t dropped_ = 0;
  const Traversal* traversal_;
};

}  // namespace snell::bvh
