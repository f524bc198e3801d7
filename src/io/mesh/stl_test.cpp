// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/mesh/test_files.h"
#include "io/read_scene.h"

namespace snell::io {
namespace {

using scene::uvec3;
using scene::vec3;

// The unit cube's corners and triangles, outside out.
std::vector<vec3> CubeCorners() {
  std::vector<vec3> corners;
  const auto at = [](int i) { return vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1); };
  const int quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& quad : quads)
    for (const int k : {0, 1, 2, 0, 2, 3}) corners.push_back(at(quad[k]));
  return corners;
}

std::string Binary(const std::vector<vec3>& corners, std::uint32_t count,
                   const std::string& title = "binary") {
  std::string bytes = title;
  bytes.resize(80, '\0');
  const auto add = [&](std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes += char((word >> (8 * i)) & 255);
  };
  add(count);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) bytes.append(12, '\0');
    for (int axis = 0; axis < 3; ++axis) add(std::bit_cast<std::uint32_t>(corners[i][axis]));
    if (i % 3 == 2) bytes.append(2, '\0');
  }
  return bytes;
}

std::string Text(const std::vector<vec3>& corners, const std::string& name = "cube") {
  std::string text = "solid " + name + "\n";
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) text += " facet normal 0 0 0\n  outer loop\n";
    text += "   vertex";
    for (int axis = 0; axis < 3; ++axis) text += " " + std::to_string(corners[i][axis]);
    text += i % 3 == 2 ? "\n  endloop\n endfacet\n" : "\n";
  }
  return text + "endsolid " + name + "\n";
}

TEST(MeshStl, ReadsBinaryAndJoinsVertices) {
  const std::string bytes = Binary(CubeCorners(), 12);
  const MeshResult flat = ReadText("a.stl", bytes, {.smoothDegrees = 0});
  ASSERT_EQ(flat.error, "");
  EXPECT_TRUE(flat.warnings.empty());
  EXPECT_EQ(flat.mesh.positions.size(), 8u);
  EXPECT_EQ(flat.mesh.triangles.size(), 12u);
  EXPECT_NEAR(Volume(flat.mesh), 1, 1e-12);
  EXPECT_TRUE(flat.mesh.normals.empty());

  EXPECT_EQ(ReadText("a.stl", bytes).mesh.normals.size(), 24u);
  EXPECT_EQ(ReadText("A.STL", bytes, {.smoothDegrees = 100}).mesh.normals.size(), 8u);
}

TEST(MeshStl, BinaryMayBeginWithSolid) {
  const MeshResult result = ReadText("a.stl", Binary(CubeCorners(), 12, "solid but binary"));
  ASSERT_EQ(result.error, "");
  EXPECT_NEAR(Volume(result.mesh), 1, 1e-12);
}

TEST(MeshStl, ReadsText) {
  std::string text = Text(CubeCorners(), "my cube");
  for (int upper = 0; upper < 2; ++upper) {
    const MeshResult result = ReadText("a.stl", text);
    ASSERT_EQ(result.error, "");
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_EQ(result.mesh.positions.size(), 24u);
    EXPECT_NEAR(Volume(result.mesh), 1, 1e-12);
    EXPECT_EQ(result.mesh.name, upper == 0 ? "my cube" : "MY CUBE");
    for (char& c : text) c = c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c == '\n' ? '\r' : c;
  }
}

TEST(MeshStl, ZPointsUpUnlessTheCallerSaysOtherwise) {
  const TemporaryFile stl("a.stl", Text(CubeCorners(), "cube"));
  const TemporaryFile obj("a.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
  const auto up = [](const TemporaryFile& file, std::optional<bool> zUp) {
    const scene::Scene scene = ReadScene(file.path(), {.zUp = zUp, .smooth = {}, .time = {}}, {});
    return glm::dvec3(scene.objects[0].toWorld * glm::dvec4(0, 0, 1, 0));
  };
  const glm::dvec3 y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(up(stl, {}), y);
  EXPECT_EQ(up(stl, true), y);
  EXPECT_EQ(up(stl, false), z);
  EXPECT_EQ(up(obj, {}), z);
  EXPECT_EQ(up(obj, true), y);
}

TEST(MeshStl, SeveralSolidsAndLoopsOfMoreCorners) {
  const std::string square =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
      "endloop\nendfacet\n";
  const MeshResult result =
      ReadText("two.stl", "solid a\n" + square + "endsolid a\nsolid b\n" + square + "endsolid");
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh.triangles.size(), 4u);
  EXPECT_EQ(result.mesh.positions.size(), 4u);
  EXPECT_EQ(result.mesh.name, "two");
}

TEST(MeshStl, BinarySizesMustAgree) {
  const std::string bytes = Binary(CubeCorners(), 12);
  EXPECT_EQ(ReadText("a.stl", bytes.substr(0, 600)).error,
            "a.stl, byte 80: the file claims 12 triangles, which take 684 B, but has only 600 B; "
            "the file may be cut short");
  EXPECT_NE(ReadText("a.stl", Binary(CubeCorners(), 0xffffffffu)).error, "");
  EXPECT_EQ(ReadText("a.stl", Binary({}, 0)).error, "a.stl: the file has no triangles");
  EXPECT_EQ(ReadText("a.stl", bytes.substr(0, 70)).error,
            "a.stl: not an STL file: too short for the binary format, and no text that begins with "
            "'solid'");

  const MeshResult longer = ReadText("a.stl", bytes + "trailer");
  EXPECT_EQ(longer.error, "");
  EXPECT_EQ(longer.mesh.triangles.size(), 12u);
  ASSERT_EQ(longer.warnings.size(), 1u);
  EXPECT_EQ(longer.warnings[0].message, "7 bytes after the last triangle ignored");
}

TEST(MeshStl, TextErrorsNameTheLine) {
  const std::string text = Text({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const auto errorWith = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return ReadText("a.stl", changed).error;
  };
  EXPECT_EQ(errorWith("1.000000", "one"), "a.stl:5: 'one' is not a number");
  EXPECT_EQ(errorWith(" 1.000000", ""),
            "a.stl:5: a vertex needs three coordinates; the file may be cut short");
  EXPECT_EQ(errorWith("vertex", "vortex"), "a.stl:4: unknown word 'vortex'");
  EXPECT_EQ(errorWith("   vertex 0.000000 0.000000 0.000000\n", ""),
            "a.stl:6: a facet with 2 vertex statements");
  EXPECT_EQ(errorWith("  endloop\n endfacet\nendsolid cube\n", ""),
            "a.stl:7: the file ends within a facet; it may be cut short");
  EXPECT_EQ(ReadText("a.stl", "solid nothing\nendsolid").error, "a.stl: the file has no triangles");

  std::string cut = text.substr(0, text.find("endsolid"));
  const MeshResult result = ReadText("a.stl", cut);
  EXPECT_EQ(result.error, "");
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_EQ(result.warnings[0].message, "the file ends without 'endsolid': it may be cut short");
}

TEST(MeshStl, UndefinedCoordinatesTakeTheirTrianglesAway) {
  std::vector<vec3> corners = CubeCorners();
  corners[4].y = std::numeric_limits<float>::quiet_NaN();
  corners[30].x = std::numeric_limits<float>::infinity();
  for (const std::string& bytes : {Binary(corners, 12), Text(corners)}) {
    const MeshResult result = ReadText("a.stl", bytes);
    ASSERT_EQ(result.error, "");
    EXPECT_TRUE(IsSound(result.mesh));
    EXPECT_EQ(result.mesh.triangles.size(), 10u);
    ASSERT_EQ(result.warnings.size(), 1u);
  }
  const std::vector<vec3> none(3000, vec3(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(ReadText("a.stl", Binary(none, 1000)).error,
            "a.stl: no face has an area and finite coordinates");
}

}  // namespace
}  // namespace snell::io
