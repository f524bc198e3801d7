// SPDX-License-Identifier: Apache-2.0
#include "image/chromaticity.h"

#include <gtest/gtest.h>

#include <glm/matrix.hpp>
#include <limits>

namespace snell::image {
namespace {

const Chromaticities Rec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
const Chromaticities Aces{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}, {0.32168, 0.33767}};

void ExpectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance);
}

TEST(Chromaticity, Rec709HasThePublishedMatrix) {
  // IEC 61966-2-1, rows of RGB to XYZ
  const glm::dmat3 m = glm::transpose(RgbToXyz(Chromaticities()));
  ExpectNear(m[0], {0.4124, 0.3576, 0.1805}, 5e-5);
  ExpectNear(m[1], {0.2126, 0.7152, 0.0722}, 5e-5);
  ExpectNear(m[2], {0.0193, 0.1192, 0.9505}, 5e-5);
}

TEST(Chromaticity, Rec2020HasThePublishedConversion) {
  // ITU-R BT.2407, rows of linear BT.2020 to BT.709
  const glm::dmat3 m = glm::transpose(ToRec709(Rec2020));
  ExpectNear(m[0], {1.6605, -0.5876, -0.0728}, 1e-4);
  ExpectNear(m[1], {-0.1246, 1.1329, -0.0083}, 1e-4);
  ExpectNear(m[2], {-0.0182, -0.1006, 1.1187}, 1e-4);
}

TEST(Chromaticity, WhiteStaysWhite) {
  for (const Chromaticities& space : {Chromaticities(), Rec2020, Aces})
    ExpectNear(ToRec709(space) * glm::dvec3(1), glm::dvec3(1), 1e-9);
}

TEST(Chromaticity, Rec709PixelsAreNotTouched) {
  std::vector<vec3> pixels{vec3(0.1f, 0.7f, 1e-20f)};
  Chromaticities written;  // as a float file holds them
  written.white = {double(0.3127f), double(0.3290f)};
  ConvertToRec709(written, pixels);
  EXPECT_EQ(pixels[0], vec3(0.1f, 0.7f, 1e-20f));
}

TEST(Chromaticity, ImpossibleSpacesAreKnownAndIgnored) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Chromaticities zero{{0, 0}, {0, 0}, {0, 0}, {0, 0}};
  const Chromaticities line{{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}, {0.3127, 0.329}};
  const Chromaticities notNumbers{{nan, nan}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.329}};
  for (const Chromaticities& space : {zero, line, notNumbers}) {
    EXPECT_FALSE(IsUsable(space));
    std::vector<vec3> pixels{vec3(1, 2, 3)};
    ConvertToRec709(space, pixels);
    EXPECT_EQ(pixels[0], vec3(1, 2, 3));
  }
  EXPECT_TRUE(IsUsable(Aces));
}

}  // namespace
}  // namespace snell::image
