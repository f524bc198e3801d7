// SPDX-License-Identifier: Apache-2.0
#include "io/grid/bricks.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "util/error.h"

namespace snell::io {

namespace {

// As many bricks as there are 32-bit numbers for their values, and places for bricks.
constexpr std::size_t MostBricks = std::size_t(1) << 23;
constexpr std::uint64_t MostPlaces = std::uint64_t(1) << 26;
constexpr int FarthestPoint = 1 << 24;

}  // namespace

void Bricks::Refuse(const std::string& why) const { throw Error(why, {file_}); }

int Bricks::AddValues() {
  const std::size_t count = values_.size() / 512;
  if (count == MostBricks) Refuse("a grid has more than 8 million bricks of 8³ values");
  values_.resize(values_.size() + 512);
  return int(count);
}

void Bricks::AddPart(glm::ivec3 point, glm::ivec3 offset, int size, int number) {
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < -FarthestPoint || point[axis] > FarthestPoint)
      Refuse("a grid reaches too far");
  }
  covered_ += std::uint64_t(size) * std::uint64_t(size) * std::uint64_t(size);
  if (covered_ > MostPlaces) Refuse("a grid covers more than 67 million bricks of 8³ points");
  point += offset;
  const glm::ivec3 place(point.x >> 3, point.y >> 3, point.z >> 3);
  parts_.push_back({place, size, number});
  lower_ = glm::min(lower_, place);
  upper_ = glm::max(upper_, place + size - 1);
}

float* Bricks::Add(glm::ivec3 point) {
  const int number = AddValues();
  AddPart(point, glm::ivec3(0), 1, number);
  return values_.data() + std::size_t(number) * 512;
}

void Bricks::Fill(glm::ivec3 point, glm::ivec3 offset, int size, float value) {
  if (!(value > 0)) return;
  auto entry = filled_.find(value);
  if (entry == filled_.end()) {
    const int number = AddValues();
    std::fill_n(values_.end() - 512, 512, value);
    entry = filled_.emplace(value, number).first;
  }
  AddPart(point, offset, size / 8, entry->second);
}

scene::DensityGrid Bricks::Finish(const glm::dmat4& toObject) {
  scene::DensityGrid grid;
  if (parts_.empty()) Refuse("the grid is empty");
  // What lies before the first point counts a little, too
  lower_ -= 1;
  const glm::dvec3 size(upper_ - lower_ + 1);
  if (size.x * size.y * size.z > double(MostPlaces)) Refuse("a grid's parts lie too far apart");
  grid.bricks = glm::uvec3(upper_ - lower_ + 1);
  grid.table.assign(std::size_t(grid.bricks.x) * grid.bricks.y * grid.bricks.z, -1);
  for (const Part& part : parts_) {
    const glm::uvec3 first(part.place - lower_);
    const auto count = std::uint32_t(part.size);
    for (std::uint32_t z = first.z; z < first.z + count; ++z) {
      for (std::uint32_t y = first.y; y < first.y + count; ++y)
        std::fill_n(
            grid.table.begin() +
                std::ptrdiff_t((std::size_t(z) * grid.bricks.y + y) * grid.bricks.x + first.x),
            count, part.number);
    }
  }
  grid.values = std::move(values_);
  for (float& value : grid.values) value = std::isfinite(value) && value > 0 ? value : 0.0f;
  glm::dmat4 shift(1.0);
  shift[3] = glm::dvec4(glm::dvec3(lower_) * 8.0, 1.0);
  grid.toObject = toObject * shift;
  return grid;
}

}  // namespace snell::io
