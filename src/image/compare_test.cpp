// SPDX-License-Identifier: Apache-2.0
#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/color.h"
#include "image/heat.h"
#include "image/test_images.h"

namespace snell::image {
namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

TEST(Compare, IdenticalPicturesAgree) {
  const Comparison same = Compare(Pattern(30, 20), Pattern(30, 20));
  EXPECT_EQ(same.rmse, 0);
  EXPECT_EQ(same.relMse, 0);
  EXPECT_EQ(same.psnr, Infinity);
  EXPECT_EQ(same.maxAbs, 0);
  EXPECT_EQ(same.meanFlip, 0);
  EXPECT_EQ(same.notFinite, 0u);
}

TEST(Compare, NumbersAreThoseOfTheFormulas) {
  // One channel of one of four pixels differs by 0.5
  Image reference = Constant(2, 2, vec3(0.25f));
  Image test = reference;
  test.At(1, 0).y = 0.75f;
  const Comparison result = Compare(reference, test);
  EXPECT_DOUBLE_EQ(result.rmse, std::sqrt(0.25 / 12));
  EXPECT_DOUBLE_EQ(result.relMse, 0.25 / (0.0625 + 0.01) / 12);
  EXPECT_EQ(result.maxAbs, 0.5);
  EXPECT_EQ(result.maxX, 1);
  EXPECT_EQ(result.maxY, 0);
  const double shown = double(EncodeSrgb(0.75f)) - double(EncodeSrgb(0.25f));
  EXPECT_NEAR(result.psnr, -10 * std::log10(shown * shown / 12), 1e-6);
}

TEST(Compare, RelativeErrorIsRelativeToTheReference) {
  const Image bright = Constant(2, 2, vec3(100)), dim = Constant(2, 2, vec3(90));
  EXPECT_NEAR(Compare(bright, dim).relMse, 100.0 / 10000.01, 1e-9);
  EXPECT_NEAR(Compare(dim, bright).relMse, 100.0 / 8100.01, 1e-9);
}

TEST(Compare, NonFiniteValuesAreNeverHidden) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  Image broken = Constant(4, 4, vec3(0.5f));
  broken.At(2, 1).x = nan;
  broken.At(3, 3).z = infinity;
  const Comparison same = Compare(broken, broken);
  EXPECT_EQ(same.rmse, 0);
  EXPECT_EQ(same.notFinite, 2u);
  const Comparison differs = Compare(Constant(4, 4, vec3(0.5f)), broken);
  EXPECT_EQ(differs.rmse, Infinity);
  EXPECT_EQ(differs.relMse, Infinity);
  EXPECT_EQ(differs.psnr, -Infinity);
  EXPECT_EQ(differs.maxAbs, Infinity);
  EXPECT_EQ(differs.maxX, 2);
  EXPECT_EQ(differs.maxY, 1);
  EXPECT_TRUE(std::isfinite(differs.meanFlip));
  EXPECT_GT(differs.meanFlip, 2.0 / 16 - 1e-6);
}

TEST(Compare, AlphaCountsAsBlackBehind) {
  Image straight = Constant(3, 3, vec3(0.8f));
  straight.alpha.assign(9, 0.5f);
  EXPECT_NEAR(Compare(Constant(3, 3, vec3(0.4f)), straight).rmse, 0, 1e-7);
  straight.premultiplied = true;
  EXPECT_NEAR(Compare(Constant(3, 3, vec3(0.4f)), straight).rmse, 0.4, 1e-6);
}

TEST(Compare, DifferentSizesAreAnError) {
  const std::string error = ErrorOf([] { Compare(Image(3, 2), Image(2, 3)); });
  EXPECT_NE(error.find("3×2 and 2×3"), error.npos) << error;
  EXPECT_THROW(DifferenceImage(Image(3, 2), Image(3, 3)), Error);
}

TEST(DifferenceImage, IsBlackWhereNothingDiffers) {
  for (const vec3& pixel : DifferenceImage(Pattern(9, 9), Pattern(9, 9)).pixels)
    EXPECT_EQ(pixel, vec3(0));
  const Image worst = DifferenceImage(Constant(5, 5, vec3(0, 1, 0)), Constant(5, 5, vec3(0, 0, 1)));
  ExpectNear(worst.At(2, 2), HeatColor(1), 1e-3f);
}

TEST(HeatColor, GrowsLighterEvenly) {
  for (int i = 0; i <= 10; ++i) {
    const double y = double(Luminance(HeatColor(float(i) / 10)));
    const double lightness = y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
    EXPECT_NEAR(lightness, 9.7 * i, 0.4) << i;
  }
  for (int i = 0; i < 200; ++i)
    EXPECT_LT(Luminance(HeatColor(float(i) / 200)), Luminance(HeatColor(float(i + 1) / 200)));
  EXPECT_EQ(HeatColor(-1), vec3(0));
  EXPECT_EQ(HeatColor(2), HeatColor(1));
  EXPECT_EQ(HeatColor(std::nanf("")), HeatColor(1));
}

}  // namespace
}  // namespace snell::image
