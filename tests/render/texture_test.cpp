// SPDX-License-Identifier: Apache-2.0
//
// How textures lie on shapes: u to the right and v up for whoever looks at their front. Gradients under an
// ambient light show the coordinates themselves: red is u, green is v.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/optics.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

// A material that shows `u` in red and `v` in green where both lie between 0 and 1.
const std::string Coordinates =
    "[texture.u]\ntype = 'gradient'\ncolor_a = 0\ncolor_b = [1, 0, 0]\n"
    "rotate = { axis = 'z', angle = -90 }\n"
    "[texture.v]\ntype = 'gradient'\ncolor_a = 0\ncolor_b = [0, 1, 0]\n"
    "[material.uv]\nterms = [{ type = 'ambient', color = 'u' }, { type = 'ambient', color = 'v' "
    "}]\n"
    "[[light]]\ntype = 'ambient'\n";

struct Case {
  const char* name;
  const char* shape;
  dvec3 direction;  // of the view, onto `target`
  dvec3 up;
  dvec3 target;
  double u, v;  // at the target
  double acrossPixel,
      upwardPixel;  // growth of u to the right and of v upwards, per metre of the view
};

TEST(Textures, LieUprightOnEveryShape) {
  const dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const double turn = 0.5 / std::numbers::pi;
  const Case cases[] = {
      {"sphere", "shape = 'sphere'\nradius = 2", -z, y, {0, 0, 2}, .5, .5, turn / 2, turn},
      {"sphere's side", "shape = 'sphere'", -x, y, {1, 0, 0}, .75, .5, turn, 2 * turn},
      {"plane", "shape = 'plane'", -y, -z, {.3, 0, -.6}, .3, .6, 1, 1},
      {"rectangle", "shape = 'rectangle'", -y, -z, {.1, 0, -.2}, .6, .7, 1, 1},
      {"standing rectangle",
       "shape = 'rectangle'\ncorner = [-1, 0, 0]\nedge_u = [2, 0, 0]\nedge_v = [0, 4, 0]",
       -z,
       y,
       {.5, 1, 0},
       .75,
       .25,
       .5,
       .25},
      {"disk", "shape = 'disk'\nradius = 2", -y, -z, {1, 0, -.5}, .75, .625, .25, .25},
      {"box's front", "shape = 'box'", -z, y, {.5, -.5, 1}, .75, .25, .5, .5},
      {"box's right", "shape = 'box'", -x, y, {1, .5, .5}, .25, .75, .5, .5},
      {"box's back", "shape = 'box'", z, y, {.5, .5, -1}, .25, .75, .5, .5},
      {"box's left", "shape = 'box'", x, y, {-1, .5, .5}, .75, .75, .5, .5},
      {"box's top", "shape = 'box'", -y, -z, {.5, 1, .5}, .75, .25, .5, .5},
      {"box's bottom", "shape = 'box'", y, z, {.5, -1, .5}, .75, .75, .5, .5},
      {"block",
       "shape = 'box'\nmin = [0, 0, 0]\nmax = [4, 2, 1]",
       -z,
       y,
       {1, 1, 1},
       .25,
       .5,
       .25,
       .5},
      {"cylinder",
       "shape = 'cylinder'\ntop = [0, 4, 0]\nradius = 2",
       -z,
       y,
       {0, 1, 2},
       .5,
       .25,
       turn / 2,
       .25},
      {"cylinder's top",
       "shape = 'cylinder'\nradius = 2",
       -y,
       -z,
       {1, 1, -.5},
       .75,
       .625,
       .25,
       .25},
      {"cone",
       "shape = 'cone'\nradius = 2\ntop_radius = 1\ntop = [0, 2, 0]",
       -z,
       y,
       {0, 1, 1.5},
       .5,
       .5,
       turn / 1.5,
       .5},
      {"torus", "shape = 'torus'", -z, y, {0, 0, 1.25}, .5, .5, turn / 1.25, turn / .25},
      {"triangle",
       "shape = 'triangle'\nvertices = [[-1, -1, 0], [3, -1, 0], [-1, 3, 0]]\nuvs = [[0, 0], [1, "
       "0], "
       "[0, 1]]",
       -z,
       y,
       {0, 1, 0},
       .25,
       .5,
       .25,
       .25},
      {"bare triangle",
       "shape = 'triangle'\nvertices = [[-1, -1, 0], [3, -1, 0], [-1, 3, 0]]",
       -z,
       y,
       {0, 1, 0},
       .25,
       .5,
       .25,
       .25},
      {"mesh",
       "mesh = { positions = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], polygons = [[0, 1, "
       "2, "
       "3]], uvs = [[0.2, 0.1], [0.6, 0.1], [0.6, 0.9], [0.2, 0.9]] }",
       -z,
       y,
       {.5, -.5, 0},
       .5,
       .3,
       .2,
       .4}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    View view{3, 3};
    view.extent = 0.03;
    view.direction = c.direction;
    view.up = c.up;
    view.position = c.target - 10.0 * c.direction;
    const Picture picture = PictureOf(
        fmt::format("{}{}[[object]]\n{}\nmaterial = 'uv'\n", view.Exact(1), Coordinates, c.shape));
    EXPECT_NEAR(PixelAt(picture, 1, 1).x, c.u, 1e-5);
    EXPECT_NEAR(PixelAt(picture, 1, 1).y, c.v, 1e-5);
    const dvec3 across = PixelAt(picture, 2, 1) - PixelAt(picture, 0, 1);
    const dvec3 upward = PixelAt(picture, 1, 0) - PixelAt(picture, 1, 2);
    EXPECT_NEAR(across.x / 0.02, c.acrossPixel, 1e-3);
    EXPECT_NEAR(upward.y / 0.02, c.upwardPixel, 1e-3);
    EXPECT_NEAR(across.y, 0, 1e-4);
    EXPECT_NEAR(upward.x, 0, 1e-4);
  }
}

TEST(Textures, StickToTheirSpace) {
  // The green channel is y: of the world, or of the object, which is scaled by 2 and moved by 1
  View view{1, 16};
  view.extent = 1;
  view.position = {0, 2, 10};
  for (const bool world : {false, true}) {
    const Picture picture = PictureOf(
        view.Exact(1) +
        fmt::format("[texture.y]\ntype = 'gradient'\ncolor_a = 0\ncolor_b = 1\nspace = '{}'\n{}"
                    "[material.m]\nterms = [{{ type = 'ambient', color = 'y' }}]\n"
                    "[[light]]\ntype = 'ambient'\n[[object]]\nshape = 'sphere'\nmaterial = 'm'\n"
                    "scale = 2\ntranslate = [0, 1, 0]\n",
                    world ? "world" : "object", world ? "scale = 4\n" : ""));
    for (int i = 0; i < 16; ++i) {
      const double y = view.RayOrigin(0.5, i + 0.5).y;
      EXPECT_NEAR(PixelAt(picture, 0, i).x, world ? y / 4 : (y - 1) / 2, 1e-5);
    }
  }
}

TEST(Textures, ACheckersFields) {
  // Fields of side ½ that alternate along both axes of a wall
  View view{16, 16};
  view.extent = 4;
  const Picture picture =
      PictureOf(view.Exact(1) +
                "[texture.c]\ntype = 'checker'\ncolor_a = 0.25\ncolor_b = [1, 0.5, 0]\nscale = "
                "0.5\n[[light]]\ntype = 'ambient'\n[[object]]\nshape = 'plane'\nnormal = [0, 0, "
                "1]\nmaterial = { terms = [{ type = 'ambient', color = 'c' }] }\n");
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const bool odd = (x / 2 + (15 - y) / 2) % 2 == 1;
      EXPECT_EQ(PixelAt(picture, x, y), odd ? dvec3(1, 0.5, 0) : dvec3(0.25)) << x << ' ' << y;
    }
  }
}

TEST(Textures, ATintMultiplies) {
  View view{4, 4};
  const Picture picture =
      PictureOf(view.Exact(1) +
                "[texture.g]\ntype = 'gradient'\ncolor_a = 1\ncolor_b = 0.5\n[[object]]\nshape = "
                "'rectangle'\ncorner = [-1, -1, 0]\nedge_u = [2, 0, 0]\nedge_v = [0, 2, 0]\n"
                "material = { type = 'classic', emission = { texture = 'g', tint = [8, 4, 0] } "
                "}\n");
  for (int y = 0; y < 4; ++y) {
    const double shade = 1 - 0.5 * (3.5 - y) / 4;
    EXPECT_LT(glm::length(PixelAt(picture, 2, y) - shade * dvec3(8, 4, 0)), 1e-5);
  }
}

}  // namespace
}  // namespace snell::test
