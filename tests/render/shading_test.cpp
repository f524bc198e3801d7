// SPDX-License-Identifier: Apache-2.0
//
// The shader terms on a ball, pixel by pixel; stacks of them; which normals they see: both sides of a
// surface, corners' normals, creases.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "render/optics.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

constexpr double Pi = std::numbers::pi;

// Towards the light.
const dvec3 ToLight = glm::normalize(dvec3(2, 3, 4));
const std::string Light =
    "[[light]]\ntype = 'directional'\ndirection = [-2, -3, -4]\nirradiance = 2\n";

View OfBall() {
  View view{48, 48};
  view.extent = 2.1;
  return view;
}

std::string Ball(const std::string& terms) {
  return fmt::format(
      "[[object]]\nshape = 'sphere'\nmaterial = {{ type = 'classic', terms = [{}] }}\n", terms);
}

// Compare the ball's picture with a term, given by the cosines of the angles from the normal to the light,
// from the mirrored light to the viewer, and from the normal to the half-way direction.
void ExpectOnBall(const std::string& terms,
                  const std::function<double(double, double, double)>& lobe) {
  const View view = OfBall();
  const Picture picture = PictureOf(view.Exact(1) + Light + Ball(terms));
  const dvec3 toViewer(0, 0, 1);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      dvec3 n = view.RayOrigin(x + 0.5, y + 0.5);
      const double square = 1 - n.x * n.x - n.y * n.y;
      if (square < 1e-2) continue;
      n.z = std::sqrt(square);
      const double cosine = glm::dot(n, ToLight);
      const double mirror = std::max(glm::dot(-Mirrored(ToLight, n), toViewer), 0.0);
      const double half = std::max(glm::dot(n, glm::normalize(ToLight + toViewer)), 0.0);
      const double expected = cosine > 0 ? 2 / Pi * lobe(cosine, mirror, half) : 0;
      ASSERT_NEAR(PixelAt(picture, x, y).x, expected, 1e-5 + 2e-4 * expected) << x << ' ' << y;
    }
  }
}

TEST(Shading, LambertsLaw) {
  ExpectOnBall("{ type = 'diffuse', color = 0.7 }",
               [](double cosine, double, double) { return 0.7 * cosine; });
}

TEST(Shading, PhongsHighlight) {
  ExpectOnBall("{ type = 'phong', color = 0.5, exponent = 12 }",
               [](double, double mirror, double) { return 0.5 * std::pow(mirror, 12); });
  ExpectOnBall("{ type = 'phong', color = 0.5, exponent = 12, normalized = true }",
               [](double cosine, double mirror, double) {
                 return 0.5 * std::pow(mirror, 12) * (12 + 2) / 2 * cosine;
               });
}

TEST(Shading, BlinnsHighlight) {
  ExpectOnBall("{ type = 'blinn', color = 0.5, exponent = 40 }",
               [](double, double, double half) { return 0.5 * std::pow(half, 40); });
  ExpectOnBall("{ type = 'blinn', color = 0.5, exponent = 40, normalized = true }",
               [](double cosine, double, double half) {
                 return 0.5 * std::pow(half, 40) * cosine * (42.0 * 44) /
                        (8 * (std::pow(2.0, -20.0) + 40));
               });
}

TEST(Shading, StacksAddUp) {
  const std::string terms[] = {"{ type = 'ambient', color = [0.3, 0, 0] }",
                               "{ type = 'diffuse', color = [0, 0.4, 0.1] }",
                               "{ type = 'phong', color = 0.2, exponent = 20 }",
                               "{ type = 'blinn', color = [0, 0, 0.5], exponent = 9 }",
                               "{ type = 'diffuse', color = [0.2, 0, 0] }",
                               "{ type = 'phong', color = 0.1, exponent = 200 }",
                               "{ type = 'ambient', color = 0.1 }",
                               "{ type = 'blinn', color = 0.3, exponent = 33 }",
                               "{ type = 'diffuse', color = 0.05 }",
                               "{ type = 'phong', color = 0.25, exponent = 3 }"};
  const std::string scene =
      OfBall().Exact(1) + Light + "[[light]]\ntype = 'ambient'\nradiance = 0.5\n";
  Picture sum = PictureOf(scene + Ball(terms[0]));
  std::string all = terms[0];
  for (std::size_t i = 1; i < std::size(terms); ++i) {
    const Picture one = PictureOf(scene + Ball(terms[i]));
    for (std::size_t k = 0; k < sum.rgb.size(); ++k) sum.rgb[k] += one.rgb[k];
    all += ", " + terms[i];
  }
  EXPECT_LT(LargestDifference(sum, PictureOf(scene + Ball(all))), 2e-6);
}

TEST(Shading, TheReadyMaterialsAreStacks) {
  const std::string scene =
      OfBall().Exact(1) + Light + "[[light]]\ntype = 'ambient'\n[[object]]\nshape = 'sphere'\n";
  const std::pair<const char*, const char*> pairs[] = {
      {"type = 'diffuse', color = [0.5, 0.6, 0.7]",
       "terms = [{ type = 'ambient', color = [0.5, 0.6, 0.7] }, { type = 'diffuse', color = [0.5, "
       "0.6, "
       "0.7] }]"},
      {"type = 'phong', diffuse = 0.4, specular = 0.3, shininess = 20, ambient = 0.1",
       "terms = [{ type = 'ambient', color = 0.1 }, { type = 'diffuse', color = 0.4 }, { type = "
       "'phong', color = 0.3, exponent = 20 }]"},
      {"type = 'blinn', diffuse = 0.4, specular = 0.3, normalized = true",
       "terms = [{ type = 'ambient', color = 0.4 }, { type = 'diffuse', color = 0.4 }, { type = "
       "'blinn', color = 0.3, exponent = 32, normalized = true }]"}};
  for (const auto& [ready, stack] : pairs) {
    EXPECT_LT(LargestDifference(PictureOf(fmt::format("{}material = {{ {} }}\n", scene, ready)),
                                PictureOf(fmt::format("{}material = {{ {} }}\n", scene, stack))),
              1e-6)
        << ready;
  }
}

TEST(Shading, SurfacesHaveTwoSides) {
  // Seen and lit from below, flat shapes look as they do from above
  const char* shapes[] = {
      "shape = 'plane'", "shape = 'disk'\nradius = 3",
      "shape = 'rectangle'\ncorner = [-3, 0, 3]\nedge_u = [6, 0, 0]\n"
      "edge_v = [0, 0, -6]",
      "shape = 'triangle'\nvertices = [[-9, 0, 9], [9, 0, 9], [0, 0, -9]]",
      "mesh = { positions = [[-9, 0, 9], [9, 0, 9], [0, 0, -9]], triangles = [[0, "
      "1, 2]], normals = [[0, 1, 0], [0, 1, 0], [0, 1, 0]] }"};
  const char* material =
      "material = {{ type = 'phong', specular = 0.5 }}\n[[light]]\ntype = 'point'\nposition = "
      "[0.5, {}, "
      "0.2]\n";
  for (const char* shape : shapes) {
    View above = FromAbove(16, 16, 2), below = above;
    below.position.y = -above.position.y;
    below.direction.y = 1;
    below.up = {0, 0, 1};
    const auto scene = [&](double side) {
      return fmt::format("[[object]]\n{}\n{}", shape, fmt::format(fmt::runtime(material), side));
    };
    const Picture up = PictureOf(above.Exact(1) + scene(2));
    const Picture down = PictureOf(below.Exact(1) + scene(-2));
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
        EXPECT_NEAR(PixelAt(up, x, y).x, PixelAt(down, x, 15 - y).x, 1e-5) << shape;

    // No light comes through
    EXPECT_EQ(MeanOf(PictureOf(above.Exact(1) + scene(-2))), 0) << shape;
  }

  // A ball from within: all light of a lamp in its middle falls straight
  View inside{8, 8};
  inside.orthographic = false;
  inside.extent = 80;
  inside.position = {0.3, 0.2, 0.1};
  const Picture ball =
      PictureOf(inside.Exact(1) +
                "[[object]]\nshape = 'sphere'\nradius = 2\nmaterial = { type = 'diffuse', "
                "color = 0.5 }\n[[light]]\ntype = 'point'\nintensity = 8\n");
  for (const float value : ball.rgb) EXPECT_NEAR(double(value), 1 / Pi, 1e-5);
}

TEST(Shading, CornersNormalsAreInterpolated) {
  View view{16, 16};
  view.extent = 1;
  const dvec3 vertices[] = {{-2, -2, 0}, {2, -2, 0}, {0, 2, 0}};
  const dvec3 normals[] = {{-0.5, -0.5, 1}, {0.6, -0.2, 1}, {0, 0.8, 0.5}};
  const Picture picture = PictureOf(
      view.Exact(1) + Light +
      fmt::format(
          "[[object]]\nshape = 'triangle'\nvertices = [{}, {}, {}]\nnormals = [{}, {}, {}]\n"
          "material = {{ type = 'diffuse', color = 1 }}\n",
          Toml(vertices[0]), Toml(vertices[1]), Toml(vertices[2]), Toml(normals[0]),
          Toml(normals[1]), Toml(normals[2])));
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      // Barycentric coordinates of this triangle by hand; directions count by their direction alone
      const dvec3 p = view.RayOrigin(x + 0.5, y + 0.5);
      const double b2 = (p.y + 2) / 4, b1 = (p.x + 2 - 2 * b2) / 4;
      const dvec3 n = glm::normalize(normals[0]) * (1 - b1 - b2) + glm::normalize(normals[1]) * b1 +
                      glm::normalize(normals[2]) * b2;
      EXPECT_NEAR(PixelAt(picture, x, y).x, 2 / Pi * glm::dot(glm::normalize(n), ToLight), 1e-5);
    }
  }
}

TEST(Shading, CreasesAreSmoothBelowTheirAngle) {
  // A roof of two faces that meet at 60°, its ridge along y
  const double tilt = glm::radians(30.0);
  const std::string roof = fmt::format(
      "[[object]]\nmaterial = {{ type = 'diffuse', color = 1 }}\n[object.mesh]\npositions = [[-1, "
      "-1, "
      "{0}], [0, -1, 0], [0, 1, 0], [-1, 1, {0}], [1, -1, {0}], [1, 1, {0}]]\npolygons = [[0, 1, "
      "2, "
      "3], [1, 4, 5, 2]]\n",
      -std::tan(tilt));
  View view{33, 1};
  view.extent = 0.04;
  const std::string scene = view.Exact(1) + Light + roof;
  const dvec3 left(-std::sin(tilt), 0, std::cos(tilt)), right(std::sin(tilt), 0, std::cos(tilt));
  const Picture flat = PictureOf(scene + "smooth = 59\n"),
                round = PictureOf(scene + "smooth = 61\n");
  for (const int x : {0, 10, 15, 17, 25, 32}) {
    EXPECT_NEAR(PixelAt(flat, x, 0).x, 2 / Pi * glm::dot(x < 16 ? left : right, ToLight), 1e-5);
  }
  EXPECT_NEAR(PixelAt(round, 16, 0).x, 2 / Pi * ToLight.z, 1e-3);
  for (int x = 1; x < 33; ++x)
    EXPECT_GT(PixelAt(round, x, 0).x, PixelAt(round, x - 1, 0).x) << x;  // towards the light
}

}  // namespace
}  // namespace snell::test
