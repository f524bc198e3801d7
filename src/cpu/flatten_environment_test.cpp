// SPDX-License-Identifier: Apache-2.0
//
// Sampling of environment maps: directions fall as the density says (χ² over the whole sphere), the density
// integrates to 1, and dull maps are left to chance.
#include "cpu/flatten_environment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cpu/flatten_texture.h"
#include "kernel/values.h"
#include "support/random.h"
#include "support/statistics.h"

namespace snell::cpu {
namespace {

using namespace kernel;

struct MapKernel {
  const RenderParams& params;
  const Image* images;
  const uint* texels;
  const Light* lights;

#include "kernel/scene_environment.h"
#include "kernel/scene_image.h"
};

// A flat scene that is a map and nothing else.
FlatScene FlatMap(int width, int height, const std::vector<float>& grey, float rotation = 0) {
  scene::Scene scene;
  scene::Image image;
  image.width = width;
  image.height = height;
  for (const float value : grey) image.floats.insert(image.floats.end(), {value, value, value, 1});
  scene.images.push_back(image);
  scene.environment.map = 0;
  scene.environment.rotation = rotation;
  FlatScene flat = {};
  flat.integrator = scene::Integrator::Path;
  FlattenTextures(scene, flat);
  FlattenEnvironment(scene.environment, flat);
  return flat;
}

MapKernel Bind(const FlatScene& flat) {
  return {flat.params, flat.images.data(), flat.texels.data(), flat.lights.data()};
}

std::vector<float> Random(int count, test::Random& random) {
  std::vector<float> values;
  for (int i = 0; i < count; ++i)
    values.push_back(random.UniformFloat() < 0.7f ? random.UniformFloat()
                                                  : 8 * random.UniformFloat());
  return values;
}

std::vector<float> OneTexel(int count, int which, float value) {
  std::vector<float> values(std::size_t(count), 0.1f);
  values[std::size_t(which)] = value;
  return values;
}

struct Case {
  const char* name;
  FlatScene flat;
};
std::vector<Case> Cases() {
  test::Random random(41);
  std::vector<Case> cases;
  cases.push_back({"random", FlatMap(13, 7, Random(13 * 7, random), 0.7f)});
  cases.push_back({"sun", FlatMap(32, 16, OneTexel(512, 5 * 32 + 31, 50000), 2)});
  cases.push_back({"pole", FlatMap(8, 4, OneTexel(32, 3, 10))});
  cases.push_back({"nadir", FlatMap(8, 4, OneTexel(32, 31, 10))});
  cases.push_back({"row", FlatMap(9, 1, OneTexel(9, 4, 3))});
  cases.push_back({"column", FlatMap(1, 9, OneTexel(9, 2, 3))});
  return cases;
}

// Cells of equal angles, for the density grows towards the poles as they shrink.
constexpr int Rows = 32;
constexpr int Columns = 64;

std::vector<double> Expected(MapKernel kernel, double count, double& integral) {
  constexpr int Fine = 16;
  std::vector<double> cells(Rows * Columns, 0);
  integral = 0;
  for (int row = 0; row < Rows * Fine; ++row) {
    for (int column = 0; column < Columns * Fine; ++column) {
      const float theta = Pi * (float(row) + 0.5f) / float(Rows * Fine);
      const float phi = 2 * Pi * (float(column) + 0.5f) / float(Columns * Fine) - Pi;
      const float sine = std::sin(theta);
      float pdf;
      kernel.MapLe(vec3(sine * std::cos(phi), std::cos(theta), sine * std::sin(phi)), pdf);
      const double share = double(pdf) * double(sine) * 2 * double(Pi) * double(Pi) /
                           (double(Rows * Fine) * double(Columns * Fine));
      cells[std::size_t(row / Fine * Columns + column / Fine)] += share * count;
      integral += share;
    }
  }
  return cells;
}

TEST(SampleMap, DirectionsFallAsTheDensitySays) {
  const std::vector<Case> cases = Cases();
  test::Random random(42);
  for (const Case& c : cases) {
    ASSERT_GT(c.flat.params.environment.density, 0) << c.name;
    EXPECT_EQ(c.flat.params.environment.share, 1) << c.name;
    MapKernel kernel = Bind(c.flat);
    const std::uint64_t count = test::Scaled(400000);
    std::vector<double> observed(Rows * Columns, 0);
    for (std::uint64_t i = 0; i < count; ++i) {
      const float u = random.UniformFloat(), v = random.UniformFloat();
      const vec3 d = kernel.SampleMap(vec2(u, v));
      ASSERT_NEAR(Length(d), 1, 1e-5) << c.name;
      const float theta = std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y);
      const int row = std::clamp(int(theta / Pi * Rows), 0, Rows - 1);
      const int column =
          std::clamp(int((std::atan2(d.z, d.x) / (2 * Pi) + 0.5f) * Columns), 0, Columns - 1);
      observed[std::size_t(row * Columns + column)] += 1;
    }
    double integral;
    const std::vector<double> expected = Expected(kernel, double(count), integral);
    EXPECT_NEAR(integral, 1, 4e-3) << c.name;
    EXPECT_GT(test::ChiSquarePValue(observed, expected), test::Sidak(0.01, int(cases.size())))
        << c.name;
  }
}

// No sample of a tiny sun in a large map is much brighter than the mean: its density follows the interpolated texels.
TEST(SampleMap, NoSampleStandsOut) {
  const FlatScene flat = FlatMap(64, 32, OneTexel(2048, 9 * 64 + 20, 50000));
  MapKernel kernel = Bind(flat);
  test::Random random(43);
  double sum = 0, largest = 0;
  constexpr int Count = 20000;
  for (int i = 0; i < Count; ++i) {
    const vec3 d = kernel.SampleMap(vec2(random.UniformFloat(), random.UniformFloat()));
    float pdf;
    const double L = double(kernel.MapLe(d, pdf).x);
    ASSERT_GT(pdf, 0);
    sum += L / double(pdf);
    largest = std::max(largest, L / double(pdf));
  }
  EXPECT_LT(largest, 1.2 * sum / Count);
  // The texel and what it lends its neighbours fill one texel's solid angle
  const double solidAngle = 2 * double(Pi) * double(Pi) / 2048 * double(RowSine(9, 32));
  EXPECT_NEAR(sum / Count, 50000 * solidAngle, 0.02 * 50000 * solidAngle);
}

TEST(FlattenEnvironment, DullAndBlackMapsAreLeftToChance) {
  for (const float grey : {0.0f, 0.3f, 7.0f}) {
    const FlatScene flat = FlatMap(16, 8, std::vector<float>(128, grey));
    EXPECT_EQ(flat.params.environment.density, 0) << grey;
    EXPECT_EQ(flat.params.environment.share, 0) << grey;
    float pdf;
    EXPECT_NEAR(Bind(flat).MapLe(vec3(0.6f, 0, 0.8f), pdf).x, grey, 1e-6f);
    EXPECT_EQ(pdf, 0);
  }
}

// The middle of the picture is −z, right of it +x, its upper border +y; a turn moves all that counter-clockwise.
TEST(MapLe, ShowsEachTexelWhereItBelongs) {
  std::vector<float> grey(32);
  for (std::size_t i = 0; i < 32; ++i) grey[i] = float(i);
  const float eighth = Pi / 8, low = Pi / 8;
  const auto at = [&](float azimuth, float elevation) {  // from −z by +x
    return vec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                -std::cos(elevation) * std::cos(azimuth));
  };
  const FlatScene flat = FlatMap(8, 4, grey);
  MapKernel kernel = Bind(flat);
  float pdf;
  EXPECT_NEAR(kernel.MapLe(at(eighth, low), pdf).x, 8 + 4, 1e-3f);
  EXPECT_NEAR(kernel.MapLe(at(-eighth, low), pdf).x, 8 + 3, 1e-3f);
  EXPECT_NEAR(kernel.MapLe(at(5 * eighth, -low), pdf).x, 16 + 6, 1e-3f);
  EXPECT_NEAR(kernel.MapLe(at(5 * eighth, 3 * low), pdf).x, 6, 1e-3f);
  // Turned by a quarter: what was right of the middle lies ahead
  const FlatScene turned = FlatMap(8, 4, grey, Pi / 2);
  EXPECT_NEAR(Bind(turned).MapLe(at(eighth, low), pdf).x, 8 + 6, 1e-3f);
}

// At its very beginning, where the density may be 0, too.
TEST(FlattenEnvironment, LinearDensitiesAreSampledEverywhere) {
  for (const float a : {0.0f, 1e-20f, 1.0f}) {
    for (const float b : {0.0f, 1e-20f, 1.0f}) {
      for (const float u : {0.0f, 1e-30f, 0.5f, 0.99999994f}) {
        const float x = kernel::SampleLinear(u, a, b);
        EXPECT_TRUE(x >= 0 && x <= 1) << u << " " << a << " " << b << ": " << x;
      }
    }
  }
}

}  // namespace
}  // namespace snell::cpu
