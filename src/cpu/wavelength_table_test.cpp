// SPDX-License-Identifier: Apache-2.0
//
// Wavelengths for dispersed light: white stays white in the mean, and red is bent less than blue.
#include "cpu/wavelength_table.h"

#include <gtest/gtest.h>

#include <vector>

#include "kernel/albedo.h"

namespace snell::cpu {
namespace {

using kernel::WavelengthNodes;

TEST(WavelengthTable, MakesWhiteInTheMean) {
  std::vector<float> table(4 * WavelengthNodes);
  FillWavelengthTable(table);
  double mean[3] = {}, spread[3] = {};
  for (std::size_t node = 0; node < WavelengthNodes; ++node) {
    const double share =
        (node == 0 || node == WavelengthNodes - 1 ? 0.5 : 1) / double(WavelengthNodes - 1);
    if (node > 0) {
      EXPECT_LT(table[4 * node], table[4 * node - 4]);  // longer waves last
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const double weight = double(table[4 * node + 1 + c]);
      EXPECT_GE(weight, 0);
      EXPECT_LT(weight, 3.3);
      mean[c] += weight * share;
      spread[c] += weight * share * double(table[4 * node]);
    }
  }
  for (const double m : mean) EXPECT_NEAR(m, 1, 1e-6);
  // 1/λ² − 1/λ² of 587.6 nm: red is seen around 600 nm, green around 540, blue around 450
  EXPECT_NEAR(spread[0], -0.1, 0.1);
  EXPECT_NEAR(spread[1], 0.53, 0.1);
  EXPECT_NEAR(spread[2], 2.04, 0.1);
}

}  // namespace
}  // namespace snell::cpu
