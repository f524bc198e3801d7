// SPDX-License-Identifier: Apache-2.0
//
// Shapes, instances and lights.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "io/mesh/test_files.h"
#include "io/pbrt/test_scene.h"

namespace snell::io {
namespace {

constexpr float Pi = std::numbers::pi_v<float>;

class PbrtWorld : public testing::Test {
 protected:
  const scene::Scene& Read(const std::string& text) {
    scene_ = file_.Read("WorldBegin\n" + text);
    EXPECT_EQ(file_.error, "");
    return scene_;
  }
  // The only light, or an empty one.
  const scene::Light& Light(const std::string& text) {
    Read(text + "\nAttributeBegin AreaLightSource \"diffuse\" \"float scale\" 0 AttributeEnd");
    EXPECT_EQ(scene_.lights.size(), 1u);
    if (scene_.lights.empty()) scene_.lights.emplace_back();
    return scene_.lights[0];
  }

  PbrtTestScene file_;
  scene::Scene scene_;
};

TEST_F(PbrtWorld, WholeQuadricsAreAnalytic) {
  Read(
      "LightSource \"point\" Shape \"sphere\" \"float radius\" 2 "
      "Shape \"disk\" \"float height\" 3 \"float innerradius\" 0.5 "
      "Shape \"cylinder\" \"float zmin\" -2 \"float zmax\" 4");
  ASSERT_EQ(scene_.objects.size(), 3u);
  const auto& sphere = std::get<scene::Sphere>(scene_.objects[0].geometry);
  EXPECT_EQ(sphere.radius, 2);
  const auto& disk = std::get<scene::Disk>(scene_.objects[1].geometry);
  EXPECT_EQ(disk.innerRadius, 0.5f);
  // pbrt's z axis, which is our −z
  const glm::dvec3 center(scene_.objects[1].toWorld * glm::dvec4(glm::dvec3(disk.center), 1));
  EXPECT_NEAR(center.z, -3, 1e-6);
  const auto& tube = std::get<scene::Cone>(scene_.objects[2].geometry);
  const glm::dvec3 top(scene_.objects[2].toWorld * glm::dvec4(glm::dvec3(tube.top), 1));
  EXPECT_NEAR(top.z, -4, 1e-6);
  EXPECT_FALSE(tube.capped);
}

TEST_F(PbrtWorld, CutQuadricsAreMeshes) {
  Read(
      "LightSource \"point\" Shape \"sphere\" \"float zmax\" 0 "
      "Shape \"disk\" \"float phimax\" 90 Shape \"cylinder\" \"float phimax\" 180");
  ASSERT_EQ(scene_.meshes.size(), 3u);
  for (const scene::Mesh& mesh : scene_.meshes) EXPECT_TRUE(IsSound(mesh));
  EXPECT_NEAR(Area(scene_.meshes[0]), 2 * Pi, 0.02);
  EXPECT_NEAR(Area(scene_.meshes[1]), Pi / 4, 0.002);
  EXPECT_NEAR(Area(scene_.meshes[2]), 2 * Pi, 0.02);
  // Counter-clockwise seen from the side that the normals show
  for (const scene::Mesh& mesh : scene_.meshes)
    for (const scene::uvec3& t : mesh.triangles) {
      const glm::vec3 n = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                     mesh.positions[t.z] - mesh.positions[t.x]);
      EXPECT_GT(glm::dot(n, mesh.normals[t.x]), 0);
    }
}

TEST_F(PbrtWorld, MeshesAreRead) {
  Read(
      "LightSource \"point\" Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 2 1 3 ] "
      "\"point3 P\" [ 0 0 0 1 0 0 0 1 0 1 1 0 ] \"normal N\" [ 0 0 2 0 0 2 0 0 2 0 0 2 ] "
      "\"point2 uv\" [ 0 0 1 0 0 1 1 1 ]\n"
      "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 1 1 0 ]");
  ASSERT_EQ(scene_.meshes.size(), 2u);
  EXPECT_EQ(scene_.meshes[0].triangles.size(), 2u);
  EXPECT_EQ(scene_.meshes[0].normals[0], scene::vec3(0, 0, 1));
  EXPECT_EQ(scene_.meshes[0].uvs[3], scene::vec2(1, 1));
  EXPECT_NEAR(Area(scene_.meshes[1]), 1, 1e-6);
  EXPECT_GT(AreaVector(scene_.meshes[1]).z, 0);
  EXPECT_TRUE(file_.warnings.empty());
}

TEST_F(PbrtWorld, MeshFilesAreReadOnce) {
  file_.Write("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
              "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
              "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  Read(
      "LightSource \"point\" Shape \"plymesh\" \"string filename\" \"a.ply\" Translate 1 0 0 "
      "Shape \"plymesh\" \"string filename\" \"a.ply\"");
  EXPECT_EQ(scene_.meshes.size(), 1u);
  EXPECT_EQ(scene_.objects.size(), 2u);
  file_.Read("WorldBegin Shape \"plymesh\" \"string filename\" \"b.ply\"");
  EXPECT_EQ(file_.error, "a.pbrt:1:12: the mesh 'b.ply' is not found in the scene's folder");
}

TEST_F(PbrtWorld, InstancesShareTheirMeshes) {
  Read(
      "LightSource \"point\"\nAttributeBegin Translate 0 10 0 ObjectBegin \"o\" Translate 1 0 0\n"
      "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] Shape \"sphere\" ObjectEnd\n"
      "AttributeEnd Translate 100 0 0 ObjectInstance \"o\" Scale 2 2 2 ObjectInstance \"o\"");
  EXPECT_EQ(scene_.meshes.size(), 1u);
  ASSERT_EQ(scene_.objects.size(), 4u);
  EXPECT_EQ(glm::dvec3(scene_.objects[0].toWorld[3]), glm::dvec3(101, 10, 0));
  EXPECT_EQ(glm::dvec3(scene_.objects[2].toWorld[3]), glm::dvec3(102, 20, 0));
  EXPECT_EQ(scene_.objects[0].material, scene_.objects[3].material);
  // The shapes in the definition alone are not seen
  EXPECT_EQ(
      Read("LightSource \"point\" ObjectBegin \"o\" Shape \"sphere\" ObjectEnd").objects.size(),
      0u);
}

TEST_F(PbrtWorld, AttributesAreDefaults) {
  Read(
      "LightSource \"point\" Attribute \"shape\" \"float radius\" 0.25 Shape \"sphere\" "
      "Shape \"sphere\" \"float radius\" 3");
  EXPECT_EQ(std::get<scene::Sphere>(scene_.objects.at(0).geometry).radius, 0.25f);
  EXPECT_EQ(std::get<scene::Sphere>(scene_.objects.at(1).geometry).radius, 3);
}

TEST_F(PbrtWorld, WhatIsNotReadIsReported) {
  Read(
      "LightSource \"point\" MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\n"
      "MediumInterface \"fog\" \"\" Material \"interface\" Shape \"sphere\"\n"
      "Shape \"curve\" \"point3 P\" [ 0 0 0 1 0 0 1 1 0 0 1 0 ] Shape \"curve\"");
  EXPECT_TRUE(scene_.objects.empty());
  EXPECT_TRUE(file_.Warned("1 medium left out"));
  EXPECT_TRUE(file_.Warned("3 unseen shapes left out"));
}

TEST_F(PbrtWorld, PointAndSpotLightsHaveTheirIntensity) {
  scene::Light light = Light("LightSource \"point\" \"rgb I\" [ 1 2 3 ] \"float scale\" 2");
  EXPECT_EQ(light.color * light.strength, scene::Spectrum(2, 4, 6));
  light = Light("LightSource \"point\" \"float power\" 100");
  EXPECT_NEAR(light.color.y * light.strength, 100 / (4 * Pi), 1e-4f);
  light = Light(
      "Translate 1 2 3 LightSource \"spot\" \"point3 to\" [ 0 -1 0 ] "
      "\"float coneangle\" 40 \"float conedeltaangle\" 10");
  EXPECT_EQ(light.position, scene::vec3(1, 2, -3));
  EXPECT_EQ(light.direction, scene::vec3(0, -1, 0));
  EXPECT_NEAR(light.outerAngle, 40 * Pi / 180, 1e-5f);
  EXPECT_NEAR(light.innerAngle, 30 * Pi / 180, 1e-5f);
  light = Light("LightSource \"goniometric\"");
  EXPECT_TRUE(file_.Warned("goniometric light"));
}

TEST_F(PbrtWorld, DistantLightsHaveTheirIrradiance) {
  const scene::Light light = Light(
      "LightSource \"distant\" \"point3 from\" [ 0 1 0 ] \"point3 to\" [ 1 1 0 ] "
      "\"rgb L\" [ 3 3 3 ] \"float illuminance\" 2");
  EXPECT_EQ(light.kind, scene::LightKind::Directional);
  EXPECT_EQ(light.direction, scene::vec3(1, 0, 0));
  EXPECT_FLOAT_EQ(light.color.y * light.strength, 6);
}

TEST_F(PbrtWorld, InfiniteLightsAreTheEnvironment) {
  Read("LightSource \"infinite\" \"rgb L\" [ 0.1 0.2 0.3 ] \"float scale\" 2");
  EXPECT_EQ(scene_.environment.top, scene::Spectrum(0.2f, 0.4f, 0.6f));
  EXPECT_EQ(scene_.environment.bottom, scene_.environment.top);
  EXPECT_TRUE(scene_.environment.ambient);
  EXPECT_TRUE(scene_.lights.empty());
  file_.Paint("sky.exr", {0.25f, 0.5f, 1}, 8);
  Read("LightSource \"infinite\" \"string filename\" \"sky.exr\" \"float scale\" 2");
  ASSERT_EQ(scene_.environment.map, 0);
  EXPECT_EQ(scene_.environment.mapScale, scene::Spectrum(2.0f));
  for (std::size_t i = 0; i < scene_.images[0].floats.size(); i += 4) {
    ASSERT_NEAR(scene_.images[0].floats[i], 0.25f, 1e-3f);
    ASSERT_NEAR(scene_.images[0].floats[i + 2], 1, 2e-3f);
  }
  EXPECT_FALSE(file_.Warned("map"));
  Read(
      "LightSource \"infinite\" \"string filename\" \"sky.exr\" LightSource \"infinite\" \"rgb L\" "
      "[ 1 1 1 ]");
  EXPECT_TRUE(file_.Warned("infinite light left out"));
}

TEST_F(PbrtWorld, EmittingShapesAreLights) {
  const std::string area = "AreaLightSource \"diffuse\" \"rgb L\" [ 1 2 3 ] \"float scale\" 2 ";
  scene::Light light = Light(area + "Translate 0 0 5 Scale 2 2 2 Shape \"sphere\"");
  EXPECT_EQ(light.kind, scene::LightKind::Sphere);
  EXPECT_EQ(light.radius, 2);
  EXPECT_EQ(light.position, scene::vec3(0, 0, -5));
  EXPECT_EQ(light.color * light.strength, scene::Spectrum(2, 4, 6));
  EXPECT_TRUE(light.visible);
  light = Light(area + "Shape \"sphere\" \"float alpha\" 0");
  EXPECT_FALSE(light.visible);
  light = Light(area + "Shape \"disk\"");
  EXPECT_EQ(light.direction, scene::vec3(0, 0, -1));
  light = Light(area + "ReverseOrientation Shape \"disk\"");
  EXPECT_EQ(light.direction, scene::vec3(0, 0, 1));
}

// A square in the plane y = 0 whose normal is +y by the order of its corners, as pbrt counts.
TEST_F(PbrtWorld, EmittingSquaresAreRectangles) {
  const std::string area = "AreaLightSource \"diffuse\" ";
  const std::string square =
      "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] "
      "\"point3 P\" [ 0 0 0  0 0 2  2 0 2  2 0 0 ] ";
  const auto normal = [](const scene::Light& light) {
    return glm::normalize(glm::cross(light.edgeU, light.edgeV));
  };
  scene::Light light = Light(area + square);
  EXPECT_EQ(light.kind, scene::LightKind::Rectangle);
  EXPECT_NEAR(glm::length(glm::cross(light.edgeU, light.edgeV)), 4, 1e-5);
  EXPECT_EQ(normal(light), scene::vec3(0, 1, 0));
  // Mirroring in the plane of the square does not change which side shines
  EXPECT_EQ(normal(Light(area + "Scale -1 1 1 " + square)), scene::vec3(0, 1, 0));
  EXPECT_EQ(normal(Light(area + "Scale 1 -1 1 " + square)), scene::vec3(0, -1, 0));
  EXPECT_EQ(normal(Light(area + "ReverseOrientation " + square)), scene::vec3(0, -1, 0));
  // Normals that are given say which side it is
  const std::string down = "\"normal N\" [ 0 -1 0 0 -1 0 0 -1 0 0 -1 0 ]";
  EXPECT_EQ(normal(Light(area + square + down)), scene::vec3(0, -1, 0));
  light = Light("AreaLightSource \"diffuse\" \"float power\" 100 " + square);
  EXPECT_NEAR(light.color.y * light.strength, 100 / (4 * Pi), 1e-3f);
}

TEST_F(PbrtWorld, TwoSidedLightsShineToBothSides) {
  Read("AreaLightSource \"diffuse\" \"bool twosided\" true Shape \"disk\"");
  ASSERT_EQ(scene_.lights.size(), 2u);
  EXPECT_EQ(scene_.lights[0].direction, -scene_.lights[1].direction);
  EXPECT_FALSE(scene_.lights[0].visible);
  ASSERT_EQ(scene_.objects.size(), 1u);
  EXPECT_EQ(scene_.materials.at(0).physical->emission.value, scene::Spectrum(1));
}

TEST_F(PbrtWorld, OtherShapesGlowOnly) {
  Read("AreaLightSource \"diffuse\" \"rgb L\" [ 4 4 4 ] Shape \"cylinder\"");
  EXPECT_TRUE(scene_.lights.empty());
  EXPECT_EQ(scene_.materials.at(0).physical->emission.value, scene::Spectrum(4));
  EXPECT_TRUE(file_.Warned("shown without lighting others"));
}

TEST_F(PbrtWorld, AlphaMakesGaps) {
  Read(
      "LightSource \"point\" Texture \"t\" \"float\" \"checkerboard\" "
      "Shape \"sphere\" \"texture alpha\" \"t\" Shape \"sphere\" Shape \"sphere\" \"float alpha\" "
      "0.5");
  ASSERT_EQ(scene_.materials.size(), 3u);
  EXPECT_GE(scene_.materials[0].opacity.texture, 0);
  EXPECT_EQ(scene_.materials[0].alphaMode, scene::AlphaMode::Blend);
  EXPECT_EQ(scene_.materials[1].alphaMode, scene::AlphaMode::Opaque);
  EXPECT_EQ(scene_.materials[2].opacity.value, 0.5f);
}

}  // namespace
}  // namespace snell::io
