// SPDX-License-Identifier: Apache-2.0
//
// Pixels and directions, parts of pictures, pixel filters.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "render/optics.h"
#include "render/scene_text.h"
#include "support/numeric.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

TEST(Cameras, APinholesDirections) {
  // The sky shows the height of each direction; cameras that lie on their side show the other axes
  const std::tuple<int, int, double, dvec3, dvec3> cases[] = {
      {24, 24, 40, {0, 0, -1}, {0, 1, 0}},  {32, 16, 90, {0, 0, -1}, {0, 1, 0}},
      {16, 32, 90, {1, 0.3, 2}, {0, 1, 0}}, {24, 20, 60, {0, 0, -1}, {1, 0, 0}},
      {24, 20, 150, {1, 1, 1}, {1, -2, 0}}, {8, 8, 1, {0, 1, 0}, {0, 0, 1}},
      {1, 1, 40, {0.1, -0.7, 3}, {0, 1, 0}}};
  for (const auto& [width, height, fov, direction, up] : cases) {
    View view{width, height, false, fov, {3, 2, 1}, direction, up};
    const Picture picture = PictureOf(view.Exact(1) + DirectionMeter);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        ASSERT_NEAR(PixelAt(picture, x, y).x, MeterReading(view.RayDirection(x + 0.5, y + 0.5)),
                    1e-6)
            << x << ' ' << y << ' ' << fov;
  }
}

TEST(Cameras, BothFormsOfAimingAgree) {
  View view{24, 16, false, 50, {3, 2, 1}, {-3, -1, -2}, {0, 1, 0}};
  const std::string byDirection = view.Exact(1);
  std::string byTarget = byDirection;
  const std::size_t at = byTarget.find("direction = ");
  byTarget.replace(at, byTarget.find('\n', at) - at, "look_at = [0, 1, -1]");
  EXPECT_EQ(LargestDifference(PictureOf(byDirection + DirectionMeter),
                              PictureOf(byTarget + DirectionMeter)),
            0);
}

TEST(Cameras, WhatAPinholeSees) {
  // The tangent of half the angle times the distance is half the picture's height
  View view{64, 64, false, 40, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}};
  const double half = 5 * std::tan(glm::radians(20.0)) / 2;
  const Picture picture = PictureOf(
      view.Exact(1) +
      fmt::format(
          "[[object]]\nshape = 'box'\nmin = [-{0}, -{0}, -1]\nmax = [{0}, 0, 0]\nmaterial = {{ "
          "type = 'classic', emission = 1 }}\n",
          half));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      EXPECT_EQ(PixelAt(picture, x, y).x, x >= 16 && x < 48 && y >= 32 && y < 48 ? 1 : 0);
}

TEST(Cameras, ParallelRays) {
  // The same size at any distance; width follows from the picture's shape
  View view{40, 20};
  view.extent = 5;
  for (const double z : {9.0, 0.0, -1000.0}) {
    const Picture picture = PictureOf(
        view.Exact(1) +
        fmt::format(
            "[[object]]\nshape = 'rectangle'\ncorner = [-2, -1, {}]\nedge_u = [5, 0, 0]\nedge_v "
            "= [0, 2, 0]\nmaterial = {{ type = 'classic', emission = 1 }}\n",
            z));
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 40; ++x)
        EXPECT_EQ(PixelAt(picture, x, y).x, x >= 12 && x < 32 && y >= 6 && y < 14 ? 1 : 0);
  }
}

TEST(Cameras, AreChosenByName) {
  const std::string scene =
      "[render]\nsize = [2, 2]\nspp = 1\n[[camera]]\nname = 'up'\nposition = [0, 0, 0]\nlook_at = "
      "[0, "
      "1, 0]\nup = [1, 0, 0]\nfov = 1\n[[camera]]\nname = 'down'\nposition = [0, 0, 0]\nlook_at = "
      "[0, "
      "-1, 0]\nup = [1, 0, 0]\nfov = 1\n";
  RenderOptions options;
  EXPECT_NEAR(MeanOf(PictureOf(scene + DirectionMeter, options)), 1, 1e-3);
  options.camera = "down";
  EXPECT_NEAR(MeanOf(PictureOf(scene + DirectionMeter, options)), 0, 1e-3);
}

// A scene with noise in every pixel.
const std::string Noisy =
    "[camera]\nposition = [0, 1, 5]\n[[light]]\ntype = 'sphere'\ncenter = [1, 3, 1]\nsamples = 2\n"
    "[[object]]\nshape = 'plane'\nmaterial = { type = 'phong', diffuse = 'checker', reflectivity = "
    "0.3 }\n[[object]]\nshape = 'sphere'\ncenter = [0, 1, 0]\nmaterial = 'glass'\n"
    "[render]\nsize = [61, 47]\nspp = 4\n";

TEST(Pictures, ACropIsAPartOfTheWholeBitForBit) {
  const Picture whole = PictureOf(Noisy);
  for (const std::array<int, 4> crop :
       {std::array{0, 0, 61, 47}, {13, 7, 50, 40}, {60, 46, 61, 47}}) {
    RenderOptions options;
    options.crop = crop;
    const Picture part = PictureOf(Noisy, options);
    ASSERT_EQ(part.width, crop[2] - crop[0]);
    ASSERT_EQ(part.height, crop[3] - crop[1]);
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        ASSERT_EQ(PixelAt(part, x, y), PixelAt(whole, x + crop[0], y + crop[1]));
  }
}

TEST(Pictures, PartsOfTheSamplesAverageToTheWhole) {
  RenderOptions options;
  const Picture whole = PictureOf(Noisy);
  Picture sum = whole;
  std::fill(sum.rgb.begin(), sum.rgb.end(), 0.0f);
  for (std::uint32_t first = 0; first < 4; ++first) {
    options.samples = {first, first + 1};
    const Picture part = PictureOf(Noisy, options);
    for (std::size_t i = 0; i < sum.rgb.size(); ++i) sum.rgb[i] += part.rgb[i] / 4;
  }
  EXPECT_LT(LargestDifference(sum, whole), 1e-5);
}

TEST(Pictures, AreTheSameForAnyNumberOfThreads) {
  RenderOptions options;
  const Picture all = PictureOf(Noisy);
  for (const int threads : {1, 2, 3}) {
    options.threads = threads;
    EXPECT_EQ(PictureOf(Noisy, options).rgb, all.rgb);
  }
}

TEST(Pictures, KeepTheirDigitsOverManySamples) {
  View view{1, 1};
  const Picture picture =
      PictureOf(view.Sampled(300000, 1) + "[environment]\ncolor = [0.7, 0.1, 1234.5]\n");
  EXPECT_FLOAT_EQ(picture.rgb[0], 0.7f);
  EXPECT_FLOAT_EQ(picture.rgb[1], 0.1f);
  EXPECT_FLOAT_EQ(picture.rgb[2], 1234.5f);
}

struct Filter {
  const char* name;
  double radius;                          // the usual one
  std::function<double(double)> density;  // of x in radii, need not be normalized
};

const Filter Filters[] = {{"box", 0.5, [](double) { return 1.0; }},
                          {"tent", 1, [](double x) { return 1 - std::abs(x); }},
                          {"gaussian", 1.5, [](double x) { return std::exp(-4.5 * x * x); }},
                          {"blackman-harris", 1.5, [](double x) {
                             return 0.35875 + 0.48829 * std::cos(Pi * x) +
                                    0.14128 * std::cos(2 * Pi * x) + 0.01168 * std::cos(3 * Pi * x);
                           }}};

std::string Filtered(const View& view, int spp, const Filter& filter, double radius) {
  std::string scene = view.Sampled(spp, 1);
  const std::string box = "filter = 'box'";
  scene.replace(scene.find(box), box.size(),
                fmt::format("filter = '{}'\nfilter_radius = {}", filter.name, radius));
  return scene;
}

TEST(Filters, AnEdgeIsTheFiltersIntegral) {
  // An edge in the middle of a pixel: each pixel shows how much of its filter lies beyond
  View view{17, 1};
  view.extent = 1;
  for (const Filter& filter : Filters) {
    for (const double wanted : {0.0, 3.0}) {
      const double radius = wanted > 0 ? wanted : filter.radius;
      const Picture picture = PictureOf(Filtered(view, 4096, filter, wanted) +
                                        "[[object]]\nshape = 'rectangle'\ncorner = [0, -9, "
                                        "0]\nedge_u = [30, 0, 0]\nedge_v = [0, 18, "
                                        "0]\nmaterial = { type = 'classic', emission = 1 }\n");
      const double whole = Integrate(-1, 1, 100, filter.density);
      for (int x = 0; x < 17; ++x) {
        const double at = std::clamp((8.0 - x) / radius, -1.0, 1.0);
        EXPECT_NEAR(PixelAt(picture, x, 0).x, Integrate(at, 1, 100, filter.density) / whole, 2e-3)
            << filter.name << ' ' << x;
      }
    }
  }
}

TEST(Filters, KeepTheIntegral) {
  // A small bright disk anywhere in the picture brings its area, whatever the filter
  View view{16, 16};
  view.extent = 16;
  for (const Filter& filter : Filters) {
    const Picture picture = PictureOf(
        Filtered(view, 4096, filter, 0) +
        "[[object]]\nshape = 'disk'\ncenter = [1.3, -0.4, 0]\nnormal = [0, 0, 1]\nradius = 0.8\n"
        "material = { type = 'classic', emission = 2 }\n");
    EXPECT_NEAR(MeanOf(picture) * 256, 2 * Pi * 0.64, 0.02) << filter.name;
  }
}

}  // namespace
}  // namespace snell::test
