// SPDX-License-Identifier: Apache-2.0
//
// Meshes that change their shape while the shutter is open: against closed forms, motion of whole objects, and pictures of
// moments.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/scene_text.h"

namespace snell::test {
namespace {

// Seen along -z without perspective, a metre is eight pixels; samples in the middle of pixels.
std::string Head(int spp, const char* integrator, const std::string& camera) {
  return fmt::format(
      "[render]\nsize = [40, 24]\nspp = {}\nfilter = 'box'\nfilter_radius = 1e-6\nintegrator = "
      "'{}'\n[camera]\ntype = 'orthographic'\nheight = 3\nposition = [0, 0, 9]\n{}\n",
      spp, integrator, camera);
}

constexpr const char* Glow = "material = { type = 'classic', emission = 1 }\n";

// A square of a metre on the x axis, and its corners when the upper edge is pushed along by `push`, all by `x`.
std::string Corners(double push, double x) {
  return fmt::format("positions = [[{0}, 0, 0], [{1}, 0, 0], [{2}, 1, 0], [{3}, 1, 0]]", x - 0.5,
                     x + 0.5, x + 0.5 + push, x - 0.5 + push);
}
std::string Square() {
  return "[[object]]\nmesh = { " + Corners(0, 0) + ", triangles = [[0, 1, 2], [0, 2, 3]] }\n";
}

double XOf(int x) { return (x + 0.5 - 20) / 8; }
double YOf(int y) { return (12 - y - 0.5) / 8; }

TEST(Deformation, AShearingSquareCoversPixelsForItsTime) {
  const std::string keys = "deformation = [{ time = 0 }, { time = 2, " + Corners(1.5, 0) + " }]\n";
  for (const char* integrator : {"whitted", "path"}) {
    const Picture picture =
        PictureOf(Head(1024, integrator, "shutter = [0, 2]") + Square() + Glow + keys);
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 40; ++x) {
        // At the height h its middle goes from 0 to 1.5 h
        const double h = YOf(y), way = 1.5 * h;
        const double from = std::clamp((XOf(x) - 0.5) / way, 0.0, 1.0);
        const double to = std::clamp((XOf(x) + 0.5) / way, 0.0, 1.0);
        const double expected = h > 0 && h < 1 ? to - from : 0;
        ASSERT_NEAR(PixelAt(picture, x, y).x, expected, 4e-3) << x << ' ' << y << integrator;
      }
    }
  }
}

// A lit, smooth roof with its shadow on a floor; `more` is what it does meanwhile.
std::string Roof(const std::string& camera, const std::string& more) {
  return "[render]\nsize = [32, 24]\nspp = 256\n[camera]\nposition = [0, 2, 5]\n"
         "look_at = [0, 0.6, 0]\n" +
         camera +
         "\n[[light]]\ntype = 'point'\nposition = [2, 5, 3]\nintensity = 90\n"
         "[[object]]\nshape = 'plane'\nmaterial = { type = 'phong', diffuse = 'checker' }\n"
         "[[object]]\nmesh = { positions = [[-1, 0.4, 0.5], [0, 0.9, 0.5], [1, 0.4, 0.5], [-1, "
         "0.4, "
         "-0.5], [0, 0.9, -0.5], [1, 0.4, -0.5]], polygons = [[0, 1, 4, 3], [1, 2, 5, 4]], smooth "
         "= "
         "80 }\nmaterial = { type = 'phong', diffuse = [0.8, 0.3, 0.2] }\n" +
         more;
}

TEST(Deformation, ThatMovesAllVerticesIsMotion) {
  const std::string keys =
      "deformation = [{ time = 0 }, { time = 1, positions = [[-0.5, 0.6, 0.5], [0.5, 1.1, 0.5], "
      "[1.5, 0.6, 0.5], [-0.5, 0.6, -0.5], [0.5, 1.1, -0.5], [1.5, 0.6, -0.5]] }]\n";
  const std::string motion = "motion = [{ time = 0 }, { time = 1, translate = [0.5, 0.2, 0] }]\n";
  const Picture a = PictureOf(Roof("shutter = [0, 1]", keys));
  const Picture b = PictureOf(Roof("shutter = [0, 1]", motion));
  // Samples at edges may fall to the other side
  double sum = 0;
  for (std::size_t k = 0; k < a.rgb.size(); ++k)
    sum += std::abs(double(a.rgb[k]) - double(b.rgb[k]));
  EXPECT_LT(sum / double(a.rgb.size()), 1e-3 * MeanOf(a));
  EXPECT_GT(LargestDifference(a, PictureOf(Roof("", keys))), 0.05) << "it does blur";
  // Both at once: half by each
  const Picture both =
      PictureOf(Roof("shutter = [0, 1]",
                     "motion = [{ time = 0 }, { time = 1, translate = [0.5, 0.2, 0] }]\n"
                     "deformation = [{ time = 0 }, { time = 1 }]\n"));
  EXPECT_EQ(both.rgb, b.rgb) << "keys that are alike change nothing";
}

TEST(Deformation, IsTheMeanOfManyMoments) {
  const std::string keys =
      "deformation = [{ time = 0 }, { time = 1, positions = [[-1, 0.9, 0.5], [0, 0.3, 0.7], [1, "
      "0.9, 0.5], [-1.2, 0.4, -0.5], [0, 0.5, -0.5], [1.3, 0.4, -0.5]] }]\n";
  constexpr int Moments = 32;
  std::string whole = Roof("shutter = [0, 1]", keys);
  whole.replace(whole.find("spp = 256"), 9, "spp = 1024");
  const Picture blurred = PictureOf(whole);
  Picture mean = blurred;
  std::fill(mean.rgb.begin(), mean.rgb.end(), 0.0f);
  for (int i = 0; i < Moments; ++i) {
    std::string scene = Roof(fmt::format("shutter = [{0}, {0}]", (i + 0.5) / Moments), keys);
    scene.replace(scene.find("spp = 256"), 9, "spp = 32");
    const Picture moment = PictureOf(scene);
    for (std::size_t k = 0; k < mean.rgb.size(); ++k) mean.rgb[k] += moment.rgb[k] / Moments;
  }
  double squares = 0;
  for (std::size_t k = 0; k < mean.rgb.size(); ++k)
    squares += std::pow(double(mean.rgb[k]) - double(blurred.rgb[k]), 2);
  EXPECT_LT(std::sqrt(squares / double(mean.rgb.size())), 0.05 * MeanOf(mean));
  EXPECT_NEAR(MeanOf(blurred), MeanOf(mean), 0.005 * MeanOf(mean));
}

TEST(Deformation, OfSubdividedMeshesMovesTheLimitSurface) {
  const std::string cage =
      "subdivision = { levels = 2 }\ndeformation = [{ time = 0 }, { time = 1, positions = [[-0.5, "
      "0.6, 0.5], [0.5, 1.1, 0.5], [1.5, 0.6, 0.5], [-0.5, 0.6, -0.5], [0.5, 1.1, -0.5], [1.5, "
      "0.6, "
      "-0.5]] }]\n";
  const Picture a = PictureOf(Roof("shutter = [0, 1]", cage));
  const Picture b = PictureOf(
      Roof("shutter = [0, 1]",
           "subdivision = { levels = 2 }\nmotion = [{ time = 0 }, { time = 1, translate = [0.5, "
           "0.2, 0] }]\n"));
  double sum = 0;
  for (std::size_t k = 0; k < a.rgb.size(); ++k)
    sum += std::abs(double(a.rgb[k]) - double(b.rgb[k]));
  EXPECT_LT(sum / double(a.rgb.size()), 1e-3 * MeanOf(a));
}

}  // namespace
}  // namespace snell::test
