// SPDX-License-Identifier: Apache-2.0
//
// glTF's nodes: transforms, scenes, instances, cameras, lights, animations.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "io/gltf/test_files.h"

namespace snell::io {
namespace {

using scene::vec3;

// One mesh of a triangle and these nodes.
GltfResult ReadNodes(const std::string& nodes, const std::string& members = "",
                     std::optional<double> time = {}, GltfBuilder builder = {}) {
  const int triangle = builder.AddTriangle();
  return ReadGltfText(
      builder.Document(fmt::format(
          R"("nodes": [{}], "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}}}]}}]{})",
          nodes, triangle, members)),
      time);
}

glm::dvec3 At(const scene::Object& object, glm::dvec3 p) {
  return glm::dvec3(object.toWorld * glm::dvec4(p, 1));
}

TEST(GltfNodes, TransformsNestAndMeshesAreShared) {
  const GltfResult result = ReadNodes(
      R"({"children": [1, 2], "scale": [2, 2, 2]},
{"mesh": 0, "translation": [1, 0, 0], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]},
{"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]})");
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.scene.meshes.size(), 1u);
  ASSERT_EQ(result.scene.objects.size(), 2u);
  EXPECT_LT(glm::length(At(result.scene.objects[0], {1, 0, 0}) - glm::dvec3(2, 2, 0)), 1e-12);
  EXPECT_EQ(At(result.scene.objects[1], {1, 0, 0}), glm::dvec3(8, 12, 14));
}

TEST(GltfNodes, TheDefaultSceneOrTheFirstOrAll) {
  const std::string nodes = R"({"mesh": 0, "name": "a"}, {"mesh": 0, "name": "b"})";
  const std::string scenes = R"(, "scenes": [{"nodes": [0]}, {"nodes": [1]}])";
  EXPECT_EQ(ReadNodes(nodes).scene.objects.size(), 2u);
  EXPECT_EQ(ReadNodes(nodes, scenes).scene.objects.at(0).name, "a");
  EXPECT_EQ(ReadNodes(nodes, scenes + R"(, "scene": 1)").scene.objects.at(0).name, "b");
  EXPECT_EQ(ReadNodes(nodes, scenes + R"(, "scene": 9)").scene.objects.at(0).name, "a");
}

TEST(GltfNodes, CirclesAreRefusedAndSecondParentsIgnored) {
  EXPECT_EQ(ReadNodes(R"({"children": [1]}, {"children": [0]})").error,
            "a.gltf: node 0: the node is its own ancestor, or below one that is");
  EXPECT_EQ(ReadNodes(R"({"name": "x", "children": [0]})").error,
            "a.gltf: node 0 'x': the node is its own child");
  // Forty levels of two parents each would be a million million objects
  std::string nodes;
  for (int i = 0; i < 40; ++i) nodes += fmt::format(R"({{"children": [{0}, {0}]}}, )", i + 1);
  const GltfResult result = ReadNodes(nodes + R"({"mesh": 0})");
  EXPECT_EQ(result.scene.objects.size(), 1u);
  EXPECT_EQ(result.warnings,
            "a node with two parents stays with the first (40 times, first in node 1)\n");
}

TEST(GltfNodes, WhatIsScaledToNothingIsLeftOut) {
  const GltfResult result = ReadNodes(R"({"mesh": 0, "scale": [0, 0, 0]}, {"mesh": 0})");
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.scene.objects.size(), 1u);
  EXPECT_EQ(result.warnings, "objects whose transform cannot be undone are left out (node 0)\n");
}

TEST(GltfNodes, HiddenOnesHideTheirChildren) {
  const GltfResult result = ReadNodes(
      R"({"children": [1], "extensions": {"KHR_node_visibility": {"visible": false}}}, {"mesh": 0})");
  EXPECT_TRUE(result.scene.objects.empty());
}

TEST(GltfNodes, Instances) {
  GltfBuilder builder;
  builder.AddFloats({1, 0, 0, 0, 2, 0}, "VEC3", 2);
  builder.AddFloats({1, 1, 1, 3, 3, 3}, "VEC3", 2);
  const GltfResult result = ReadNodes(
      R"({"mesh": 0, "translation": [0, 0, 5], "extensions": {"EXT_mesh_gpu_instancing":
{"attributes": {"TRANSLATION": 0, "SCALE": 1}}}})",
      "", {}, builder);
  ASSERT_EQ(result.error, "");
  ASSERT_EQ(result.scene.objects.size(), 2u);
  EXPECT_EQ(At(result.scene.objects[0], {1, 0, 0}), glm::dvec3(2, 0, 5));
  EXPECT_EQ(At(result.scene.objects[1], {1, 0, 0}), glm::dvec3(3, 2, 5));
}

TEST(GltfNodes, Cameras) {
  const GltfResult result = ReadNodes(
      R"({"camera": 0, "translation": [1, 2, 3]}, {"camera": 1, "name": "side",
"rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]}, {"camera": 7})",
      R"(, "cameras": [{"type": "perspective", "name": "main", "perspective": {"yfov": 0.6,
"znear": 0.1}}, {"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1.5, "znear": 0,
"zfar": 9}}])");
  ASSERT_EQ(result.error, "");
  ASSERT_EQ(result.scene.cameras.size(), 2u);
  const scene::Camera& main = result.scene.cameras[0];
  EXPECT_EQ(main.name, "main");
  EXPECT_FLOAT_EQ(main.fov, 0.6f);
  EXPECT_EQ(main.position, vec3(1, 2, 3));
  EXPECT_LT(glm::length(glm::normalize(main.lookAt - main.position) - vec3(0, 0, -1)), 1e-6f);
  const scene::Camera& side = result.scene.cameras[1];
  EXPECT_EQ(side.name, "side");
  EXPECT_EQ(side.kind, scene::CameraKind::Orthographic);
  EXPECT_FLOAT_EQ(side.height, 3);
  EXPECT_LT(glm::length(glm::normalize(side.lookAt - side.position) - vec3(-1, 0, 0)), 1e-6f);
  EXPECT_EQ(result.warnings, "a camera does not exist (node 2)\n");
}

TEST(GltfNodes, LightsInWatts) {
  const GltfResult result = ReadNodes(
      R"({"name": "lamp", "translation": [0, 4, 0], "scale": [3, 3, 3],
"extensions": {"KHR_lights_punctual": {"light": 0}}},
{"extensions": {"KHR_lights_punctual": {"light": 1}}},
{"extensions": {"KHR_lights_punctual": {"light": 2}}},
{"extensions": {"KHR_lights_punctual": {"light": 3}}})",
      R"(, "extensions": {"KHR_lights_punctual": {"lights": [
{"type": "point", "intensity": 6830, "color": [1, 0.5, 0], "range": 7},
{"type": "directional", "intensity": 1366},
{"type": "spot", "intensity": 683, "spot": {"innerConeAngle": 0.1}},
{"type": "laser"}]}})");
  ASSERT_EQ(result.error, "");
  ASSERT_EQ(result.scene.lights.size(), 3u);
  const auto& lights = result.scene.lights;
  EXPECT_EQ(lights[0].kind, scene::LightKind::Point);
  EXPECT_EQ(lights[0].name, "lamp");
  EXPECT_FLOAT_EQ(lights[0].strength, 10);
  EXPECT_EQ(lights[0].color, vec3(1, 0.5f, 0));
  EXPECT_EQ(lights[0].position, vec3(0, 4, 0));
  EXPECT_FLOAT_EQ(lights[0].range, 7);
  EXPECT_EQ(lights[1].kind, scene::LightKind::Directional);
  EXPECT_FLOAT_EQ(lights[1].strength, 2);
  EXPECT_EQ(lights[1].direction, vec3(0, 0, -1));
  EXPECT_EQ(lights[2].kind, scene::LightKind::Spot);
  EXPECT_FLOAT_EQ(lights[2].outerAngle, 0.7853981634f);
  EXPECT_EQ(result.warnings,
            "lights of an unknown type or with numbers out of range are left out (node 3)\n");
}

// A node that moves from x = 0 to 8 from second 1 to 3.
double XAt(const std::string& interpolation, double time) {
  GltfBuilder builder;
  builder.AddFloats({1, 3}, "SCALAR", 2);
  builder.AddFloats({0, 0, 0, 8, 0, 0}, "VEC3", 2);
  // In tangent, value, out tangent
  builder.AddFloats({0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0}, "VEC3", 6);
  const GltfResult result = ReadNodes(
      R"({"mesh": 0})",
      fmt::format(R"(, "animations": [{{"channels": [{{"sampler": 0, "target": {{"node": 0,
"path": "translation"}}}}], "samplers": [{{"input": 0, "output": {}, "interpolation": "{}"}}]}}])",
                  interpolation == "CUBICSPLINE" ? 2 : 1, interpolation),
      time, builder);
  EXPECT_EQ(result.error, "");
  return result.scene.objects.at(0).toWorld[3].x;
}

TEST(GltfNodes, AnimationsAtATime) {
  EXPECT_DOUBLE_EQ(XAt("LINEAR", 0), 0);
  EXPECT_DOUBLE_EQ(XAt("LINEAR", 1.5), 2);
  EXPECT_DOUBLE_EQ(XAt("LINEAR", 9), 8);
  EXPECT_DOUBLE_EQ(XAt("STEP", 2.9), 0);
  EXPECT_DOUBLE_EQ(XAt("STEP", 3), 8);
  // Hermite: 8 (3t² − 2t³) + 2 · 6 (t³ − 2t² + t) at t = 1/2
  EXPECT_DOUBLE_EQ(XAt("CUBICSPLINE", 2), 4 + 12 * 0.125);
}

TEST(GltfNodes, AnimationsMoveForADuration) {
  // A mesh below a node that goes from 0 to 8 along x in two seconds, and a camera beside it
  GltfBuilder builder;
  builder.AddFloats({0, 2}, "SCALAR", 2);
  builder.AddFloats({0, 0, 0, 8, 0, 0}, "VEC3", 2);
  const int triangle = builder.AddTriangle();
  const std::string text = builder.Document(fmt::format(
      R"("nodes": [{{"children": [1, 2]}}, {{"mesh": 0, "translation": [0, 3, 0]}}, {{"camera": 0}},
{{"mesh": 0}}], "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}}}]}}],
"cameras": [{{"type": "perspective", "perspective": {{"yfov": 1, "znear": 0.1}}}}],
"animations": [{{"channels": [{{"sampler": 0, "target": {{"node": 0, "path": "translation"}}}}],
"samplers": [{{"input": 0, "output": 1}}]}}])",
      triangle));
  ReadOptions options;
  options.time = 0.5;
  options.duration = 0.25;
  const TemporaryFile file("a.gltf", text);
  const scene::Scene scene = ReadGltf(file.path(), options, {}).scene;
  ASSERT_EQ(scene.objects.size(), 2u);
  const scene::Motion& motion = scene.objects[0].motion;
  ASSERT_FALSE(motion.empty());
  EXPECT_EQ(motion.front().time, 0.5);
  EXPECT_EQ(motion.back().time, 0.75);
  EXPECT_NEAR(motion.front().place[3].x, 2, 1e-6);
  EXPECT_NEAR(motion.back().place[3].x, 3, 1e-6);
  EXPECT_NEAR(motion.back().place[3].y, 3, 1e-6);
  EXPECT_TRUE(scene.objects[1].motion.empty()) << "stands still";
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].shutterClose, 0.75);
  EXPECT_NEAR(scene.cameras[0].motion.back().place[3].x, 3, 1e-6);
}

TEST(GltfNodes, AnimatedRotationsTakeTheShortWay) {
  GltfBuilder builder;
  builder.AddFloats({0, 1}, "SCALAR", 2);
  builder.AddFloats({0, 0, 0, 1, 0, 0, -0.70710678f, -0.70710678f}, "VEC4", 2);
  const GltfResult result =
      ReadNodes(R"({"mesh": 0})", R"(, "animations": [{"channels": [{"sampler": 0,
"target": {"node": 0, "path": "rotation"}}], "samplers": [{"input": 0, "output": 1}]}])",
                0.5, builder);
  ASSERT_EQ(result.error, "");
  const double root = std::sqrt(0.5);
  EXPECT_LT(glm::length(At(result.scene.objects.at(0), {1, 0, 0}) - glm::dvec3(root, root, 0)),
            1e-6);
}

}  // namespace
}  // namespace snell::io
