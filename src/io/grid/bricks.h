// SPDX-License-Identifier: Apache-2.0
//
// Bricks of 8³ values as they come from a file, and the grid of densities that they make. Where one value stands for
// many points, the bricks there share their numbers.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "scene/grid.h"

namespace snell::io {

class Bricks {
 public:
  // Errors name the file.
  explicit Bricks(const std::string& file) : file_(file) {}

  // The 512 values, z fastest, of the brick that begins at this point of the lattice; until the next call.
  float* Add(glm::ivec3 point);

  // One value for `size`³ points, a multiple of 8, that begin so far from a point; none if it is not above 0.
  void Fill(glm::ivec3 point, glm::ivec3 offset, int size, float value);

  scene::DensityGrid Finish(const glm::dmat4& toObject);

 private:
  // Bricks in a cube that have the same values.
  struct Part {
    glm::ivec3 place;  // in bricks, as the next
    int size;
    int number;
  };

  void AddPart(glm::ivec3 point, glm::ivec3 offset, int size, int number);
  int AddValues();
  [[noreturn]] void Refuse(const std::string& why) const;

  const std::string& file_;
  std::vector<Part> parts_;
  std::vector<float> values_;
  std::map<float, int> filled_;  // bricks of one value
  std::uint64_t covered_ = 0;    // bricks in all parts
  glm::ivec3 lower_{std::numeric_limits<int>::max()};
  glm::ivec3 upper_{std::numeric_limits<int>::min()};
};

}  // namespace snell::io
