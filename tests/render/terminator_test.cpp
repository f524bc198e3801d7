// SPDX-License-Identifier: Apache-2.0
//
// The border of light and shadow on coarse meshes with smooth normals: no triangle may show there, and no
// light may come through a cover that lies closer to the mesh than the smooth surface does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/scene_text.h"

namespace snell::test {
namespace {

// The unit sphere of `rows` bands with normals of its own if they are smooth.
std::string Ball(int rows, bool smooth, const std::string& more) {
  const int columns = 2 * rows;
  std::string points, triangles;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double theta = std::numbers::pi * row / rows,
                   phi = 2 * std::numbers::pi * column / columns;
      points += fmt::format("[{:.9f}, {:.9f}, {:.9f}], ", std::sin(theta) * std::cos(phi),
                            std::cos(theta), -std::sin(theta) * std::sin(phi));
      if (row == rows) continue;
      const int right = (column + 1) % columns;
      const int a = row * columns + column, b = a + columns;
      const int c = row * columns + right, d = c + columns;
      triangles += fmt::format("[{}, {}, {}], [{}, {}, {}], ", a, b, d, a, d, c);
    }
  }
  return fmt::format(
      "[[object]]\nmaterial = {{ type = 'diffuse', color = 1 }}\n{}\n"
      "mesh = {{ positions = [{}], triangles = [{}], {} }}\n",
      more, points, triangles, smooth ? "normals = [" + points + "]" : "smooth = 0");
}

// From the left, so that the border crosses triangles.
const std::string Sun =
    "[[light]]\ntype = 'directional'\ndirection = [1, -0.35, 0.2]\nirradiance = 3.14159265\n";

View BallView() {
  View view;
  view.width = view.height = 48;
  view.extent = 1.1;
  return view;
}

class Terminator : public testing::TestWithParam<const char*> {};

TEST_P(Terminator, ACoarseBallLooksLikeAFineOne) {
  const std::string view = BallView().Sampled(16, 1);
  const Picture coarse = PictureOf(view + Sun + Ball(8, true, GetParam()));
  const Picture fine = PictureOf(view + Sun + Ball(96, true, GetParam()));
  // With the triangles' own horizon it would be 0.15
  EXPECT_LT(LargestDifference(coarse, fine), 0.04);
}

INSTANTIATE_TEST_SUITE_P(Placed, Terminator,
                         testing::Values("", "rotate = { axis = [0, 1, 0], angle = 11.25 }",
                                         "scale = [1, -1, 1]"));

TEST(CoveredTerminator, NoLightComesThroughACover) {
  const std::string view = BallView().Sampled(16, 1);
  // The coarse ball's triangles lie up to 0.04 below the smooth surface
  const Picture picture = PictureOf(view + Sun + Ball(8, true, "") +
                                    Ball(8, false, "scale = 1.003\nvisible_to_camera = false"));
  EXPECT_EQ(MeanOf(picture), 0);
}

}  // namespace
}  // namespace snell::test
