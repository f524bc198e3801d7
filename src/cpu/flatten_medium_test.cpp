// SPDX-License-Identifier: Apache-2.0
//
// Grids as the kernel reads them: every brick knows the greatest density that interpolation can give in it, and no more.
#include "cpu/flatten_medium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "support/random.h"

namespace snell::cpu {
namespace {

TEST(FlattenGrids, BricksKnowTheirGreatestDensity) {
  test::Random random(5);
  scene::Scene scene;
  scene::DensityGrid grid;
  grid.bricks = {3, 4, 2};
  // Some bricks are empty, some share their values
  for (int i = 0; i < 24; ++i) grid.table.push_back(random.Chance(0.4) ? -1 : int(random.Index(6)));
  for (int brick = 0; brick < 6; ++brick) {
    const float scale = float(random.LogUniform(0.01, 10));
    for (int i = 0; i < 512; ++i) grid.values.push_back(scale * float(random.Uniform(0, 1)));
  }
  scene.grids = {grid};
  FlatScene flat;
  flat.texels.resize(7);  // of something else
  FlattenGrids(scene, flat);
  ASSERT_EQ(flat.grids.size(), 1u);
  EXPECT_EQ(flat.grids[0].greatest, *std::ranges::max_element(grid.values));

  const auto word = [&](std::size_t i) { return flat.texels[flat.grids[0].firstWord + i]; };
  const auto valueAt = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    if (x >= 24 || y >= 32 || z >= 16) return 0.0f;
    const int number = grid.table[(z / 8 * 4 + y / 8) * 3 + x / 8];
    if (number < 0) return 0.0f;
    return grid.values[std::size_t(number) * 512 + (x % 8 * 8 + y % 8) * 8 + z % 8];
  };
  for (std::uint32_t i = 0; i < 24; ++i) {
    float greatest = 0;
    for (std::uint32_t p = 0; p < 9 * 9 * 9; ++p)
      greatest = std::max(
          greatest, valueAt(i % 3 * 8 + p % 9, i / 3 % 4 * 8 + p / 9 % 9, i / 12 * 8 + p / 81));
    EXPECT_EQ(std::bit_cast<float>(word(2 * i + 1)), greatest) << "brick " << i;
    if (grid.table[i] < 0) {
      EXPECT_EQ(word(2 * i), kernel::None);
    } else {
      EXPECT_EQ(std::bit_cast<float>(flat.texels[word(2 * i) + 511]),
                grid.values[std::size_t(grid.table[i]) * 512 + 511]);
    }
  }
}

}  // namespace
}  // namespace snell::cpu
