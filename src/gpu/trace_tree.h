// SPDX-License-Identifier: Apache-2.0
//
// The CPU's tree (src/bvh) in the form that GPUs walk: the same nodes with quantised boxes, their children in the
// order of the octants, and triangles with their corners beside each other (records.h).
#pragma once

#include <vector>

#include "bvh/bvh.h"
#include "gpu/records.h"

namespace snell::gpu {

struct TraceArrays {
  kernel::TraceWorld world;
  std::vector<kernel::TraceNode> nodes;
  std::vector<kernel::TraceTriangle> triangles;  // the first is none
  std::vector<kernel::TraceTree> trees;          // of instances, in the order of leaves
  std::vector<std::uint32_t> shapes;             // those without bounds, then those of leaves

  std::uint64_t MemoryBytes() const;
};

// `geometry` is what the tree was built over. Throws Error if the tree is deeper or larger than GPUs' rays can
// walk.
TraceArrays ToTraceArrays(const bvh::Bvh& bvh, const bvh::Geometry& geometry);

}  // namespace snell::gpu
