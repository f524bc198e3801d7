// SPDX-License-Identifier: Apache-2.0
//
// The sky against published figures of daylight, the atmosphere's closed form above, the sun's position against
// published ones.
#include "scene/sky/sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/sky/atmosphere.h"
#include "scene/sky/sun_position.h"

namespace snell::scene {
namespace {

using glm::dvec3;
constexpr double Pi = std::numbers::pi;
constexpr double Degree = Pi / 180;

dvec3 TexelOf(const Image& map, int x, int y) {
  const float* texel = &map.floats[4 * std::size_t(y * map.width + x)];
  return {double(texel[0]), double(texel[1]), double(texel[2])};
}

double Luminance(const dvec3& rgb) { return glm::dot(rgb, dvec3(0.2126, 0.7152, 0.0722)); }

// Lux on level ground: of the sky alone, and with the sun.
struct Lux {
  double sky = 0;
  double all = 0;
};
Lux LuxOf(double elevation, double turbidity) {
  SkyModel model;
  model.elevation = elevation * Degree;
  model.turbidity = turbidity;
  const SkyLight light = LightOf(model);
  Lux lux;
  for (int y = 0; y < light.map.height / 2; ++y) {
    const double zenith = Pi * (y + 0.5) / light.map.height;
    const double factor = 683 * std::cos(zenith) * std::sin(zenith) * 2 * Pi * Pi /
                          light.map.width / light.map.height;
    for (int x = 0; x < light.map.width; ++x)
      lux.sky += Luminance(TexelOf(light.map, x, y)) * factor;
  }
  const double sine = std::max(std::sin(model.elevation), 0.0);
  lux.all = lux.sky + 683 * sine * Luminance(dvec3(light.sunIrradiance));
  return lux;
}

// Illuminances of clear days as handbooks have them: some 120 klx under a high sun, an eighth to a quarter of it from
// the sky; 400 to 1000 lx when the sun sets; 3.4 lx at the end of civil twilight.
TEST(Sky, LightsTheGroundAsDaysDo) {
  const Lux noon = LuxOf(90, 2);
  EXPECT_GT(noon.all, 105e3);
  EXPECT_LT(noon.all, 135e3);
  EXPECT_GT(noon.sky, 0.1 * noon.all);
  EXPECT_LT(noon.sky, 0.25 * noon.all);
  const Lux morning = LuxOf(30, 2);
  EXPECT_GT(morning.all, 45e3);
  EXPECT_LT(morning.all, 65e3);
  const Lux sunset = LuxOf(0, 2);
  EXPECT_GT(sunset.all, 400);
  EXPECT_LT(sunset.all, 1200);
  const Lux twilight = LuxOf(-6, 2);
  EXPECT_GT(twilight.all, 1.5);
  EXPECT_LT(twilight.all, 8);
}

TEST(Sky, HazeTurnsSunlightIntoSkylight) {
  const Lux clear = LuxOf(50, 2), hazy = LuxOf(50, 6);
  EXPECT_GT(hazy.sky, 1.5 * clear.sky);
  EXPECT_LT(hazy.all - hazy.sky, 0.8 * (clear.all - clear.sky));
}

TEST(Sky, IsBlueAboveAndBrightAroundTheSun) {
  SkyModel model;
  model.elevation = 30 * Degree;
  const Image map = LightOf(model).map;
  const dvec3 zenith = TexelOf(map, 0, 0);
  EXPECT_GT(zenith.z, zenith.y);
  EXPECT_GT(zenith.y, zenith.x);
  const int row = int(60.0 / 180 * map.height), middle = map.width / 2;
  EXPECT_GT(Luminance(TexelOf(map, middle, row)), 10 * Luminance(TexelOf(map, 0, row)));
  double last = 1e30;
  for (const int away : {4, 16, 64, 128}) {
    const double here = Luminance(TexelOf(map, middle + away, row));
    EXPECT_LT(here, last) << away;
    last = here;
  }
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width / 2; ++x) {
      const dvec3 left = TexelOf(map, x, y);
      ASSERT_EQ(left, TexelOf(map, map.width - 1 - x, y));
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(left[c] >= 0 && std::isfinite(left[c]));
      ASSERT_GT(Luminance(left), 0);
    }
  }
}

// Straight up, the exponential layers of air have the thickness of their scale height.
TEST(Atmosphere, TransmitsByTheThicknessOfItsLayers) {
  const Atmosphere air(1, {});
  const Bands up = air.Transmittance(0, 1);
  for (const int band : {0, 3}) {  // where ozone takes little
    const double coefficient = 1.24062e-6 * std::pow(BandNanometres(band) / 1000, -4);
    EXPECT_NEAR(double(up[std::size_t(band)]), std::exp(-coefficient * 8000), 0.006) << band;
  }
  EXPECT_EQ(air.Transmittance(0, -0.1), Bands{});
  const Bands low = air.Transmittance(0, 0.1);
  for (std::size_t i = 0; i < BandCount; ++i) EXPECT_LT(low[i], up[i]);
  EXPECT_LT(low[0], low[BandCount - 1]);
}

TEST(Sky, StandsInTheSceneWhereTheSunIs) {
  SkyModel model;
  model.elevation = 20 * Degree;
  model.azimuth = 90 * Degree;
  Scene scene;
  AddSky(model, 2, scene);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.environment.sun, 0);
  const vec3 toSun = -scene.lights[0].direction;
  EXPECT_NEAR(toSun.x, std::cos(20 * Degree), 1e-6);
  EXPECT_NEAR(toSun.y, std::sin(20 * Degree), 1e-6);
  EXPECT_NEAR(toSun.z, 0, 1e-6);
  // The map's middle, −z, turned clockwise as seen from above, is +x
  EXPECT_NEAR(scene.environment.rotation, -Pi / 2, 1e-6);
  EXPECT_EQ(scene.lights[0].strength, 2);

  Scene night;
  model.elevation = -10 * Degree;
  AddSky(model, 1, night);
  EXPECT_TRUE(night.lights.empty());
  EXPECT_EQ(night.environment.sun, -1);
}

// Reda and Andreas 2004, "Solar position algorithm for solar radiation applications", table A5.1; refraction, which
// is in its zenith angle, lifts the sun by 0.02 degrees there.
TEST(SunPosition, IsThatOfThePublishedExample) {
  const auto days = DaysOf("2003-10-17T12:30:30-07:00");
  ASSERT_TRUE(days);
  const SunPosition sun = SunAt(*days, 39.742476 * Degree, -105.1786 * Degree);
  EXPECT_NEAR(sun.elevation / Degree, 90 - 50.11162 - 0.02, 0.015);
  EXPECT_NEAR(sun.azimuth / Degree, 194.34024, 0.02);
}

TEST(SunPosition, RisesInTheEast) {
  const SunPosition morning = SunAt(*DaysOf("2026-03-20T08:00Z"), 0.8, 0);
  EXPECT_GT(morning.azimuth / Degree, 90);
  EXPECT_LT(morning.azimuth / Degree, 150);
  EXPECT_GT(morning.elevation, 0);
  EXPECT_LT(SunAt(*DaysOf("2026-03-20T23:00Z"), 0.8, 0).elevation, 0);
}

TEST(SunPosition, ReadsTimes) {
  EXPECT_EQ(DaysOf("2000-01-01T12:00Z"), 0.0);
  EXPECT_EQ(DaysOf("2000-01-02 00:00:00Z"), 0.5);
  EXPECT_NEAR(*DaysOf("2000-01-01T12:00+02:00"), -2.0 / 24, 1e-12);
  EXPECT_NEAR(*DaysOf("2000-01-01T12:00-05:30"), 5.5 / 24, 1e-12);
  for (const char* text :
       {"", "2000", "2000-01-01", "2000-01-01T12:00", "2000-13-01T12:00Z", "2001-02-29T12:00Z",
        "2000-01-01T24:00Z", "2000-01-01T12:00Zx", "2000-01-01T12:0Z", "2000-1-01T12:00Z"})
    EXPECT_FALSE(DaysOf(text)) << text;
}

}  // namespace
}  // namespace snell::scene
