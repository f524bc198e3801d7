// SPDX-License-Identifier: Apache-2.0
//
// Where glass sends the light: slabs, prisms, balls and surfaces of water by Snell's law, and how much of it
// by Fresnel's equations.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/optics.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

using glm::radians;

// Something that shines and lights nothing.
std::string Glow(const char* shape, const char* color = "1") {
  return fmt::format("[[object]]\n{}\nmaterial = {{ type = 'classic', emission = {} }}\n", shape,
                     color);
}

TEST(Refraction, ASlabShiftsAnEdge) {
  // The half-plane x < 0 shines behind a slab of thickness 1 that is turned about the y axis
  View view{64, 4};
  view.extent = 0.25;
  view.position = {0, 0, 100};
  for (const double degrees : {0.0, 20.0, 45.0, 70.0}) {
    SCOPED_TRACE(degrees);
    const Picture picture = PictureOf(
        fmt::format("{}\n[[object]]\nshape = 'box'\nmin = [-50, -50, -0.5]\nmax = [50, 50, 0.5]\n"
                    "rotate = {{ axis = 'y', angle = {} }}\nmaterial = {{ type = 'dielectric', ior "
                    "= 1.5 }}\n{}",
                    view.Sampled(256, 3), degrees,
                    Glow("shape = 'rectangle'\ncorner = [-200, -100, -100]\nedge_u = [200, 0, 0]\n"
                         "edge_v = [0, 200, 0]")));

    // What goes through both faces is parallel to what came, beside it
    const double angle = radians(degrees);
    const double shift =
        std::sin(angle) * (1 - std::cos(angle) / std::sqrt(2.25 - std::pow(std::sin(angle), 2)));
    const double passed = std::pow(1 - Fresnel(std::cos(angle), 1.5), 2);
    const double edge = MeanOf(picture) / passed * view.width - view.width / 2;
    EXPECT_NEAR(edge * view.PixelSize(), shift, 0.01 * view.PixelSize());
    EXPECT_NEAR(PixelAt(picture, 2, 1).x, passed, 1e-6);
    EXPECT_EQ(PixelAt(picture, 60, 1).x, 0);
  }
}

// A prism along z with its edge up at y = 2, of the given angle, and a view of the middle of its left face.
std::string Prism(double apexDegrees, double incidentDegrees, int maxDepth) {
  const double half = radians(apexDegrees / 2), run = 2 * std::tan(half);
  const double heading = -half + radians(incidentDegrees);
  View view{4, 4};
  view.extent = 0.01;
  view.direction = {std::cos(heading), std::sin(heading), 0};
  view.position = dvec3(-run / 2, 1, 0) - 10.0 * view.direction;
  return fmt::format(
      "{0}{1}[[object]]\nmaterial = {{ type = 'dielectric', ior = 1.5 }}\n[object.mesh]\n"
      "positions = [[0, 2, -5], [-{2}, 0, -5], [{2}, 0, -5], [0, 2, 5], [-{2}, 0, 5], [{2}, 0, "
      "5]]\n"
      "polygons = [[0, 2, 1], [3, 4, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]]\nsmooth = 0\n",
      view.Exact(maxDepth), DirectionMeter, run);
}

TEST(Refraction, APrismTurnsTheLight) {
  const double apex = radians(60.0);
  for (const double degrees : {35.0, 48.59, 60.0, 80.0}) {
    SCOPED_TRACE(degrees);
    const double in = radians(degrees), first = Refracted(in, 1.5), second = apex - first;
    const double out = std::asin(1.5 * std::sin(second));
    const double heading = -apex / 2 + in;
    const double turned = heading - (in + out - apex);

    // The first face mirrors some of it away
    const double mirrored = radians(180 - 30.0) - in;
    const double reflected = Fresnel(std::cos(in), 1.5);
    const double expected = (1 - reflected) * (1 - Fresnel(std::cos(second), 1 / 1.5)) *
                                MeterReading({std::cos(turned), std::sin(turned), 0}) +
                            reflected * MeterReading({std::cos(mirrored), std::sin(mirrored), 0});
    const Picture picture = PictureOf(Prism(60, degrees, 3));
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(PixelAt(picture, i, i).x, expected, 2e-6);
  }
}

TEST(Refraction, TheAngleOfLeastDeviation) {
  // 37.18° for this prism, at the symmetric passage: sin((60° + δ)/2) = 1.5 sin 30°
  const double in = std::asin(0.75), least = 2 * in - radians(60.0);
  const double passed = std::pow(1 - Fresnel(std::cos(in), 1.5), 2);
  const auto transmitted = [&](double degrees) {
    const double mirrored = radians(150.0) - radians(degrees);
    const double reflected = Fresnel(std::cos(radians(degrees)), 1.5);
    return PixelAt(PictureOf(Prism(60, degrees, 3)), 0, 0).x -
           reflected * MeterReading({0, std::sin(mirrored), 0});
  };
  EXPECT_NEAR(2 * transmitted(glm::degrees(in)) / passed - 1, std::sin(in - radians(30.0) - least),
              2e-5);
}

TEST(Refraction, APrismReflectsTotally) {
  // Through one leg straight onto the long side of a right-angled prism, and out of the other leg: the
  // picture of the direction below, less two passages at normal incidence
  View view{4, 4};
  view.extent = 0.01;
  const double once = Fresnel(1, 1.5);
  for (const int maxDepth : {3, 4}) {
    const Picture picture = PictureOf(fmt::format(
        "{}[environment]\nbottom = 1\ntop = 0\nbottom_elevation = -80\ntop_elevation = -70\n"
        "[[object]]\nmaterial = {{ type = 'dielectric', ior = 1.5 }}\n[object.mesh]\n"
        "positions = [[-3, -1, 1], [3, -1, 1], [-3, 1, 1], [3, 1, 1], [-3, -1, -1], [3, -1, -1]]\n"
        "polygons = [[0, 1, 3, 2], [0, 4, 5, 1], [2, 3, 5, 4], [0, 2, 4], [1, 5, 3]]\nsmooth = 0\n",
        view.Exact(maxDepth)));
    EXPECT_NEAR(PixelAt(picture, 1, 2).x, maxDepth < 4 ? 0 : (1 - once) * (1 - once), 1e-6);
  }
}

TEST(Refraction, ABallTurnsParallelLight) {
  // A ray at height h turns by twice the difference of its angles outside and inside, and loses by the
  // absorption along its chord
  View view{48, 48};
  view.extent = 2.2;
  const dvec3 left(0.9, 0.5, 0.2);
  const Picture picture =
      PictureOf(view.Exact(3) + DirectionMeter +
                "[[object]]\nshape = 'sphere'\nmaterial = { type = 'dielectric', ior = 1.5, "
                "attenuation_color = [0.9, 0.5, 0.2], attenuation_distance = 1.5 }\n");
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const dvec3 p = view.RayOrigin(x + 0.5, y + 0.5);
      const double h = std::hypot(p.x, p.y);
      if (std::abs(h - 1) < 1e-3) continue;
      dvec3 expected(0.5);
      if (h < 1) {
        const double in = std::asin(h), inside = Refracted(in, 1.5), turn = 2 * (in - inside);
        const double reflected = Fresnel(std::cos(in), 1.5);
        const double passed = (1 - reflected) * (1 - reflected) *
                              MeterReading({0, h > 0 ? -std::sin(turn) * p.y / h : 0, 0});
        const double mirrored = reflected * MeterReading({0, 2 * std::cos(in) * p.y, 0});
        for (int c = 0; c < 3; ++c)
          expected[c] = mirrored + passed * std::pow(left[c], 2 * std::cos(inside) / 1.5);
      }
      EXPECT_LT(glm::length(PixelAt(picture, x, y) - expected), 1e-4) << x << ' ' << y;
    }
  }
}

// Where on the plane z = −distance a ray at height h arrives through a unit ball of index n.
double BehindTheBall(double h, double distance, double n) {
  const double turn = 2 * (std::asin(h) - std::asin(h / n));
  return (h - distance * std::sin(turn)) / std::cos(turn);
}

// A column of the picture through the middle of a glass ball of radius 1.
std::string BallColumn(const View& view, double ior) {
  return fmt::format(
      "{}[[object]]\nshape = 'sphere'\nmaterial = {{ type = 'dielectric', ior = {} }}\n",
      view.Exact(3), ior);
}

TEST(Refraction, ABallsFocalLength) {
  // Light along the axis meets at n/(2(n − 1)) radii from the middle: there, and only there, a small disk
  // fills the view of the ball's middle
  View view{1, 101};
  view.extent = 0.2;
  for (const double ior : {1.4, 1.5, 1.7}) {
    const double focus = ior / (2 * (ior - 1));
    for (const double distance : {1.05, focus, 1.3 * focus, 2.5 * focus}) {
      SCOPED_TRACE(distance);
      const Picture picture = PictureOf(
          BallColumn(view, ior) +
          Glow(fmt::format("shape = 'disk'\ncenter = [0, 0, {}]\nnormal = [0, 0, 1]\nradius = 0.01",
                           -distance)
                   .c_str()));
      int seen = 0;
      for (int y = 0; y < view.height; ++y) {
        const double h = view.RayOrigin(0.5, y + 0.5).y;
        const double arrives = std::abs(BehindTheBall(h, distance, ior));
        if (std::abs(arrives - 0.01) < 1e-5) continue;
        EXPECT_EQ(PixelAt(picture, 0, y).x > 0, arrives < 0.01) << y;
        seen += PixelAt(picture, 0, y).x > 0;
      }
      EXPECT_EQ(seen == view.height, distance == focus) << seen;
    }
  }
}

TEST(Refraction, ABallsImageStandsUpsideDownBehindTheFocus) {
  // The half-plane y > 0.05 shines: before the focus it is seen magnified and upright, behind it inverted
  View view{1, 512};
  view.extent = 1;
  for (const double distance : {1.05, 4.0}) {
    SCOPED_TRACE(distance);
    const Picture picture = PictureOf(
        BallColumn(view, 1.5) +
        Glow(fmt::format("shape = 'rectangle'\ncorner = [-99, 0.05, {}]\nedge_u = [198, 0, 0]\n"
                         "edge_v = [0, 99, 0]",
                         -distance)
                 .c_str()));

    // Find the height of the edge's image by bisection
    double dark = distance < 1.5 ? -0.5 : 0.5, bright = -dark;
    for (int i = 0; i < 50; ++i) {
      const double middle = (dark + bright) / 2;
      (BehindTheBall(middle, distance, 1.5) > 0.05 ? bright : dark) = middle;
    }
    int lit = 0;
    for (int y = 0; y < view.height; ++y) lit += PixelAt(picture, 0, y).x > 0;
    const bool upright = PixelAt(picture, 0, 0).x > 0;
    EXPECT_EQ(upright, distance < 1.5);
    EXPECT_NEAR(lit * view.PixelSize(), upright ? 0.5 - dark : 0.5 + dark, 1.01 * view.PixelSize());
  }
}

TEST(Refraction, TheWindowOfAFish) {
  // Under water the whole sky lies within the critical angle around the zenith
  View view{64, 48};
  view.orthographic = false;
  view.extent = 110;
  view.position = {0, -1, 0};
  view.direction = {0, 1, 0};
  view.up = {0, 0, 1};
  const double ior = 1.3334;
  const Picture picture = PictureOf(view.Exact(2) +
                                    "[environment]\ncolor = 1\n[[object]]\nshape = 'box'\nmin = "
                                    "[-99, -99, -99]\nmax = [99, 0, 99]\n"
                                    "material = 'water'\n");
  int open = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const double cosine = view.RayDirection(x + 0.5, y + 0.5).y;
      const double beyond = std::sqrt(1 - cosine * cosine) * ior - 1;
      if (std::abs(beyond) < 1e-4) continue;
      EXPECT_NEAR(PixelAt(picture, x, y).x, 1 - Fresnel(cosine, 1 / ior), 5e-5) << x << ' ' << y;
      open += beyond < 0;
    }
  }
  EXPECT_GT(open, 500);
  EXPECT_LT(open, 2000);
}

TEST(Refraction, APaneOfGlass) {
  // Red what passes, blue what is mirrored: all reflections within the pane added, solid or thin
  View view{2, 2};
  view.extent = 0.01;
  view.position = {0, 0, 100};
  const std::string pane[] = {
      "shape = 'box'\nmin = [-9, -9, -0.005]\nmax = [9, 9, 0.005]\n"
      "material = { type = 'dielectric', ior = 1.5 }\n",
      "shape = 'rectangle'\ncorner = [-9, -9, 0]\nedge_u = [18, 0, 0]\nedge_v = [0, 18, 0]\n"
      "material = { type = 'dielectric', ior = 1.5, thin = true }\n"};
  for (const double degrees : {0.0, 30.0, 56.31, 70.0, 80.0}) {
    for (const std::string& object : pane) {
      const Picture picture = PictureOf(
          fmt::format("{}[environment]\ncolor = [0, 0, 1]\n{}[[object]]\nrotate = {{ axis = 'y', "
                      "angle = {} }}\n{}",
                      view.Exact(64),
                      Glow("shape = 'rectangle'\ncorner = [-3, -3, -100]\nedge_u = [6, 0, 0]\n"
                           "edge_v = [0, 6, 0]",
                           "[1, 0, 0]"),
                      degrees, object));
      // The polarizations are mirrored as one: the model of the whole tracer
      const double once = Fresnel(std::cos(radians(degrees)), 1.5);
      const dvec3 expected((1 - once) / (1 + once), 0, 2 * once / (1 + once));
      EXPECT_LT(glm::length(PixelAt(picture, 1, 1) - expected), 2e-6) << degrees << object;
    }
  }
}

TEST(Refraction, ReflectanceOfASurface) {
  // `reflection = "fresnel"` and "schlick" on an opaque ball under a white sky
  View view{32, 32};
  view.extent = 2;
  const std::string ball =
      "[environment]\ncolor = 1\n[[object]]\nshape = 'sphere'\nmaterial = { type = 'classic', ior "
      "= "
      "1.7, reflectivity = 0.6, reflection = ";
  const Picture fresnel = PictureOf(view.Exact(2) + ball + "'fresnel' }\n");
  const Picture schlick = PictureOf(view.Exact(2) + ball + "'schlick' }\n");
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const dvec3 p = view.RayOrigin(x + 0.5, y + 0.5);
      const double h2 = p.x * p.x + p.y * p.y;
      if (h2 > 0.995) continue;
      const double cosine = std::sqrt(1 - h2);
      EXPECT_NEAR(PixelAt(fresnel, x, y).x, 0.6 * Fresnel(cosine, 1.7), 2e-6);
      EXPECT_NEAR(PixelAt(schlick, x, y).x, 0.6 + 0.4 * std::pow(1 - cosine, 5), 2e-6);
    }
  }
}

}  // namespace
}  // namespace snell::test
