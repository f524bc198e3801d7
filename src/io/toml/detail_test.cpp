// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "io/toml/test_scene.h"

namespace snell::io {
namespace {

using scene::SubdivisionBoundary;
using scene::SubdivisionScheme;

const std::string Square = "positions = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], polygons = [[0,1,2,3]]";

TEST(TomlDetail, Subdivision) {
  TestScene test("[[object]]\nmesh = { " + Square +
                 ", creases = [{ vertices = [0, 1, 2], sharpness = 3 }, { vertices = [3] }] }\n"
                 "subdivision = { levels = 4, boundary = \"edge-only\" }\n"
                 "[[object]]\nmesh = { " +
                 Square +
                 " }\nsubdivision = { scheme = \"loop\", edge_pixels = 3 }\n"
                 "[[object]]\nmesh = { " +
                 Square +
                 " }\nsubdivision = {}\n"
                 "[[object]]\nmesh = { " +
                 Square + " }\n");
  const scene::Scene scene = test.Read();
  const auto at = [&](std::size_t i) { return scene.objects[i].subdivision; };
  EXPECT_EQ(at(0).scheme, SubdivisionScheme::CatmullClark);
  EXPECT_EQ(at(0).boundary, SubdivisionBoundary::EdgeOnly);
  EXPECT_EQ(at(0).levels, 4);
  EXPECT_EQ(at(1).scheme, SubdivisionScheme::Loop);
  EXPECT_EQ(at(1).target, (scene::EdgeTarget{3, 0}));
  EXPECT_EQ(at(2).scheme, SubdivisionScheme::CatmullClark);
  EXPECT_EQ(at(3).scheme, SubdivisionScheme::None);

  const scene::Mesh& mesh = scene.meshes[0];
  EXPECT_EQ(mesh.joins, (std::vector<bool>{false, true}));
  ASSERT_EQ(mesh.creases.size(), 3u);
  EXPECT_EQ(mesh.creases[1].from, scene::vec3(1, 0, 0));
  EXPECT_EQ(mesh.creases[1].to, scene::vec3(1, 1, 0));
  EXPECT_EQ(mesh.creases[1].sharpness, 3);
  EXPECT_EQ(mesh.creases[2].from, mesh.creases[2].to);
}

TEST(TomlDetail, FaultsOfSubdivision) {
  const auto errorsOf = [](const std::string& mesh, const std::string& subdivision) {
    return TestScene("[[object]]\nmesh = { " + Square + mesh + " }\nsubdivision = { " +
                     subdivision + " }\n")
        .Errors();
  };
  EXPECT_EQ(errorsOf(", creases = [{ vertices = [0, 4] }]", "").at(0),
            "scene.toml:2:91: 'creases': there is no position 4; there are 4, counted from 0");
  EXPECT_EQ(errorsOf("", "levels = 11").size(), 1u);
  EXPECT_EQ(errorsOf("", "levels = 1, edge_length = 1").size(), 1u);
  EXPECT_EQ(errorsOf("", "edge_pixels = 0").size(), 1u);
}

TEST(TomlDetail, Displacement) {
  TestScene test(
      "[texture.hills]\ntype = \"marble\"\n"
      "[material.a]\ndisplacement = { texture = \"hills\", height = 0.3, middle = 0, channel = "
      "\"blue\" }\n"
      "[material.b]\ndisplacement = { texture = \"hills\", edge_length = 0.1 }\n");
  const scene::Scene scene = test.Read();
  EXPECT_EQ(scene.materials[0].displacement, (scene::Displacement{0, 2, 0.3f, 0, {2, 0}}));
  EXPECT_EQ(scene.materials[1].displacement, (scene::Displacement{0, 0, 0.1f, 0.5f, {0, 0.1f}}));
  EXPECT_EQ(TestScene("[material.a]\ndisplacement = { height = 1 }\n").Errors().size(), 1u);
}

}  // namespace
}  // namespace snell::io
