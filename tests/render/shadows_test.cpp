// SPDX-License-Identifier: Apache-2.0
//
// Shadows of an edge on a floor, by similar triangles: where hard ones lie, how wide soft ones are and how
// dark; and the tinted shadows of clear bodies. The floor is seen from above, the edge runs along z at x = 0
// with its solid side at x > 0; the camera does not see it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "render/optics.h"
#include "render/scene_text.h"
#include "support/polygon_light.h"

namespace snell::test {
namespace {

const std::string Floor =
    "[[object]]\nshape = 'plane'\nmaterial = { type = 'diffuse', color = 1 }\n";

std::string EdgeAt(double height) {
  return fmt::format(
      "[[object]]\nshape = 'rectangle'\ncorner = [0, {}, 90]\nedge_u = [90, 0, 0]\n"
      "edge_v = [0, 0, -180]\nvisible_to_camera = false\n",
      height);
}

// How much of the light each point of the floor gets along a line across the edge at `height`, compared with
// the floor without it.
std::vector<double> VisibleAlongX(const std::string& view, const std::string& light,
                                  double height) {
  const Picture open = PictureOf(view + light + Floor);
  const Picture shaded = PictureOf(view + light + Floor + EdgeAt(height));
  std::vector<double> visible;
  for (int x = 0; x < open.width; ++x)
    visible.push_back(PixelAt(shaded, x, 0).x / PixelAt(open, x, 0).x);
  return visible;
}

// The width of the lit part, in pixels.
double LitPixels(const std::vector<double>& visible) {
  double sum = 0;
  for (const double v : visible) sum += v;
  return sum;
}

TEST(Shadows, AHardEdge) {
  const View view = FromAbove(64, 1, 4.0 / 64);
  for (const double lamp : {-1.5, 0.0, 0.7}) {
    for (const double height : {0.01, 1.0, 2.5}) {
      const std::string light =
          fmt::format("[[light]]\ntype = 'point'\nposition = [{}, 4, 0]\n", lamp);
      const double border = lamp - lamp * 4 / (4 - height);
      if (std::abs(border) > 1.9) continue;
      const double lit = LitPixels(VisibleAlongX(view.Sampled(1024, 1), light, height));
      EXPECT_NEAR((lit - 32) * view.PixelSize(), border, 0.01 * view.PixelSize());
    }
  }
}

TEST(Shadows, OfParallelLight) {
  const View view = FromAbove(64, 1, 4.0 / 64);
  for (const double lean : {-0.8, 0.0, 1.2}) {
    const std::string light =
        fmt::format("[[light]]\ntype = 'directional'\ndirection = [{}, -1, 0.3]\n", lean);
    const double lit = LitPixels(VisibleAlongX(view.Sampled(1024, 1), light, 1.5));
    EXPECT_NEAR((lit - 32) * view.PixelSize(), 1.5 * lean, 0.01 * view.PixelSize());
  }
}

// Check where the half-shadow begins and ends, and that it falls all the way between.
void ExpectPenumbra(const std::string& light, double height, double from, double to) {
  const View view = FromAbove(200, 1, 0.02);
  const std::vector<double> visible = VisibleAlongX(view.Sampled(32, 1), light, height);
  for (int x = 0; x < view.width; ++x) {
    const double left = view.RayOrigin(x, 0).x, right = view.RayOrigin(x + 1, 0).x;
    if (right < from) {
      EXPECT_NEAR(visible[std::size_t(x)], 1, 1e-6) << left;
    } else if (left > to) {
      EXPECT_EQ(visible[std::size_t(x)], 0) << left;
    } else if (left > from + 0.05 * (to - from) && right < to - 0.05 * (to - from)) {
      EXPECT_LT(visible[std::size_t(x)], 0.999) << left;
      EXPECT_GT(visible[std::size_t(x)], 0.001) << left;
      EXPECT_LE(visible[std::size_t(x)], visible[std::size_t(x - 1)] + 0.01) << left;
    }
  }
}

TEST(Shadows, ADisksPenumbra) {
  // From the disk's rims over the edge to the floor
  for (const double height : {0.5, 2.0}) {
    const double reach = 0.8 * height / (4 - height);
    ExpectPenumbra(
        "[[light]]\ntype = 'disk'\ncenter = [0, 4, 0]\nradius = 0.8\nsamples = 64\nvisible = "
        "false\n",
        height, -reach, reach);
  }
}

TEST(Shadows, ASpheresPenumbra) {
  // Tangents from the edge to the sphere; a point light with a radius casts the same
  const double height = 1.6, reach = height * std::tan(std::asin(0.7 / (4 - height)));
  ExpectPenumbra(
      "[[light]]\ntype = 'sphere'\ncenter = [0, 4, 0]\nradius = 0.7\nsamples = 64\nvisible = "
      "false\n",
      height, -reach, reach);
  ExpectPenumbra("[[light]]\ntype = 'point'\nposition = [0, 4, 0]\nradius = 0.7\nsamples = 64\n",
                 height, -reach, reach);
}

TEST(Shadows, ASunsPenumbra) {
  // The angular size is the diameter
  const double height = 3, reach = height * std::tan(glm::radians(10.0));
  ExpectPenumbra("[[light]]\ntype = 'directional'\nangular_size = 20\nsamples = 64\n", height,
                 -reach, reach);
}

TEST(Shadows, ASunsPenumbraFallsAsADiskIsCovered) {
  // Of a small round sun, the share that is left beside the edge's line across it
  const View view = FromAbove(64, 1, 0.4 / 64);
  const double height = 3, reach = height * std::tan(glm::radians(1.5));
  const std::vector<double> visible =
      VisibleAlongX(view.Sampled(64, 1),
                    "[[light]]\ntype = 'directional'\nangular_size = 3\nsamples = 64\n", height);
  for (int x = 0; x < view.width; ++x) {
    const double at = std::clamp(view.RayOrigin(x + 0.5, 0).x / reach, -1.0, 1.0);
    const double share = (std::acos(at) - at * std::sqrt(1 - at * at)) / std::numbers::pi;
    EXPECT_NEAR(visible[std::size_t(x)], share, 0.004) << x;
  }
}

TEST(Shadows, ARectanglesPenumbraIsThatOfItsVisiblePart) {
  // The polygon that is left of the light shines by Lambert's formula
  const View view = FromAbove(48, 1, 3.0 / 48);
  const double height = 1.5;
  const Picture picture =
      PictureOf(view.Exact(1) + Floor + EdgeAt(height) +
                "[[light]]\ntype = 'rectangle'\ncorner = [-0.8, 3, -0.5]\nedge_u = [1.6, 0, 0]\n"
                "edge_v = [0, 0, 1]\nsamples = 4096\nvisible = false\n");
  for (int x = 0; x < view.width; ++x) {
    const dvec3 p(view.RayOrigin(x + 0.5, 0).x, 0, 0);
    const double covered = std::clamp(-p.x * (3 - height) / height, -0.8, 0.8);
    const double expected =
        PolygonIrradiance(
            p, {0, 1, 0},
            {{-0.8, 3, -0.5}, {covered, 3, -0.5}, {covered, 3, 0.5}, {-0.8, 3, 0.5}}) /
        std::numbers::pi;
    EXPECT_NEAR(PixelAt(picture, x, 0).x, expected, 3e-4) << p.x;
  }
}

TEST(Shadows, OfThingsThatCastNone) {
  const std::string view = FromAbove(16, 1, 0.1).Exact(1);
  const std::string light = "[[light]]\ntype = 'point'\nposition = [0, 4, 0]\n";
  const Picture open = PictureOf(view + light + Floor);
  EXPECT_EQ(LargestDifference(
                open, PictureOf(view + light + Floor + EdgeAt(1) + "casts_shadow = false\n")),
            0);
}

// The floor under parallel light that leans by an angle, as a share of the floor without the body.
dvec3 Passed(const std::string& body, double degrees, const char* shadows = "tinted") {
  View view = FromAbove(1, 1, 0.001);
  const double angle = glm::radians(degrees);
  std::string render = view.Exact(1);
  render.insert(render.find("[camera]"), fmt::format("shadows = '{}'\n", shadows));
  const std::string scene =
      render + Floor +
      fmt::format("[[light]]\ntype = 'directional'\ndirection = [{}, {}, 0]\n", std::sin(angle),
                  -std::cos(angle));
  return PixelAt(PictureOf(scene + body), 0, 0) / PixelAt(PictureOf(scene), 0, 0);
}

TEST(Shadows, ClearBodiesTint) {
  const dvec3 left(0.9, 0.5, 0.1);
  const std::string slab =
      "[[object]]\nshape = 'box'\nmin = [-90, 1, -90]\nmax = [90, 3, 90]\nvisible_to_camera = "
      "false\n"
      "material = { type = 'dielectric', ior = 1.5, color = [1, 0.8, 1], attenuation_color = [0.9, "
      "0.5, 0.1], attenuation_distance = 4 }\n";
  for (const double degrees : {0.0, 30.0, 60.0}) {
    // Straight on: both faces at the same angle, and the slanting way between them
    const double cosine = std::cos(glm::radians(degrees));
    const dvec3 passed = Passed(slab, degrees);
    for (int c = 0; c < 3; ++c) {
      const double color = c == 1 ? 0.64 : 1;
      EXPECT_NEAR(passed[c],
                  color * std::pow(1 - Fresnel(cosine, 1.5), 2) * std::pow(left[c], 0.5 / cosine),
                  5e-6);
    }
    EXPECT_EQ(Passed(slab, degrees, "opaque"), dvec3(0.0));
  }
}

TEST(Shadows, SheetsTint) {
  const std::string sheet =
      "[[object]]\nshape = 'rectangle'\ncorner = [-90, 1, 90]\nedge_u = [180, 0, 0]\n"
      "edge_v = [0, 0, -180]\nvisible_to_camera = false\n"
      "material = { type = 'dielectric', ior = 1.5, thin = true, color = [1, 0.8, 0.3] }\n";
  for (const double degrees : {0.0, 50.0}) {
    const double once = Fresnel(std::cos(glm::radians(degrees)), 1.5);
    const dvec3 expected = dvec3(1, 0.8, 0.3) * ((1 - once) / (1 + once));
    EXPECT_LT(glm::length(Passed(sheet, degrees) - expected), 5e-6);
  }
}

TEST(Shadows, OfAClearBallDarkenAlongItsChords) {
  const View view = FromAbove(32, 32, 2.2);
  const std::string scene = view.Exact(1) + Floor +
                            "[[light]]\ntype = 'directional'\nirradiance = "
                            "3.141592653589793\n";
  const Picture picture = PictureOf(
      scene +
      "[[object]]\nshape = 'sphere'\ncenter = [0, 2, 0]\nvisible_to_camera = false\nmaterial = "
      "{ type = 'dielectric', ior = 1.5, attenuation_color = 0.4, attenuation_distance = 1 }\n");
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const dvec3 p = view.RayOrigin(x + 0.5, y + 0.5);
      const double h2 = p.x * p.x + p.z * p.z;
      if (std::abs(h2 - 1) < 2e-3) continue;
      const double half = std::sqrt(std::max(1 - h2, 0.0));
      const double expected =
          h2 > 1 ? 1 : std::pow(1 - Fresnel(half, 1.5), 2) * std::pow(0.4, 2 * half);
      EXPECT_NEAR(PixelAt(picture, x, y).x, expected, 5e-5) << p.x << ' ' << p.z;
    }
  }
}

TEST(Shadows, ALampWithinGlass) {
  // One boundary, and one radius of the glass
  const std::string scene =
      FromAbove(1, 1, 0.001).Exact(1) + Floor + "[[light]]\ntype = 'point'\nposition = [0, 3, 0]\n";
  const Picture picture = PictureOf(
      scene +
      "[[object]]\nshape = 'sphere'\ncenter = [0, 3, 0]\nradius = 2\nvisible_to_camera = false\n"
      "material = { type = 'dielectric', ior = 1.5, attenuation_color = 0.4, "
      "attenuation_distance = 1 }\n");
  EXPECT_NEAR(PixelAt(picture, 0, 0).x / PixelAt(PictureOf(scene), 0, 0).x,
              (1 - Fresnel(1, 1.5)) * 0.16, 2e-6);
}

}  // namespace
}  // namespace snell::test
