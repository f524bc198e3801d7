// SPDX-License-Identifier: Apache-2.0
//
// The primitives of glTF's meshes: modes, attributes, repairs, morph targets, skins.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "io/gltf/test_files.h"

namespace snell::io {
namespace {

using scene::uvec3;
using scene::vec3;
using scene::vec4;

// Five points of a strip: (0,0) (1,0) (0,1) (1,1) (0,2).
GltfBuilder Strip() {
  GltfBuilder builder;
  builder.AddFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3", 5);
  return builder;
}

TEST(GltfMesh, StripsAndFansKeepTheirWinding) {
  const GltfResult strip =
      ReadGltfText(Strip().Mesh(R"({"attributes": {"POSITION": 0}, "mode": 5})"));
  ASSERT_EQ(strip.error, "");
  EXPECT_EQ(strip.mesh().triangles.size(), 3u);
  EXPECT_NEAR(AreaVector(strip.mesh()).z, 1.5, 1e-12);

  GltfBuilder fan;
  fan.AddFloats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 4);
  const GltfResult result = ReadGltfText(fan.Mesh(R"({"attributes": {"POSITION": 0}, "mode": 6})"));
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh().triangles.size(), 2u);
  EXPECT_NEAR(AreaVector(result.mesh()).z, 1, 1e-12);
}

TEST(GltfMesh, PointsAndLinesAreCounted) {
  GltfBuilder builder;
  builder.AddTriangle();
  const GltfResult result = ReadGltfText(builder.Mesh(
      R"({"attributes": {"POSITION": 0}, "mode": 0}, {"attributes": {"POSITION": 0}, "mode": 3},
{"attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 0}, "mode": 77},
{"attributes": {"NORMAL": 0}})"));
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.scene.objects.size(), 1u);
  EXPECT_EQ(result.warnings,
            "points and lines are left out (2 times, first in mesh 0, primitive 0)\n"
            "primitives of an unknown mode are left out (mesh 0, primitive 3)\n"
            "primitives without positions are left out (mesh 0, primitive 4)\n");
}

TEST(GltfMesh, IndicesAreChecked) {
  GltfBuilder builder;
  builder.AddTriangle();
  builder.Add(BytesOf(std::vector<std::uint8_t>{0, 1, 3}), UnsignedByte, "SCALAR", 3);
  const GltfResult result =
      ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0}, "indices": 1})"));
  EXPECT_EQ(result.error, "a.gltf: mesh 0: index 3 of 3 vertices");
}

TEST(GltfMesh, UnusedVerticesAndUndefinedPositionsGo) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  GltfBuilder builder;
  builder.AddFloats({9, 9, 9, nan, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 5);
  builder.Add(BytesOf(std::vector<std::uint8_t>{2, 3, 4, 1, 3, 4}), UnsignedByte, "SCALAR", 6);
  const GltfResult result =
      ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0}, "indices": 1})"));
  ASSERT_EQ(result.error, "");
  EXPECT_TRUE(IsSound(result.mesh()));
  EXPECT_EQ(result.mesh().positions.size(), 3u);
  EXPECT_EQ(result.warnings,
            "triangles with positions that are not finite are left out (mesh 0)\n");
}

TEST(GltfMesh, AttributesOfVertices) {
  GltfBuilder builder;
  builder.AddTriangle();
  builder.AddFloats({0, 0, 2, 0, 0, 0, 0, 0, 5}, "VEC3", 3);
  builder.AddFloats({2, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1}, "VEC4", 3);
  builder.AddFloats({0, 0.25f, 1, 0, 0, 1}, "VEC2", 3);
  builder.Add(BytesOf(std::vector<std::uint8_t>{255, 0, 51, 0, 1, 2, 3, 0, 4, 5, 6, 0}),
              UnsignedByte, "VEC3", 3, R"(, "byteStride": 4)", R"(, "normalized": true)");
  const GltfResult result = ReadGltfText(builder.Mesh(
      R"({"attributes": {"POSITION": 0, "NORMAL": 1, "TANGENT": 2, "TEXCOORD_1": 3, "COLOR_0": 4}})"));
  ASSERT_EQ(result.error, "");
  const scene::Mesh& mesh = result.mesh();
  EXPECT_TRUE(IsSound(mesh));
  EXPECT_EQ(mesh.normals.at(1), vec3(0, 0, 1));
  EXPECT_EQ(mesh.tangents.at(0), vec4(1, 0, 0, -1));
  EXPECT_TRUE(mesh.uvs.empty());
  EXPECT_EQ(mesh.uvs1.at(0), scene::vec2(0, 0.75f));
  EXPECT_EQ(mesh.colors.at(0), vec4(1, 0, 0.2f, 1));
  EXPECT_EQ(result.warnings, "normals without a direction are made anew (mesh 0)\n");
}

TEST(GltfMesh, WithoutNormalsMeshesAreFlat) {
  const GltfResult result =
      ReadGltfText(Strip().Mesh(R"({"attributes": {"POSITION": 0}, "mode": 5})"));
  EXPECT_TRUE(result.mesh().normals.empty());
}

TEST(GltfMesh, MorphTargetsAtTheirWeights) {
  GltfBuilder builder;
  builder.AddTriangle();
  builder.AddFloats({0, 0, 4, 0, 0, 4, 0, 0, 4}, "VEC3", 3);
  const std::string primitive = R"({"attributes": {"POSITION": 0}, "targets": [{"POSITION": 1}]})";
  const auto z = [&](const std::string& meshWeights, const std::string& nodeWeights) {
    const GltfResult result = ReadGltfText(builder.Document(
        fmt::format(R"("nodes": [{{"mesh": 0{}}}], "meshes": [{{"primitives": [{}]{}}}])",
                    nodeWeights, primitive, meshWeights)));
    EXPECT_EQ(result.error, "");
    return result.mesh().positions.at(0).z;
  };
  EXPECT_EQ(z("", ""), 0);
  EXPECT_EQ(z(R"(, "weights": [0.5])", ""), 2);
  EXPECT_EQ(z(R"(, "weights": [0.5])", R"(, "weights": [0.25])"), 1);
}

TEST(GltfMesh, SkinsMoveVerticesIntoTheWorld) {
  // Two joints, moved by 10 and 20 along x; the last vertex follows both alike
  GltfBuilder builder;
  builder.AddTriangle();
  builder.Add(BytesOf(std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}), UnsignedByte,
              "VEC4", 3);
  builder.AddFloats({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 3);
  const std::string nodes = R"("nodes": [{"mesh": 0, "skin": 0, "translation": [0, 99, 0]},
{"translation": [10, 0, 0]}, {"translation": [20, 0, 0]}])";
  const std::string members = nodes + R"(, "skins": [{"joints": [1, 2]}], "meshes": [{"primitives":
[{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}])";
  const GltfResult result = ReadGltfText(builder.Document(members));
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.mesh().positions.at(0), vec3(10, 0, 0));
  EXPECT_EQ(result.mesh().positions.at(1), vec3(21, 0, 0));
  EXPECT_EQ(result.mesh().positions.at(2), vec3(15, 1, 0));
  EXPECT_EQ(result.scene.objects.at(0).toWorld, scene::Affine(1.0));
}

// A triangle that follows one joint, which is turned by a right angle about z from second 0 to 1, and one with a morph
// target whose weight goes from 0 to 1 meanwhile.
scene::Scene BentTriangles(double time, double duration) {
  GltfBuilder builder;
  builder.AddFloats({0, 1}, "SCALAR", 2);
  builder.AddFloats({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}, "VEC4", 2);
  builder.AddFloats({0, 1}, "SCALAR", 2);
  builder.AddFloats({0, 0, 2, 0, 0, 2, 0, 0, 4}, "VEC3", 3);
  builder.Add(std::string(12, '\0'), UnsignedByte, "VEC4", 3);
  builder.AddFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 3);
  builder.AddFloats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  const int triangle = builder.AddTriangle();
  const std::string text = builder.Document(fmt::format(
      R"("nodes": [{{"mesh": 0, "skin": 0}}, {{"translation": [1, 0, 0]}}, {{"mesh": 1}}],
"skins": [{{"joints": [1]}}], "meshes": [{{"primitives": [{{"attributes":
{{"POSITION": {0}, "JOINTS_0": 4, "WEIGHTS_0": 5}}}}]}}, {{"primitives": [{{"attributes":
{{"POSITION": {0}, "NORMAL": 6}}, "targets": [{{"POSITION": 3}}]}}]}}],
"animations": [{{"channels": [{{"sampler": 0, "target": {{"node": 1, "path": "rotation"}}}},
{{"sampler": 1, "target": {{"node": 2, "path": "weights"}}}}],
"samplers": [{{"input": 0, "output": 1}}, {{"input": 0, "output": 2}}]}}])",
      triangle));
  ReadOptions options;
  options.time = time;
  options.duration = duration;
  const TemporaryFile file("a.gltf", text);
  return ReadGltf(file.path(), options, {}).scene;
}

TEST(GltfMeshes, SkinsAndMorphsBendForADuration) {
  const scene::Scene scene = BentTriangles(0, 1);
  ASSERT_EQ(scene.meshes.size(), 2u);
  const scene::Mesh& skinned = scene.meshes[0];
  ASSERT_GT(skinned.keys.size(), 8u);
  EXPECT_EQ(skinned.time, 0);
  EXPECT_EQ(skinned.keys.back().time, 1);
  EXPECT_LT(glm::length(skinned.positions[1] - vec3(2, 0, 0)), 1e-6f);
  EXPECT_LT(glm::length(skinned.keys.back().positions[1] - vec3(1, 1, 0)), 1e-6f);
  const scene::MeshKey& middle = skinned.keys[skinned.keys.size() / 2 - 1];
  EXPECT_EQ(middle.time, 0.5);
  EXPECT_LT(glm::length(middle.positions[1] - vec3(1.70710678f, 0.70710678f, 0)), 1e-5f);
  const scene::Mesh& morphed = scene.meshes[1];
  ASSERT_EQ(morphed.keys.size(), skinned.keys.size());
  EXPECT_EQ(morphed.keys.back().positions[2], vec3(0, 1, 4));
  EXPECT_EQ(morphed.keys.back().normals[2], vec3(0, 0, 1));
  EXPECT_NE(morphed.keys[2].positions[2], morphed.keys[3].positions[2]);
  // A moment, and when all is over
  for (const auto& [time, duration] : {std::pair(0.5, 0.0), {2.0, 1.0}})
    for (const scene::Mesh& mesh : BentTriangles(time, duration).meshes)
      EXPECT_TRUE(mesh.keys.empty()) << time;
}

}  // namespace
}  // namespace snell::io
