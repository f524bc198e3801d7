// SPDX-License-Identifier: Apache-2.0
//
// How much light arrives: form factors of area lights, powers, the laws of falloff, a light's range, a spot's
// cone. The floor is matt and white; its radiance is the irradiance over π.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "render/optics.h"
#include "render/scene_text.h"
#include "support/polygon_light.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

const std::string Floor =
    "[[object]]\nshape = 'plane'\nmaterial = { type = 'diffuse', color = 1 }\n";

// The irradiance of the origin, with the normal +y, by light that is given as a scene's text.
double IrradianceBy(const std::string& light, int spp = 64) {
  return MeanOf(PictureOf(FromAbove(1, 1, 1e-4).Sampled(spp, 1) + Floor + light)) * Pi;
}

TEST(Lights, PolygonsGiveLambertsIrradiance) {
  for (auto [vertices, radiance] : TrianglesOverFloor) {
    // Turn the shining side to the floor
    const dvec3 front = glm::cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
    if (glm::dot(front, vertices[0]) > 0) std::swap(vertices[1], vertices[2]);
    EXPECT_NEAR(PolygonIrradiance({0, 0, 0}, {0, 1, 0}, vertices) * 0.5 / Pi, radiance, 1e-6);
    const std::string light = fmt::format(
        "[[light]]\ntype = 'triangle'\nvisible = false\nvertices = [{}, {}, {}]\nsamples = "
        "1024\n",
        Toml(vertices[0]), Toml(vertices[1]), Toml(vertices[2]));
    EXPECT_NEAR(IrradianceBy(light, 256) * 0.5 / Pi, radiance, 1e-3 * radiance);
  }
}

TEST(Lights, ADiskAbove) {
  // E = π sin² of the angle under which the radius is seen
  for (const double height : {0.3, 1.0, 4.0}) {
    const double expected = Pi * 0.64 / (0.64 + height * height);
    EXPECT_NEAR(
        IrradianceBy(fmt::format("[[light]]\ntype = 'disk'\ncenter = [0, {}, 0]\nradius = 0.8\n"
                                 "samples = 256\nvisible = false\n",
                                 height)),
        expected, 1e-3 * expected);
  }
}

TEST(Lights, ASphereSomewhere) {
  // E = π (r/d)² cos θ while all of it is above the floor
  const std::pair<dvec3, double> spheres[] = {
      {{0, 2, 0}, 0.5}, {{0, 2, 0}, 1.99}, {{3, 2, 1}, 1.5}, {{-1, 0.2, 0}, 0.1}};
  for (const auto& [center, radius] : spheres) {
    const double d2 = glm::dot(center, center);
    const double expected = Pi * radius * radius / d2 * center.y / std::sqrt(d2);
    for (const char* kind : {"sphere", "point"}) {
      // A point light with a radius has the intensity of that sphere
      const std::string strength =
          *kind == 's'
              ? fmt::format("center = {}\nvisible = false", Toml(center))
              : fmt::format("position = {}\nintensity = {}", Toml(center), Pi * radius * radius);
      EXPECT_NEAR(
          IrradianceBy(fmt::format("[[light]]\ntype = '{}'\nradius = {}\nsamples = 64\n{}\n", kind,
                                   radius, strength)),
          expected, 1e-3 * expected)
          << kind;
    }
  }
}

TEST(Lights, ARectangleAcross) {
  const std::vector<dvec3> corners = {{1, 0.2, -1}, {1, 0.2, 1}, {2, 1.2, 1}, {2, 1.2, -1}};
  const double expected = PolygonIrradiance({0, 0, 0}, {0, 1, 0}, corners);
  const std::string light =
      "[[light]]\ntype = 'rectangle'\ncorner = [1, 0.2, -1]\nsamples = 256\nvisible = false\n";
  const double front = IrradianceBy(light + "edge_u = [0, 0, 2]\nedge_v = [1, 1, 0]\n");
  const double back = IrradianceBy(light + "edge_u = [1, 1, 0]\nedge_v = [0, 0, 2]\n");
  // (0, 0, 2) × (1, 1, 0) points to −x
  EXPECT_NEAR(front, expected, 1e-3 * expected);
  EXPECT_EQ(back, 0);
}

TEST(Lights, PowerIsAllThatIsSentOut) {
  // power = π · area · radiance, for a sphere over its whole surface
  const std::pair<const char*, double> lights[] = {
      {"type = 'rectangle'\ncorner = [-1, 3, -1]\nedge_u = [2, 0, 0]\nedge_v = [0, 0, 3]\n", 6},
      {"type = 'triangle'\nvertices = [[-1, 3, -1], [1, 3, -1], [0, 3, 2]]\n", 3},
      {"type = 'disk'\ncenter = [0, 3, 0]\nradius = 0.5\n", Pi * 0.25},
      {"type = 'sphere'\ncenter = [0, 3, 0]\nradius = 0.5\n", Pi}};
  for (const auto& [light, area] : lights) {
    const std::string text = fmt::format("[[light]]\n{}samples = 16\nvisible = false\n", light);
    const double byPower = IrradianceBy(text + fmt::format("power = {}\n", 7 * Pi * area));
    const double byRadiance = IrradianceBy(text + "radiance = 7\n");
    EXPECT_NEAR(byPower, byRadiance, 1e-6 * byRadiance) << light;
    EXPECT_GT(byRadiance, 0.1);
  }
}

TEST(Lights, TheirSurfacesAreSeenFromTheFront) {
  // Radiance 3 from the shining side, black from behind; with `visible = false` what is behind them
  View view{8, 8};
  view.extent = 0.5;
  const std::pair<const char*, bool> lights[] = {
      {"type = 'rectangle'\ncorner = [-1, -1, 0]\nedge_u = [2, 0, 0]\nedge_v = [0, 2, 0]\n", true},
      {"type = 'rectangle'\ncorner = [-1, -1, 0]\nedge_u = [0, 2, 0]\nedge_v = [2, 0, 0]\n", false},
      {"type = 'triangle'\nvertices = [[-3, -2, 0], [3, -2, 0], [0, 5, 0]]\n", true},
      {"type = 'triangle'\nvertices = [[3, -2, 0], [-3, -2, 0], [0, 5, 0]]\n", false},
      {"type = 'disk'\nnormal = [0, 0, 1]\n", true},
      {"type = 'disk'\nnormal = [0, 0, -1]\n", false},
      {"type = 'sphere'\n", true}};
  for (const auto& [light, front] : lights) {
    const std::string text = view.Exact(1) +
                             "[environment]\ncolor = 0.5\n[[light]]\nradiance = 3\n" +
                             "color = [1, 0.5, 0]\n" + light;
    const Picture shown = PictureOf(text), hidden = PictureOf(text + "visible = false\n");
    EXPECT_EQ(PixelAt(shown, 3, 3), front ? dvec3(3, 1.5, 0) : dvec3(0.0)) << light;
    EXPECT_EQ(PixelAt(hidden, 3, 3), dvec3(0.5)) << light;
  }
}

// A picture of the floor under one light at (0, 2, 0), compared with E(p)/π.
template <class Irradiance>
void ExpectOnFloor(const std::string& light, const Irradiance& irradiance) {
  const View view = FromAbove(48, 48, 8);
  const Picture picture = PictureOf(view.Exact(1) + Floor + light);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      dvec3 p = view.RayOrigin(x + 0.5, y + 0.5);
      p.y = 0;
      const double distance = glm::length(p - dvec3(0, 2, 0)), expected = irradiance(distance) / Pi;
      ASSERT_NEAR(PixelAt(picture, x, y).x, expected, 3e-6 + 1e-5 * expected) << p.x << ' ' << p.z;
    }
  }
}

TEST(Lights, FalloffLaws) {
  const std::string point = "[[light]]\ntype = 'point'\nposition = [0, 2, 0]\nintensity = 5\n";
  ExpectOnFloor(point, [](double d) { return 5 / (d * d) * (2 / d); });
  ExpectOnFloor(point + "falloff = 'linear'\nfalloff_factor = 0.5\n",
                [](double d) { return 5 / (0.5 * d) * (2 / d); });
  ExpectOnFloor(point + "falloff = 'none'\n", [](double d) { return 5 * (2 / d); });
}

TEST(Lights, ARangeEndsThem) {
  ExpectOnFloor("[[light]]\ntype = 'point'\nposition = [0, 2, 0]\nrange = 4\n", [](double d) {
    const double window = std::max(1 - std::pow(d / 4, 4), 0.0);
    return window * window / (d * d) * (2 / d);
  });
}

TEST(Lights, ASpotsCone) {
  for (const auto& [inner, outer] : {std::pair(20.0, 40.0), std::pair(0.0, 60.0)}) {
    const double cosInner = std::cos(glm::radians(inner)), cosOuter = std::cos(glm::radians(outer));
    ExpectOnFloor(fmt::format("[[light]]\ntype = 'spot'\nposition = [0, 2, 0]\nintensity = 9\n"
                              "inner_angle = {}\nouter_angle = {}\n",
                              inner, outer),
                  [&](double d) {
                    const double t =
                        std::clamp((2 / d - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
                    return t * t * (3 - 2 * t) * 9 / (d * d) * (2 / d);
                  });
  }

  // The usual inner cone is four fifths of the outer; both forms of aiming agree
  const std::string view = FromAbove(32, 32, 8).Exact(1) + Floor;
  const std::string spot = "[[light]]\ntype = 'spot'\nposition = [1, 2, 0]\nouter_angle = 35\n";
  EXPECT_EQ(LargestDifference(PictureOf(view + spot + "look_at = [0.5, 0, 0.5]\n"),
                              PictureOf(view + spot +
                                        "direction = [-0.5, -2, 0.5]\n"
                                        "inner_angle = 28\n")),
            0);
}

TEST(Lights, Add) {
  const std::string view = FromAbove(24, 24, 6).Exact(1) + Floor;
  const std::string a = "[[light]]\ntype = 'point'\nposition = [1, 2, 0]\ncolor = [1, 0, 0.5]\n";
  const std::string b = "[[light]]\ntype = 'directional'\ndirection = [1, -1, 0]\n";
  const std::string c = "[[light]]\ntype = 'ambient'\nradiance = 0.25\ncolor = '#ff0000'\n";
  Picture sum = PictureOf(view + a);
  for (const std::string& light : {b, c}) {
    const Picture one = PictureOf(view + light);
    for (std::size_t i = 0; i < sum.rgb.size(); ++i) sum.rgb[i] += one.rgb[i];
  }
  EXPECT_LT(LargestDifference(sum, PictureOf(view + a + b + c)), 1e-6);
  EXPECT_EQ(PixelAt(PictureOf(view + c), 5, 5), dvec3(0.25, 0, 0));
  EXPECT_NEAR(PixelAt(PictureOf(view + b), 5, 5).x, std::sqrt(0.5) / Pi, 1e-6);
}

}  // namespace
}  // namespace snell::test
