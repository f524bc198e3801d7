// SPDX-License-Identifier: Apache-2.0
//
// A grid of densities: values at the points of a lattice, 0 but in bricks of 8³. Part of the scene (scene.h).
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace snell::scene {

struct DensityGrid {
  std::string name;  // of its file, for messages
  // From the lattice, whose first brick begins at the origin, to the space of the objects that it fills
  glm::dmat4 toObject{1.0};
  glm::uvec3 bricks{0};       // along the axes
  std::vector<int> table;     // numbers of bricks, x fastest; −1: empty
  std::vector<float> values;  // 512 to a brick, z fastest; none negative
};

}  // namespace snell::scene
