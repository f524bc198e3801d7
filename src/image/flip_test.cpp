// SPDX-License-Identifier: Apache-2.0
//
// The recorded values come from a direct evaluation of the paper's formulas in double precision, with
// two-dimensional filters. Single precision resolves 1e-5 of lightness, which the exponents of the metric
// turn into some 1e-4 of error where the pictures hardly differ.
#include "image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "image/test_images.h"

namespace snell::image {
namespace {

double Mean(const std::vector<float>& errors) {
  return std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
}

// White from column `edge` on, black before.
Image Step(int edge) {
  Image image(24, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = edge; x < 24; ++x) image.At(x, y) = vec3(1);
  return image;
}

TEST(Flip, IdenticalPicturesHaveNoError) {
  for (const float error : FlipErrors(Pattern(40, 30), Pattern(40, 30))) EXPECT_EQ(error, 0);
}

TEST(Flip, ConstantColorsHaveTheFormulasErrors) {
  const auto error = [](const vec3& a, const vec3& b) {
    return FlipErrors(Constant(9, 7, a), Constant(9, 7, b))[31];
  };
  // The largest HyAB distance is that of green and blue; black and white come close
  EXPECT_NEAR(error(vec3(0, 1, 0), vec3(0, 0, 1)), 1, 1e-5f);
  EXPECT_NEAR(error(vec3(0), vec3(1)), 0.96737918f, 1e-5f);
  EXPECT_NEAR(error(vec3(0.2f, 0.4f, 0.6f), vec3(0.25f, 0.4f, 0.5f)), 0.21266292f, 1e-5f);
}

TEST(Flip, ValuesBeyondTheMonitorAreClamped) {
  EXPECT_EQ(FlipErrors(Constant(4, 4, vec3(1)), Constant(4, 4, vec3(50)))[0], 0);
  EXPECT_EQ(FlipErrors(Constant(4, 4, vec3(0)), Constant(4, 4, vec3(-3)))[0], 0);
}

TEST(Flip, ShiftedEdgeIsFoundWhereItIs) {
  const std::vector<float> errors = FlipErrors(Step(12), Step(13));
  EXPECT_NEAR(Mean(errors), 0.13790845, 2e-5);
  const float expected[] = {0,        0,        0,        0,        0,        0.00001f,
                            0.00047f, 0.00816f, 0.07833f, 0.35725f, 0.69337f, 0.77302f,
                            0.53829f, 0.49756f, 0.24788f, 0.09439f, 0.01921f, 0.00177f,
                            0.00009f, 0,        0,        0,        0,        0};
  for (int x = 0; x < 24; ++x)
    EXPECT_NEAR(errors[std::size_t(8 * 24 + x)], expected[x], 3e-4f) << x;
}

TEST(Flip, ColorfulPicturesHaveTheFormulasErrors) {
  const Image reference = Pattern(24, 16);
  Image test = reference;
  for (vec3& c : test.pixels) c = vec3(c.z, c.x, c.y);
  const std::vector<float> errors = FlipErrors(reference, test);
  EXPECT_NEAR(Mean(errors), 0.83096061, 2e-5);
  EXPECT_NEAR(errors.front(), 0.58053914f, 1e-4f);
  EXPECT_NEAR(errors[8 * 24 + 12], 0.02337651f, 1e-4f);
  EXPECT_NEAR(errors.back(), 0.72789285f, 1e-4f);
}

TEST(Flip, IsSymmetric) {
  const std::vector<float> there = FlipErrors(Step(7), Pattern(24, 16));
  const std::vector<float> back = FlipErrors(Pattern(24, 16), Step(7));
  EXPECT_EQ(there, back);
}

TEST(Flip, DistanceHidesDetail) {
  // A checkerboard and its mean differ for a near eye and hardly for a far one
  Image checker(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) checker.At(x, y) = vec3((x + y) % 2 ? 0.6f : 0.4f);
  const Image gray = Constant(32, 32, vec3(0.5f));
  EXPECT_GT(Mean(FlipErrors(checker, gray, 10)), 2 * Mean(FlipErrors(checker, gray, 120)));
}

TEST(Flip, NonFiniteValuesAreErrorsUnlessShared) {
  Image broken = Constant(20, 20, vec3(0.5f));
  broken.At(3, 3).y = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> errors = FlipErrors(Constant(20, 20, vec3(0.5f)), broken);
  EXPECT_EQ(errors[3 * 20 + 3], 1);
  for (const float error : errors) EXPECT_TRUE(error >= 0 && error <= 1);
  for (const float error : FlipErrors(broken, broken)) EXPECT_EQ(error, 0);
}

TEST(Flip, SmallPicturesWork) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 5}, {200, 1}})
    for (const float error :
         FlipErrors(Pattern(width, height), Constant(width, height, vec3(0.5f))))
      EXPECT_TRUE(error >= 0 && error <= 1);
}

}  // namespace
}  // namespace snell::image
