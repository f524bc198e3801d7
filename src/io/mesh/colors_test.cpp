// SPDX-License-Identifier: Apache-2.0
//
// Colours and texture coordinates of PLY's vertices; colours of STL.
#include <gtest/gtest.h>

#include <string>

#include "io/mesh/test_files.h"
#include "io/read_scene.h"

namespace snell::io {
namespace {

using scene::vec2;
using scene::vec3;
using scene::vec4;

std::string Triangle(const std::string& properties, const std::string& values) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\n" +
         properties +
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0 " +
         values + "\n1 0 0 " + values + "\n0 1 0 " + values + "\n3 0 1 2\n";
}

vec4 FirstColor(const std::string& type, const std::string& values, bool alpha = false) {
  std::string properties;
  for (const char* name : {"red", "green", "blue"})
    properties += "property " + type + " " + name + "\n";
  if (alpha) properties += "property " + type + " alpha\n";
  const MeshResult result = ReadText("a.ply", Triangle(properties, values));
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.mesh.colors.size(), 3u);
  return result.mesh.colors.empty() ? vec4(-1) : result.mesh.colors[0];
}

TEST(MeshColors, IntegersAreSrgbAndFloatsLinear) {
  EXPECT_EQ(FirstColor("uchar", "255 0 255"), vec4(1, 0, 1, 1));
  EXPECT_NEAR(FirstColor("uchar", "188 0 0").x, 0.5029f, 1e-4f);
  EXPECT_NEAR(FirstColor("ushort", "32768 0 0").x, 0.2140f, 1e-4f);
  EXPECT_NEAR(FirstColor("int", "188 0 0").x, 0.5029f, 1e-4f);
  EXPECT_EQ(FirstColor("uchar", "255 255 0 51", true), vec4(1, 1, 0, 0.2f));
  EXPECT_EQ(FirstColor("float", "0.25 0.5 1"), vec4(0.25f, 0.5f, 1, 1));
  EXPECT_EQ(FirstColor("double", "-1 0 1 0.5", true), vec4(0, 0, 1, 0.5f));
  EXPECT_NEAR(FirstColor("float", "188 0 0").x, 0.5029f, 1e-4f);
  EXPECT_EQ(FirstColor("float", "nan 0 0"), vec4(1));
}

TEST(MeshColors, IncompleteColorsAreNone) {
  const MeshResult result = ReadText("a.ply", Triangle("property uchar red\n", "7"));
  EXPECT_EQ(result.error, "");
  EXPECT_TRUE(result.mesh.colors.empty());
}

TEST(MeshColors, TextureCoordinatesByAnyName) {
  for (const auto& [u, v] : {std::pair("u", "v"), {"s", "t"}, {"texture_u", "texture_v"}}) {
    const std::string properties =
        std::string("property float ") + u + "\nproperty float " + v + "\n";
    const MeshResult result = ReadText("a.ply", Triangle(properties, "0.25 0.75"));
    ASSERT_EQ(result.mesh.uvs.size(), 3u);
    EXPECT_EQ(result.mesh.uvs[0], vec2(0.25f, 0.75f));
  }
}

TEST(MeshColors, AreSeenOnBareMeshes) {
  const TemporaryFile file(
      "a.ply",
      Triangle("property uchar red\nproperty uchar green\nproperty uchar blue\n", "9 9 9"));
  const scene::Scene scene = ReadScene(file.path(), {}, nullptr);
  ASSERT_TRUE(scene.materials.at(0).physical);
  EXPECT_EQ(scene.materials[0].physical->baseColor.value, vec3(1));
}

TEST(MeshColors, StayWithTheirVerticesWhenSmoothed) {
  // A right angle splits the edge's vertices
  const MeshResult result = ReadText(
      "a.obj", "v 0 0 0 1 0 0\nv 0 0 1 0 1 0\nv 1 0 0 0 0 1\nv 0 1 0 1 1 1\nf 1 2 3\nf 1 4 2\n");
  ASSERT_EQ(result.error, "");
  ASSERT_EQ(result.mesh.colors.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const vec3 p = result.mesh.positions[i];
    const vec3 expected = p == vec3(0)         ? vec3(1, 0, 0)
                          : p == vec3(0, 0, 1) ? vec3(0, 1, 0)
                          : p == vec3(1, 0, 0) ? vec3(0, 0, 1)
                                               : vec3(1);
    EXPECT_EQ(vec3(result.mesh.colors[i]), expected);
  }
}

TEST(MeshColors, OfStlAreNotUsed) {
  std::string bytes(84 + 50, '\0');
  bytes[80] = 1;
  const auto put = [&](std::size_t at) { bytes.replace(at, 4, std::string("\0\0\x80\x3f", 4)); };
  put(84 + 24);      // x of the second corner: 1
  put(84 + 36 + 4);  // y of the third one
  EXPECT_TRUE(ReadText("a.stl", bytes).warnings.empty());
  bytes[84 + 49] = '\x80';
  const MeshResult colored = ReadText("a.stl", bytes);
  EXPECT_EQ(colored.error, "");
  ASSERT_EQ(colored.warnings.size(), 1u);
  EXPECT_EQ(colored.warnings[0].message, "the triangles' colors are not used");
}

}  // namespace
}  // namespace snell::io
