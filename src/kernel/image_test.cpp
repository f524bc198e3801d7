// SPDX-License-Identifier: Apache-2.0
//
// How pictures go on beyond their borders.
#include "kernel/image.h"

#include <gtest/gtest.h>

namespace snell::kernel {
namespace {

TEST(WrapCoordinate, FollowsTheMode) {
  for (const float cell : {-3.0f, -1.0f, 0.0f, 2.0f, 7.0f}) {
    EXPECT_NEAR(WrapCoordinate(WRAP_REPEAT, cell + 0.3f), 0.3f, 1e-6f);
    const bool odd = int(cell) % 2 != 0;
    EXPECT_NEAR(WrapCoordinate(WRAP_MIRROR, cell + 0.3f), odd ? 0.7f : 0.3f, 1e-6f);
  }
  EXPECT_EQ(WrapCoordinate(WRAP_CLAMP, -0.2f), 0.0f);
  EXPECT_EQ(WrapCoordinate(WRAP_CLAMP, 0.2f), 0.2f);
  EXPECT_EQ(WrapCoordinate(WRAP_CLAMP, 1.2f), 1.0f);
}

TEST(WrapCoordinate, StaysInTheUnitForAnyNumber) {
  for (const uint mode : {WRAP_REPEAT, WRAP_CLAMP, WRAP_MIRROR}) {
    for (const float x : {-1e30f, -1e7f, -1e-30f, 0.0f, 0.99999994f, 1.0f, 16777217.0f, 3e38f}) {
      const float wrapped = WrapCoordinate(mode, x);
      EXPECT_GE(wrapped, 0.0f) << x;
      EXPECT_LE(wrapped, 1.0f) << x;
    }
  }
}

TEST(WrapTexel, GoesOnAtTheOtherSideOrStays) {
  for (const uint count : {1u, 2u, 5u}) {
    EXPECT_EQ(WrapTexel(WRAP_REPEAT, -1, count), count - 1);
    EXPECT_EQ(WrapTexel(WRAP_REPEAT, int(count), count), 0u);
    for (const uint mode : {WRAP_CLAMP, WRAP_MIRROR}) {
      EXPECT_EQ(WrapTexel(mode, -1, count), 0u);
      EXPECT_EQ(WrapTexel(mode, int(count), count), count - 1);
    }
    for (uint i = 0; i < count; ++i) EXPECT_EQ(WrapTexel(WRAP_REPEAT, int(i), count), i);
  }
}

}  // namespace
}  // namespace snell::kernel
