// SPDX-License-Identifier: Apache-2.0
#include "image/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "image/color.h"

namespace snell::image {
namespace {

void ExpectNear(const vec3& a, const vec3& b, float tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

const View Tones[] = {View::Agx, View::Neutral, View::Aces};

TEST(Views, BlackStaysBlackAndNothingLeavesTheDisplay) {
  for (const View view : Tones) {
    ExpectNear(ViewColor(view, vec3(0.0f)), vec3(0.0f), 2e-3f);
    for (const vec3& color : {vec3(1e9f), vec3(100, 0, 0), vec3(0, 5, 0.1f), vec3(0, 0, 1e4f),
                              vec3(-1, 2, 0.5f), vec3(-1e3f), vec3(0.2f, 1e-20f, 0)}) {
      const vec3 shown = ViewColor(view, color);
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(shown[c], 0);
        EXPECT_LE(shown[c], 1);
      }
    }
  }
}

TEST(Views, GreyStaysGreyAndMoreLightIsBrighter) {
  for (const View view : Tones) {
    float last = -1;
    for (float stops = -10; stops < 6; stops += 0.05f) {
      const vec3 shown = ViewColor(view, vec3(0.18f * std::exp2(stops)));
      EXPECT_NEAR(shown.x, shown.y, 2e-3f);
      EXPECT_NEAR(shown.z, shown.y, 2e-3f);
      EXPECT_GE(shown.y, last - 1e-6f) << stops;
      last = shown.y;
    }
    EXPECT_GT(last, 0.95f);
  }
}

TEST(Views, SrgbAndRawAreTheCodesOfThePicture) {
  const vec3 color(0.18f, 0.5f, 2.0f);
  EXPECT_EQ(ViewColor(View::Raw, color), color);
  EXPECT_EQ(ViewColor(View::Srgb, color), EncodeSrgb(color));
}

// The values that the specification's formula gives (KhronosGroup/ToneMapping, PBR_Neutral).
TEST(Views, NeutralKeepsBaseColors) {
  // White light adds a dielectric's reflection of 0.04, which the toe takes away
  for (const vec3& base : {vec3(0.5f), vec3(0.8f, 0.1f, 0.3f), vec3(0.2f, 0.6f, 0.76f)})
    ExpectNear(NeutralTone(base * 0.96f + vec3(0.04f)), base * 0.96f, 1e-6f);
  ExpectNear(NeutralTone(vec3(0.54f)), vec3(0.5f), 1e-6f);
  ExpectNear(NeutralTone(vec3(0.04f)), vec3(0.04f * 0.04f / 0.16f), 1e-7f);
  // Grey above the start: 1 − 0.24² / (1.96 + 0.24 − 0.76)
  ExpectNear(NeutralTone(vec3(2.0f)), vec3(0.96f), 1e-6f);
  // Pure red of 4.04 towards white; least is 0, so the toe takes nothing
  const float peak = 1 - 0.0576f / (4 - 0.52f);
  const float white = 1 - 1 / (0.15f * (4 - peak) + 1);
  ExpectNear(NeutralTone(vec3(4, 0, 0)), vec3(peak, white * peak, white * peak), 1e-6f);
}

// AgX between the matrices, against the polynomial that is commonly used for its curve (Wrensch 2023, "Minimal AgX
// implementation"; error 0.002 in the mean square).
TEST(Views, AgxCurveIsThePublishedOne) {
  for (float x = 0.02f; x < 1; x += 0.02f) {
    const float linear = std::exp2(x * 16.5f - 12.47393f);
    const float x2 = x * x, x4 = x2 * x2;
    const float polynomial = 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x +
                             0.4298f * x2 + 0.1191f * x - 0.00232f;
    const float code = std::pow(AgxTone(vec3(linear)).y, 1 / 2.2f);
    EXPECT_NEAR(code, polynomial, 0.007f) << x;
  }
  // Middle grey is the curve's pivot
  EXPECT_NEAR(std::pow(AgxTone(vec3(0.18f)).x, 1 / 2.2f), 0.5f, 1e-3f);
  EXPECT_NEAR(AgxTone(vec3(0.18f * std::exp2(6.5f))).x, 1, 1e-3f);
}

TEST(Views, AgxBleachesBrightColors) {
  const vec3 dim = AgxTone({0.2f, 0.01f, 0.01f}), bright = AgxTone({20, 1, 1});
  EXPECT_LT(dim.y / dim.x, 0.2f);
  EXPECT_GT(bright.y / bright.x, 0.35f);
}

// Hill's fit: its rational function at grey, where the matrices change next to nothing.
TEST(Views, AcesPlacesGreyAsTheReference) {
  ExpectNear(AcesTone(vec3(0.18f)), vec3(0.1056f), 5e-4f);
  ExpectNear(AcesTone(vec3(1.0f)), vec3(0.6164f), 2e-3f);
  EXPECT_GT(AcesTone(vec3(16.0f)).y, 0.97f);
}

TEST(Views, FalseColorsTellStops) {
  ExpectNear(FalseColor(vec3(0.18f)), vec3(0.5f), 0);
  EXPECT_EQ(FalseColor(vec3(0.18f * 1.4f)), FalseColor(vec3(0.18f / 1.4f)));
  EXPECT_NE(FalseColor(vec3(0.18f * 1.5f)), FalseColor(vec3(0.18f)));
  // What the display cannot show has other colours than what it just can
  EXPECT_NE(FalseColor(vec3(0.99f)), FalseColor(vec3(1.01f)));
  EXPECT_NE(FalseColor(vec3(0.0f)), FalseColor(vec3(0.18f / 32)));
  EXPECT_NE(FalseColor(vec3(100.0f)), FalseColor(vec3(2.0f)));
}

}  // namespace
}  // namespace snell::image
