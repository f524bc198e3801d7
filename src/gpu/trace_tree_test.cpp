// SPDX-License-Identifier: Apache-2.0
//
// The tree for GPUs holds what the CPU's holds: every box is within the quantised one of its place, and every
// triangle is in a leaf once. That rays find the same in it, tests/agree shows.
#include "gpu/trace_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "support/soup.h"

namespace snell::gpu {

namespace {

using kernel::vec3;

struct Box {
  double lower[3];
  double upper[3];
};

Box BoxOf(const kernel::TraceNode& node, std::uint32_t slot) {
  Box box{};
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const double step = std::ldexp(1.0, int(node.exponents >> (8 * axis) & 255u) - 127);
    const auto plane = [&](std::uint32_t word) {
      return double(node.origin[int(axis)]) + step * (word >> (8 * (slot % 4)) & 255u);
    };
    box.lower[axis] = plane(node.planes[4 * axis + slot / 4]);
    box.upper[axis] = plane(node.planes[4 * axis + 2 + slot / 4]);
  }
  return box;
}

// All triangles below a child must lie in its box.
void Visit(const TraceArrays& tree, std::uint32_t child, const Box& box,
           std::multiset<std::uint32_t>& seen) {
  if ((child & kernel::TRACE_LEAF) == 0) {
    for (std::uint32_t slot = 0; slot < 8; ++slot) {
      const std::uint32_t next = tree.nodes[child].child[slot];
      if (next != kernel::TRACE_LEAF) Visit(tree, next, BoxOf(tree.nodes[child], slot), seen);
    }
    return;
  }
  const std::uint32_t first = child & kernel::TRACE_FIRST_MASK;
  const std::uint32_t count = (child >> kernel::TRACE_COUNT_SHIFT & 7u) + 1;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const kernel::TraceTriangle& triangle = tree.triangles[i];
    seen.insert(triangle.index);
    for (const vec3& corner : {triangle.v0, triangle.v1, triangle.v2}) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(double(corner[axis]), box.lower[axis]);
        EXPECT_LE(double(corner[axis]), box.upper[axis]);
      }
    }
  }
}

TEST(TraceTree, HoldsEveryTriangleOnceWithinItsBoxes) {
  test::Soup soup;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(-3.0f, 5.0f), size(-0.1f, 0.1f);
  const auto near = [&](vec3 p) { return p + vec3(size(random), size(random), size(random)); };
  for (int i = 0; i < 3000; ++i) {
    const vec3 p(place(random), place(random) * 1e-3f, place(random) * 100.0f);
    soup.AddTriangle(p, near(p), near(p));
  }
  const bvh::Geometry geometry = soup.Geometry();
  const bvh::Bvh bvh(geometry);
  const TraceArrays tree = ToTraceArrays(bvh, geometry);
  std::multiset<std::uint32_t> seen;
  Visit(tree, tree.world.tree.root, {{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}}, seen);
  EXPECT_EQ(seen.size(), 3000u);
  EXPECT_EQ(std::set(seen.begin(), seen.end()).size(), 3000u);
}

}  // namespace

}  // namespace snell::gpu
