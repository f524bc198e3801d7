// SPDX-License-Identifier: Apache-2.0
#include "bvh/blocks.h"

#include <algorithm>

namespace snell::bvh {

namespace {

float ExtentOf(vec3 edge) {
  return kernel::abs(edge.x) + kernel::abs(edge.y) + kernel::abs(edge.z);
}

}  // namespace

void ClearBlock(PairBlock& block) {
  for (auto& row : block.corner) std::ranges::fill(row, std::numeric_limits<float>::quiet_NaN());
  std::ranges::fill(block.id, None);
  std::ranges::fill(block.size, 0.0f);
  std::ranges::fill(block.unused, 0u);
}

void PackInstance(PlacedTree& placed, std::uint32_t instance, const Geometry& geometry) {
  const kernel::Instance& from = geometry.instances[instance];
  const kernel::Transform& map = from.toWorld;
  const std::uint32_t mask = geometry.objects.empty() ? ~0u : geometry.objects[from.object].mask;
  placed = {{map.rowX.x, map.rowY.x, map.rowZ.x, map.rowX.y, map.rowY.y, map.rowZ.y, map.rowX.z,
             map.rowY.z, map.rowZ.z, map.origin.x, map.origin.y, map.origin.z},
            from.root,
            instance,
            mask,
            geometry.IsMoving(from.object) ? from.object : None};
}

float PackPair(PairBlock& block, std::uint32_t lane, std::uint32_t first, std::uint32_t second,
               const Geometry& geometry) {
  const kernel::Triangle& s = geometry.triangles[first];
  const std::uint32_t v[5] = {s.v0, s.v1, s.v2, s.v0, s.v1};
  const auto position = [&](std::uint32_t vertex) { return geometry.positions[vertex]; };
  vec3 p[4] = {position(v[0]), position(v[1]), position(v[2]), position(v[2])};
  block.id[lane] = first;
  block.id[BlockWidth + lane] = None;
  if (second != MaxTriangles) {
    // The shared edge runs from p2 to p0 in the first triangle
    const kernel::Triangle& t = geometry.triangles[second];
    const std::uint32_t w[5] = {t.v0, t.v1, t.v2, t.v0, t.v1};
    const SharedEdge edge = FindSharedEdge(s, t);
    p[0] = position(v[edge.a + 1]);
    p[1] = position(v[edge.a + 2]);
    p[2] = position(v[edge.a]);
    p[3] = position(w[edge.b + 2]);
    block.id[lane] = first | (2 - edge.a) << 30;
    block.id[BlockWidth + lane] = second | (3 - edge.b) % 3 << 30;
  }
  for (std::uint32_t k = 0; k < 4; ++k) {
    for (int axis = 0; axis < 3; ++axis) block.corner[axis][k * BlockWidth + lane] = p[k][axis];
  }

  // Two edges of a triangle, whichever two; the slack is for other orders of summation
  const float diagonal = ExtentOf(p[2] - p[0]);
  const float a = ExtentOf(p[1] - p[0]), b = ExtentOf(p[2] - p[1]);
  const float c = ExtentOf(p[3] - p[2]), d = ExtentOf(p[0] - p[3]);
  block.size[lane] =
      std::max({a + b, b + diagonal, diagonal + a, c + d, d + diagonal, diagonal + c}) *
      (1 + 1e-5f);
  return 0.5f * (kernel::Length(kernel::Cross(p[1] - p[0], p[2] - p[0])) +
                 kernel::Length(kernel::Cross(p[2] - p[0], p[3] - p[0])));
}

std::vector<Bounds> OuterBoxes(ChildRef root, const Bounds& bounds,
                               const HugeVector<WideNode>& nodes) {
  if (IsLeaf(root)) return {bounds};
  std::vector<Bounds> boxes;
  for (int i = 0; i < Width; ++i) {
    const WideNode& node = nodes[root];
    if (node.child[i] == NoChild) continue;
    if (IsLeaf(node.child[i])) {
      boxes.push_back(ChildBounds(node, i));
      continue;
    }
    const WideNode& below = nodes[node.child[i]];
    for (int j = 0; j < Width; ++j) {
      if (below.child[j] != NoChild) boxes.push_back(ChildBounds(below, j));
    }
  }
  return boxes;
}

}  // namespace snell::bvh
