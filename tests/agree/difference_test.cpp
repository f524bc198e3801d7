// SPDX-License-Identifier: Apache-2.0
#include "agree/difference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace snell::agree {

namespace {

using kernel::Spectrum;
using Picture = std::vector<Spectrum>;

// 20 × 10 pixels.
const Picture Grey(200, Spectrum(0.5f));

TEST(Difference, IsEmptyForEqualBitsOnly) {
  EXPECT_EQ(Difference("a", Grey, "b", Grey, 20), "");
  Picture other = Grey;
  other[43].y = std::nextafter(0.5f, 1.0f);
  other[44] = Spectrum(0.0f);
  const std::string difference = Difference("a", Grey, "b", other, 20);
  EXPECT_TRUE(difference.starts_with("2 of 200 pixels differ, the first at 3,2:")) << difference;
  EXPECT_NE(difference.find("b: (0.5, 0.50000006, 0.5) = 3f000000 3f000001 3f000000"),
            std::string::npos)
      << difference;
}

TEST(Difference, TellsTheSignsOfZeros) {
  EXPECT_NE(Difference("a", {Spectrum(0.0f)}, "b", {Spectrum(-0.0f)}, 1), "");
}

TEST(Difference, BeyondRoundingForgivesLastBitsAndFewPixels) {
  Picture other(200, Spectrum(0.50001f));
  EXPECT_EQ(DifferenceBeyondRounding(Grey, other), "");
  other[7] = Spectrum(0.52f);
  other[8] = Spectrum(0.48f);
  EXPECT_EQ(DifferenceBeyondRounding(Grey, other), "");
  other[9] = Spectrum(0.48f);
  EXPECT_EQ(DifferenceBeyondRounding(Grey, other), "3 of 200 pixels differ by more than rounding");
}

TEST(Difference, BeyondRoundingForgivesNoOtherMeanAndNoNaN) {
  EXPECT_NE(DifferenceBeyondRounding(Grey, Picture(200, Spectrum(0.501f))), "");
  Picture other = Grey;
  other[0].x = NAN;
  EXPECT_NE(DifferenceBeyondRounding(Grey, other), "");
}

TEST(Difference, CountsWhatIsNotFinite) {
  Picture other = Grey;
  other[0].x = NAN;
  other[1].z = INFINITY;
  EXPECT_EQ(CountNonFinite(Grey), 0u);
  EXPECT_EQ(CountNonFinite(other), 2u);
}

}  // namespace

}  // namespace snell::agree
