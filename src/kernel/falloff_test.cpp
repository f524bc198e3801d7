// SPDX-License-Identifier: Apache-2.0
//
// The laws by which lights fade.
#include "kernel/falloff.h"

#include <gtest/gtest.h>

namespace snell::kernel {
namespace {

TEST(DistanceFalloff, FollowsItsLaw) {
  for (const float d : {0.01f, 0.5f, 1.0f, 3.0f, 1000.0f}) {
    EXPECT_EQ(DistanceFalloff(FALLOFF_NONE, d, 2.0f), 1.0f);
    EXPECT_FLOAT_EQ(DistanceFalloff(FALLOFF_LINEAR, d, 2.0f), 1.0f / (2.0f * d));
    EXPECT_FLOAT_EQ(DistanceFalloff(FALLOFF_INVERSE_SQUARE, d, 2.0f), 1.0f / (d * d));
  }
}

TEST(RangeWindow, EndsSmoothlyAtTheRange) {
  EXPECT_EQ(RangeWindow(1e6f, 0.0f), 1.0f);  // no range
  EXPECT_EQ(RangeWindow(0.0f, 4.0f), 1.0f);
  EXPECT_EQ(RangeWindow(4.0f, 4.0f), 0.0f);
  EXPECT_EQ(RangeWindow(5.0f, 4.0f), 0.0f);
  EXPECT_FLOAT_EQ(RangeWindow(2.0f, 4.0f), 0.87890625f);  // (1 − 1/16)²
  // It falls, and arrives with slope zero
  float last = 1.0f;
  for (int i = 1; i <= 400; ++i) {
    const float w = RangeWindow(float(i) * 0.01f, 4.0f);
    EXPECT_LE(w, last);
    EXPECT_LT(last - w, 0.02f);
    last = w;
  }
  EXPECT_LT(RangeWindow(3.999f, 4.0f), 2e-6f);
}

TEST(SpotFalloff, IsASmoothStepOfTheCosine) {
  const float inner = 0.9f;
  const float outer = 0.7f;
  EXPECT_EQ(SpotFalloff(1.0f, inner, outer), 1.0f);
  EXPECT_EQ(SpotFalloff(0.9f, inner, outer), 1.0f);
  EXPECT_EQ(SpotFalloff(0.7f, inner, outer), 0.0f);
  EXPECT_EQ(SpotFalloff(-1.0f, inner, outer), 0.0f);
  EXPECT_NEAR(SpotFalloff(0.8f, inner, outer), 0.5f, 1e-6f);
  EXPECT_NEAR(SpotFalloff(0.75f, inner, outer), 0.15625f, 1e-6f);
  // Equal angles make a sharp cone, without a division by zero
  EXPECT_EQ(SpotFalloff(0.81f, 0.8f, 0.8f), 1.0f);
  EXPECT_EQ(SpotFalloff(0.8f, 0.8f, 0.8f), 1.0f);
  EXPECT_EQ(SpotFalloff(0.79f, 0.8f, 0.8f), 0.0f);
}

}  // namespace
}  // namespace snell::kernel
