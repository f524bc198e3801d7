// SPDX-License-Identifier: Apache-2.0
//
// Builds the light tree that the kernel goes down (src/kernel/scene_light_tree.h): binary, one source a leaf, split
// where the halves' powers, extents and cones of directions are least together (Conty Estevez and Kulla 2018, section
// 4.4, the surface area orientation heuristic, with the square of a box's diagonal for its area, so that lights in a
// row have an extent, too).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/bounds.h"
#include "cpu/light_cone.h"
#include "kernel/types.h"

namespace snell::cpu {

// One source as the tree sees it.
struct LightLeaf {
  bvh::Bounds box;
  kernel::vec3 center;  // of a sphere around it; of a flat source in its plane
  float radius = 0;
  LightCone cone;
  glm::dvec3 power{0.0};  // intensity along its normal by falloff: none, linear, inverse square
  float reach = 0;        // range, metres; 0: unlimited
  std::uint32_t source = 0;

  double Power() const { return power.x + power.y + power.z; }
};

// The tree over sources that have some power, which are put into another order; empty if there are none. The root comes
// first, the children of a node side by side. Depends on the sources and their order alone.
std::vector<kernel::LightNode> BuildLightTree(std::span<LightLeaf> leaves);

}  // namespace snell::cpu
