// SPDX-License-Identifier: Apache-2.0
//
// The bounding volume hierarchy over triangles, analytic shapes and instances of meshes, and its two
// queries. All instruction sets and numbers of threads give the same hits: of hits at the same t, the one
// with the smaller instance and then the smaller primitive wins.
#pragma once

#include <cstdint>
#include <vector>

#include "bvh/build_wide.h"
#include "bvh/geometry.h"
#include "bvh/instruction_set.h"
#include "bvh/node.h"
#include "bvh/view.h"

namespace snell::bvh {

class Bvh {
 public:
  // Builds over `geometry`, whose arrays must outlive the BVH and stay where they are. Instances of the
  // same range of triangles share one tree. Throws Error if there is more geometry than the node format can
  // address.
  explicit Bvh(const Geometry& geometry);
  Bvh(const Bvh&) = delete;
  Bvh& operator=(const Bvh&) = delete;

  // The nearest hit at 0 < t ≤ tMax (in units of d's length) on an object whose mask shares a bit with
  // `mask`.
  Intersection Closest(const kernel::Ray& ray, float tMax, std::uint32_t mask) const {
    return traversal_->closest(view_, ray, tMax, mask);
  }
  // Whether there is any such hit.
  bool Any(const kernel::Ray& ray, float tMax, std::uint32_t mask) const {
    return traversal_->any(view_, ray, tMax, mask);
  }

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
  // Also tells the tree's bounds.
  Tree BuildTree(HugeVector<PrimitiveRef>& references, Bounds& bounds);
  std::uint32_t MaskOf(std::uint32_t object) const;
  void FindTriangleMasks();

  Geometry geometry_;
  WideArrays arrays_;
  std::vector<Tree> trees_;
  std::vector<std::uint32_t> unbounded_;
  View view_;
  std::uint64_t dropped_ = 0;
  const Traversal* traversal_;
};

}  // namespace snell::bvh
