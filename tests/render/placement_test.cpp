// SPDX-License-Identifier: Apache-2.0
//
// Things that are moved, turned, stretched and mirrored look as if they had been modelled so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "render/optics.h"
#include "render/scene_text.h"

namespace snell::test {
namespace {

using glm::dmat4;

const std::string Light =
    "[[light]]\ntype = 'directional'\ndirection = [-2, -3, -4]\nirradiance = 3\n"
    "[environment]\nbottom = [0.1, 0, 0]\ntop = [0.5, 0.7, 1]\n";
const std::string Matt = "material = { type = 'diffuse', color = 1 }\n";

View Facing() {
  View view{48, 48};
  view.extent = 4;
  return view;
}

TEST(Placement, AnEllipsoidShadesByItsNormals) {
  // scale, then rotate, then translate
  const dmat4 map = glm::rotate(glm::translate(dmat4(1.0), dvec3(0.2, -0.1, 0.5)),
                                glm::radians(35.0), glm::normalize(dvec3(1, 2, 0.5))) *
                    glm::scale(dmat4(1.0), dvec3(1.6, -0.7, 0.4));
  const View view = Facing();
  const Picture picture =
      PictureOf(view.Exact(1) + Light +
                "[[object]]\nshape = 'sphere'\nscale = [1.6, -0.7, 0.4]\nrotate = { axis "
                "= [1, 2, 0.5], angle = 35 }\ntranslate = [0.2, -0.1, 0.5]\n" +
                Matt);
  const dmat4 inverse = glm::inverse(map);
  const dvec3 toLight = glm::normalize(dvec3(2, 3, 4));
  int hits = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      // Meet the unit sphere in its own space
      const dvec3 o(inverse * glm::dvec4(view.RayOrigin(x + 0.5, y + 0.5), 1));
      const dvec3 d(inverse * glm::dvec4(0, 0, -1, 0));
      const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1;
      const double root = b * b - a * c;
      if (root < 0.02) continue;
      ++hits;
      const dvec3 local = o + d * ((-b - std::sqrt(root)) / a);
      const dvec3 n = glm::normalize(dvec3(glm::transpose(inverse) * glm::dvec4(local, 0)));
      const double expected = 3 / std::numbers::pi * std::max(glm::dot(n, toLight), 0.0);
      EXPECT_NEAR(PixelAt(picture, x, y).x, expected, 2e-5) << x << ' ' << y;
    }
  }
  EXPECT_GT(hits, 200);
}

// A body without any symmetry: a tetrahedron.
const std::vector<dvec3> Corners = {
    {-1, -0.8, 0.3}, {1.2, -0.5, 0.6}, {0.1, 1.1, 0.2}, {0, 0, -0.9}};

std::string Tetrahedron(const dmat4& map, const std::string& material) {
  std::string positions;
  for (const dvec3& corner : Corners) positions += Toml(dvec3(map * glm::dvec4(corner, 1))) + ", ";
  // A mirrored body's corners count the other way round
  const bool mirrored = glm::determinant(map) < 0;
  return fmt::format("[[object]]\nmesh = {{ positions = [{}], triangles = {}, smooth = 0 }}\n{}\n",
                     positions,
                     mirrored ? "[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]"
                              : "[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]",
                     material);
}

TEST(Placement, MeshesAsIfModelledSo) {
  const std::pair<const char*, dmat4> maps[] = {
      {"scale = [-1, 1, 1]", glm::scale(dmat4(1.0), dvec3(-1, 1, 1))},
      {"scale = -0.8", glm::scale(dmat4(1.0), dvec3(-0.8))},
      {"scale = [1.3, 0.6, -2]\nrotate = { axis = 'y', angle = 40 }",
       glm::rotate(dmat4(1.0), glm::radians(40.0), dvec3(0, 1, 0)) *
           glm::scale(dmat4(1.0), dvec3(1.3, 0.6, -2))},
      {"transform = [{ rotate = { axis = 'z', angle = 30 } }, { scale = [1.5, 0.5, 1] }]",
       glm::scale(dmat4(1.0), dvec3(1.5, 0.5, 1)) *
           glm::rotate(dmat4(1.0), glm::radians(30.0), dvec3(0, 0, 1))}};
  const std::pair<const char*, const char*> materials[] = {
      {"matt", "material = { type = 'phong', specular = 0.5 }"},
      {"mirror", "material = { type = 'mirror' }"},
      {"glass",
       "material = { type = 'dielectric', ior = 1.5, attenuation_color = [0.9, 0.3, 0.5], "
       "attenuation_distance = 1 }"}};
  for (const auto& [place, map] : maps) {
    for (const auto& [name, material] : materials) {
      // Twice in the scene, so that the mesh is an instance; the second lies out of sight
      const std::string scene = Facing().Exact(6) + Light;
      const std::string group = fmt::format(
          "[[group.g.object]]\n{}", Tetrahedron(dmat4(1.0), material).substr(sizeof("[[object]]")));
      const Picture placed = PictureOf(fmt::format(
          "{}{}[[object]]\ngroup = 'g'\n{}\n[[object]]\ngroup = 'g'\ntranslate = [0, 0, "
          "500]\n",
          scene, group, place));
      const Picture modelled = PictureOf(scene + Tetrahedron(map, material));

      // Rounding may decide otherwise about a pixel on an edge
      int different = 0;
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
          different += glm::length(PixelAt(placed, x, y) - PixelAt(modelled, x, y)) > 1e-4;
      EXPECT_LE(different, 3) << name << ' ' << place;
      EXPECT_GT(glm::length(PixelAt(modelled, 24, 24) - PixelAt(modelled, 1, 1)), 0) << name;
    }
  }
}

TEST(Placement, ShapesAsIfModelledSo) {
  const std::pair<const char*, const char*> pairs[] = {
      {"shape = 'sphere'\nradius = 0.5\nscale = 3\ntranslate = [0.1, 0.2, 0]",
       "shape = 'sphere'\nradius = 1.5\ncenter = [0.1, 0.2, 0]"},
      {"shape = 'box'\nscale = [1, 0.5, 0.2]\ntranslate = [0.5, 0, 0]",
       "shape = 'box'\nmin = [-0.5, -0.5, -0.2]\nmax = [1.5, 0.5, 0.2]"},
      {"shape = 'cylinder'\nrotate = { axis = 'z', angle = -90 }\nscale = [0.5, 2, 0.5]",
       "shape = 'cylinder'\nradius = 0.5\ntop = [2, 0, 0]"},
      {"shape = 'cone'\nscale = [1, -2, 1]", "shape = 'cone'\ntop = [0, -2, 0]"},
      {"shape = 'torus'\nrotate = { axis = 'x', angle = 90 }\nscale = 1.5",
       "shape = 'torus'\naxis = [0, 0, 1]\nmajor_radius = 1.5\nminor_radius = 0.375"},
      {"shape = 'disk'\nrotate = { axis = 'x', angle = 60 }\nscale = 2",
       "shape = 'disk'\nnormal = [0, 0.5, 0.8660254037844386]\nradius = 2"},
      {"shape = 'rectangle'\nrotate = { axis = 'x', angle = 90 }\nscale = [2, 1, 3]",
       "shape = 'rectangle'\ncorner = [-1, -1.5, 0]\nedge_u = [2, 0, 0]\nedge_v = [0, 3, 0]"},
      {"shape = 'plane'\nrotate = { axis = 'x', angle = 60 }\ntranslate = [0, 0, -1]",
       "shape = 'plane'\nnormal = [0, 0.5, 0.8660254037844386]\npoint = [5, 0, -1]"}};
  const Picture empty = PictureOf(Facing().Exact(4) + Light);
  const char* materials[] = {"material = { type = 'phong' }", "material = { type = 'mirror' }"};
  for (const char* material : materials) {
    for (const auto& [placed, modelled] : pairs) {
      const auto picture = [&](const char* object) {
        return PictureOf(
            fmt::format("{}{}[[object]]\n{}\n{}\n", Facing().Exact(4), Light, object, material));
      };
      const Picture a = picture(placed), b = picture(modelled);
      int different = 0;
      for (std::size_t i = 0; i < a.rgb.size(); ++i)
        different += std::abs(a.rgb[i] - b.rgb[i]) > 1e-4f;
      EXPECT_LE(different, 9) << placed;
      if (material == materials[0]) {
        EXPECT_GT(LargestDifference(b, empty), 0.1) << modelled;
      }
    }
  }
}

TEST(Placement, GroupsWithinGroupsMultiply) {
  const std::string scene = Facing().Exact(2) + Light;
  const Picture nested =
      PictureOf(scene +
                "[[group.inner.object]]\nshape = 'sphere'\nradius = 0.5\ntranslate = [1, 0, 0]\n"
                "[[group.outer.object]]\ngroup = 'inner'\nrotate = { axis = 'z', angle = 90 }\n"
                "[[object]]\ngroup = 'outer'\nscale = [1, -1, 1]\ntranslate = [0.5, 0, 0]\n" +
                Matt);
  const Picture direct = PictureOf(
      scene + "[[object]]\nshape = 'sphere'\nradius = 0.5\ncenter = [0.5, -1, 0]\n" + Matt);
  EXPECT_LT(LargestDifference(nested, direct), 1e-4);
}

TEST(Placement, WhoSeesWhat) {
  // Hidden from the camera but in the mirror, and the other way round
  View view{16, 16};
  view.extent = 1;
  const std::string mirror =
      "[[object]]\nshape = 'rectangle'\ncorner = [-9, -9, -5]\nedge_u = [18, 0, 0]\nedge_v = [0, "
      "18, 0]\n"
      "material = { type = 'mirror' }\n";
  const std::string lamp =
      "[[object]]\nshape = 'sphere'\nmaterial = { type = 'classic', emission = 1 }\n";
  // The camera looks past the lamp at the mirror only if it does not see the lamp
  EXPECT_EQ(MeanOf(PictureOf(view.Exact(2) + mirror + lamp)), 1);
  EXPECT_EQ(MeanOf(PictureOf(view.Exact(1) + mirror + lamp + "visible_to_camera = false\n")), 0);
  EXPECT_EQ(MeanOf(PictureOf(view.Exact(2) + mirror + lamp + "visible_to_camera = false\n")), 1);
  EXPECT_EQ(MeanOf(PictureOf(view.Exact(2) + mirror + lamp +
                             "visible_to_camera = false\n"
                             "visible_in_reflections = false\n")),
            0);
  EXPECT_EQ(MeanOf(PictureOf(view.Exact(1) + mirror + lamp + "visible_in_reflections = false\n")),
            1);
}

}  // namespace
}  // namespace snell::test
