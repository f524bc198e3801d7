// SPDX-License-Identifier: Apache-2.0
#include "image/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace snell::image {
namespace {

constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

TEST(Color, SrgbHasTheStandardsValues) {
  EXPECT_EQ(EncodeSrgb(0.0f), 0.0f);
  EXPECT_FLOAT_EQ(EncodeSrgb(1.0f), 1.0f);
  EXPECT_FLOAT_EQ(EncodeSrgb(0.18f), 0.46135613f);
  EXPECT_FLOAT_EQ(EncodeSrgb(0.5f), 0.73535698f);
  EXPECT_FLOAT_EQ(EncodeSrgb(0.0031308f), 0.040449936f);
  EXPECT_FLOAT_EQ(EncodeSrgb(0.001f), 0.01292f);
  EXPECT_FLOAT_EQ(DecodeSrgb(0.5f), 0.21404114f);
  EXPECT_FLOAT_EQ(DecodeSrgb(0.04045f), 0.0031308049f);
  EXPECT_FLOAT_EQ(DecodeSrgb(1.0f / 255.0f), 0.00030352698f);
  EXPECT_FLOAT_EQ(DecodeSrgb(128.0f / 255.0f), 0.21586050f);
}

TEST(Color, SrgbCodesSurviveDecodingAndEncoding) {
  for (int code = 0; code < 256; ++code)
    EXPECT_EQ(Quantize8(EncodeSrgb(DecodeSrgb(float(code) / 255.0f))), code);
  for (int code = 0; code < 65536; ++code)
    ASSERT_EQ(Quantize16(EncodeSrgb(DecodeSrgb(float(code) / 65535.0f))), code);
}

TEST(Color, SrgbGoesOnBeyondItsRange) {
  EXPECT_FLOAT_EQ(EncodeSrgb(-0.001f), -0.01292f);
  EXPECT_GT(EncodeSrgb(4.0f), 1.8f);
  EXPECT_TRUE(std::isnan(EncodeSrgb(NaN)));
}

TEST(Color, QuantizesToTheNearestCode) {
  EXPECT_EQ(Quantize8(0.0f), 0);
  EXPECT_EQ(Quantize8(1.0f), 255);
  EXPECT_EQ(Quantize8(0.49f / 255.0f), 0);
  EXPECT_EQ(Quantize8(0.51f / 255.0f), 1);
  EXPECT_EQ(Quantize8(254.49f / 255.0f), 254);
  EXPECT_EQ(Quantize16(0.51f / 65535.0f), 1);
  EXPECT_EQ(Quantize16(1.0f), 65535);
}

TEST(Color, QuantizeClampsWhatIsOutside) {
  EXPECT_EQ(Quantize8(-1.0f), 0);
  EXPECT_EQ(Quantize8(7.0f), 255);
  EXPECT_EQ(Quantize8(NaN), 0);
  EXPECT_EQ(Quantize8(Infinity), 255);
  EXPECT_EQ(Quantize16(-Infinity), 0);
}

TEST(Color, ExposureCountsInStops) {
  EXPECT_EQ(Expose(vec3(1, 2, 3), 1), vec3(2, 4, 6));
  EXPECT_EQ(Expose(vec3(1, 2, 4), -2), vec3(0.25f, 0.5f, 1));
}

TEST(Color, LuminanceOfWhiteIsOne) {
  EXPECT_FLOAT_EQ(Luminance(vec3(1)), 1);
  EXPECT_FLOAT_EQ(Luminance(vec3(0, 1, 0)), 0.7152f);
}

TEST(Color, NonFiniteChannelsBecomeZeroAlone) {
  EXPECT_EQ(FiniteOrZero(vec3(NaN, 2, -Infinity)), vec3(0, 2, 0));
  EXPECT_FALSE(IsFinite(vec3(0, NaN, 0)));
  EXPECT_TRUE(IsFinite(vec3(1, 2, 3)));
}

}  // namespace
}  // namespace snell::image
