// SPDX-License-Identifier: Apache-2.0
//
// Motion blur against closed forms, against many pictures of moments, and motion of the camera against that of things.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/optics.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

// Seen along -z without perspective, a metre is eight pixels; samples in the middle of pixels.
std::string Scene(int spp, const char* integrator, const std::string& camera) {
  return fmt::format(
      "[render]\nsize = [40, 24]\nspp = {}\nfilter = 'box'\nfilter_radius = 1e-6\nintegrator = "
      "'{}'\n"
      "[camera]\ntype = 'orthographic'\nheight = 3\nposition = [0, 0, 9]\n{}\n",
      spp, integrator, camera);
}

constexpr const char* Glow = "material = { type = 'classic', emission = 1 }\n";

double XOf(int x) { return (x + 0.5 - 20) / 8; }
double YOf(int y) { return (12 - y - 0.5) / 8; }

TEST(Motion, ASlidingSquareCoversPixelsForItsTime) {
  // A square of a metre that moves two metres to the right, as a shape and as a mesh
  const std::string square =
      "[[object]]\nshape = 'rectangle'\ncorner = [-1.5, -0.5, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, "
      "1, 0]\n";
  const std::string mesh =
      "[[object]]\nmesh = { positions = [[-1.5, -0.5, 0], [-0.5, -0.5, 0], [-0.5, 0.5, 0], [-1.5, "
      "0.5, "
      "0]], triangles = [[0, 1, 2], [0, 2, 3]] }\n";
  const std::string motion = "motion = [{ time = 0 }, { time = 4, translate = [4, 0, 0] }]\n";
  for (const std::string& object : {square, mesh}) {
    for (const char* integrator : {"whitted", "path"}) {
      const Picture picture =
          PictureOf(Scene(1024, integrator, "shutter = [0, 2]") + object + Glow + motion);
      for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 40; ++x) {
          // Covered from when the right edge arrives until the left one does, in seconds of two
          const double from = std::clamp(XOf(x) + 0.5, 0.0, 2.0),
                       to = std::clamp(XOf(x) + 1.5, 0.0, 2.0);
          const double expected = std::abs(YOf(y)) < 0.5 ? (to - from) / 2 : 0;
          ASSERT_NEAR(PixelAt(picture, x, y).x, expected, 3e-3)
              << x << ' ' << y << ' ' << integrator;
        }
      }
    }
  }
}

TEST(Motion, ATurningBarSweepsASector) {
  // From pointing right to pointing up: at the radius r it covers 2 asin(h / 2r) of the quarter
  const std::string bar =
      "[[object]]\nshape = 'rectangle'\ncorner = [0, -0.1, 0]\nedge_u = [2, 0, 0]\nedge_v = [0, "
      "0.2, 0]\n"
      "motion = [{ time = 0 }, { time = 1, rotate = { axis = 'z', angle = 90 } }]\n";
  const Picture picture = PictureOf(Scene(1024, "whitted", "shutter = [0, 1]") + bar + Glow);
  int tested = 0;
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 40; ++x) {
      const double r = std::hypot(XOf(x), YOf(y)), half = std::asin(std::min(1.0, 0.1 / r));
      const double angle = std::atan2(YOf(y), XOf(x));
      if (r < 0.3 || r > 1.95 || angle < half || angle > Pi / 2 - half) continue;
      EXPECT_NEAR(PixelAt(picture, x, y).x, 2 * half / (Pi / 2), 4e-3) << x << ' ' << y;
      ++tested;
    }
  }
  EXPECT_GT(tested, 100);
}

// Things that move and turn, their shadows, and their image in a mirror.
std::string Busy(const std::string& camera) {
  return "[render]\nsize = [24, 18]\nspp = 256\nmax_depth = 4\n[camera]\nposition = [0, 1.2, 5]\n"
         "look_at = [0, 0.4, 0]\n" +
         camera +
         "\n[[light]]\ntype = 'point'\nposition = [2, 4, 3]\nintensity = 90\n"
         "[[object]]\nshape = 'plane'\nmaterial = { type = 'phong', diffuse = 'checker' }\n"
         "[[object]]\nshape = 'sphere'\ncenter = [0, 0, 0]\nradius = 0.5\ntranslate = [-0.8, 0.5, "
         "0]\n"
         "material = { type = 'phong', diffuse = [0.8, 0.3, 0.2] }\n"
         "motion = [{ time = 0 }, { time = 1, translate = [-0.2, 0.8, 0.3], scale = [1, 0.6, 1] "
         "}]\n"
         "[[object]]\nshape = 'box'\nmin = [-0.4, -0.4, -0.4]\nmax = [0.4, 0.4, 0.4]\n"
         "translate = [0.9, 0.6, 0]\nmaterial = { type = 'phong', diffuse = [0.2, 0.4, 0.8] }\n"
         "motion = [{ time = 0 }, { time = 1, rotate = { axis = [1, 2, 0], angle = 60 } }]\n"
         "[[object]]\nshape = 'rectangle'\ncorner = [-2, 0, -1.5]\nedge_u = [4, 0, 0]\nedge_v = "
         "[0, 2, 0]\n"
         "material = 'mirror'\n";
}

TEST(Motion, IsTheMeanOfManyMoments) {
  for (const char* integrator : {"whitted", "path"}) {
    const auto picture = [&](double open, double close, int spp) {
      std::string scene = Busy(fmt::format("shutter = [{}, {}]", open, close));
      scene.replace(scene.find("spp = 256"), 9,
                    fmt::format("spp = {}\nintegrator = '{}'", spp, integrator));
      return PictureOf(scene);
    };
    constexpr int Moments = 32;
    Picture mean = picture(0, 1, 1024);
    const Picture blurred = mean;
    std::fill(mean.rgb.begin(), mean.rgb.end(), 0.0f);
    for (int i = 0; i < Moments; ++i) {
      const Picture moment = picture((i + 0.5) / Moments, (i + 0.5) / Moments, 32);
      for (std::size_t k = 0; k < mean.rgb.size(); ++k) mean.rgb[k] += moment.rgb[k] / Moments;
    }
    double squares = 0;
    for (std::size_t k = 0; k < mean.rgb.size(); ++k)
      squares += std::pow(double(mean.rgb[k]) - double(blurred.rgb[k]), 2);
    const double error = std::sqrt(squares / double(mean.rgb.size()));
    EXPECT_LT(error, 0.05 * MeanOf(mean)) << integrator;
    EXPECT_NEAR(MeanOf(blurred), MeanOf(mean), 0.01 * MeanOf(mean)) << integrator;
    // It does blur
    EXPECT_GT(LargestDifference(blurred, picture(0, 0, 32)), 0.2);
  }
}

TEST(Motion, OfTheCameraIsThatOfEverythingElse) {
  const std::string ball =
      "[[object]]\nshape = 'sphere'\ncenter = [0, 0, 0]\nradius = 0.7\nmaterial = { type = "
      "'classic', "
      "emission = 'checker' }\n";
  const auto head = [](const char* camera) {
    return fmt::format(
        "[render]\nsize = [24, 18]\nspp = 64\n[camera]\nposition = [0, 0, 4]\n"
        "shutter = [1, 3]\n{}\n",
        camera);
  };
  const Picture flown = PictureOf(
      head("motion = [{ time = 1 }, { time = 3, position = [0.6, 0, 4], look_at = [0.6, 0, 0] }]") +
      ball);
  const Picture passed = PictureOf(
      head("") + ball + "motion = [{ time = 1 }, { time = 3, translate = [-0.6, 0, 0] }]\n");
  EXPECT_GT(MeanOf(flown), 0.05);
  // Samples at edges may fall to the other side
  double sum = 0;
  for (std::size_t k = 0; k < flown.rgb.size(); ++k)
    sum += std::abs(double(flown.rgb[k] - passed.rgb[k]));
  EXPECT_LT(sum / double(flown.rgb.size()), 2e-3 * MeanOf(passed));
}

TEST(Motion, OfAGroupCarriesItsMembers) {
  const std::string motion = "motion = [{ time = 0 }, { time = 1, translate = [1, 0, 0] }]\n";
  const std::string ball = "shape = 'sphere'\ncenter = [-0.5, 0, 0]\nradius = 0.4\n";
  const std::string head = Scene(64, "whitted", "shutter = [0, 1]");
  const Picture alone = PictureOf(head + "[[object]]\n" + ball + Glow + motion);
  const Picture carried =
      PictureOf(head + "[[group.g.object]]\n" + ball + Glow + "[[object]]\ngroup = 'g'\n" + motion);
  EXPECT_EQ(alone.rgb, carried.rgb);
  // Half by the group and half by itself
  const std::string half = "motion = [{ time = 0 }, { time = 1, translate = [0.5, 0, 0] }]\n";
  const Picture both = PictureOf(head + "[[group.g.object]]\n" + ball + Glow + half +
                                 "[[object]]\ngroup = 'g'\n" + half);
  EXPECT_EQ(alone.rgb, both.rgb);
}

TEST(Motion, ThatIsOverLeavesThePicture) {
  const std::string still =
      "[[object]]\nshape = 'box'\ntranslate = [1, 0, 0]\nmaterial = 'mirror'\n";
  const std::string head = "[render]\nsize = [24, 18]\nspp = 4\n[camera]\nposition = [0, 1, 5]\n";
  const std::string sky = "[environment]\ntop = [0.2, 0.5, 1]\n";
  const Picture wanted = PictureOf(head + sky + still);
  EXPECT_EQ(PictureOf(head + "shutter = [2, 3]\n" + sky + still +
                      "motion = [{ time = 0, translate = [7, 0, 0] }, { time = 1 }]\n")
                .rgb,
            wanted.rgb);
}

}  // namespace
}  // namespace snell::test
