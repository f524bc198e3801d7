// SPDX-License-Identifier: Apache-2.0
//
// The NFF reader: what every entity becomes.
#include "io/nff/nff.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace snell::io {
namespace {

using scene::Spectrum;
using scene::vec3;

constexpr float Pi = std::numbers::pi_v<float>;
const std::string Ball = "s 0 0 0 1\n";

scene::Scene Parse(const std::string& text) { return ParseNff(text, "dir/test.nff", {}); }

std::vector<std::string> WarningsOf(const std::string& text) {
  std::vector<std::string> warnings;
  ParseNff(text, "test.nff", [&](const Diagnostic& d) { warnings.push_back(ToString(d)); });
  return warnings;
}

template <class Shape>
const Shape& ShapeOf(const scene::Scene& scene, std::size_t object) {
  return std::get<Shape>(scene.objects.at(object).geometry);
}

// --- View, background, lights ---------------------------------------------------------------------------

TEST(Nff, View) {
  const scene::Scene scene = Parse(
      "v\nfrom 1 2 3\nat 4 5 6\nup 0 0 1\nangle 45\nhither 0.01\nresolution 640 480\n" + Ball);
  EXPECT_EQ(scene.name, "test.nff");
  ASSERT_EQ(scene.cameras.size(), 1u);
  const scene::Camera& camera = scene.cameras[0];
  EXPECT_EQ(camera.kind, scene::CameraKind::Pinhole);
  EXPECT_EQ(camera.position, vec3(1, 2, 3));
  EXPECT_EQ(camera.lookAt, vec3(4, 5, 6));
  EXPECT_EQ(camera.up, vec3(0, 0, 1));
  EXPECT_EQ(scene.settings.width, 640);
  EXPECT_EQ(scene.settings.height, 480);
}

TEST(Nff, TheAngleReachesTheMiddlesOfTheOutermostPixels) {
  const std::string view = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 45 resolution ";
  const float tangent = std::tan(22.5f * Pi / 180);

  // With n rows, the middle of the first is (n − 1)/n of the half height from the centre
  for (const int rows : {2, 3, 513}) {
    const std::string size = std::to_string(rows) + " " + std::to_string(rows) + "\n";
    const float half = std::tan(0.5f * Parse(view + size + Ball).cameras[0].fov);
    EXPECT_NEAR(half * float(rows - 1) / float(rows), tangent, 1e-6f) << rows;
  }
  EXPECT_NEAR(Parse(view + "1 1\n" + Ball).cameras[0].fov, 45 * Pi / 180, 1e-6f);
}

TEST(Nff, TheViewsPartsComeInAnyOrderAndTwoMayLack) {
  const scene::Scene scene = Parse("v angle 60 up 0 1 0 at 0 0 0 from 0 0 5 " + Ball);
  EXPECT_EQ(scene.cameras.at(0).position, vec3(0, 0, 5));
  EXPECT_EQ(scene.settings.width, 513);
  EXPECT_EQ(scene.settings.height, 513);
}

TEST(Nff, WithoutAViewTheSceneIsFramedLater) { EXPECT_TRUE(Parse(Ball).cameras.empty()); }

TEST(Nff, SettingsAreThoseOfThePublishedCounts) {
  const scene::RenderSettings settings = Parse(Ball).settings;
  EXPECT_EQ(settings.spp, 1);
  EXPECT_EQ(settings.maxDepth, 5);
  EXPECT_EQ(settings.minContribution, 0);
}

TEST(Nff, Background) {
  EXPECT_EQ(Parse(Ball).environment.top, Spectrum(0.0f));
  const scene::Scene scene = Parse("b 0.078 0.361 0.753\n" + Ball);
  EXPECT_EQ(scene.environment.bottom, Spectrum(0.078f, 0.361f, 0.753f));
  EXPECT_EQ(scene.environment.top, scene.environment.bottom);
}

TEST(Nff, LightsShareTheBrightnessThatTheFileDoesNotSay) {
  const scene::Scene one = Parse("l 1 2 3\n" + Ball);
  ASSERT_EQ(one.lights.size(), 1u);
  EXPECT_EQ(one.lights[0].kind, scene::LightKind::Point);
  EXPECT_EQ(one.lights[0].falloff, scene::Falloff::None);
  EXPECT_EQ(one.lights[0].position, vec3(1, 2, 3));
  // The irradiance π makes a white Lambertian surface shine with radiance 1
  EXPECT_FLOAT_EQ(one.lights[0].strength, Pi);

  const scene::Scene four = Parse("l 1 2 3\nl 4 5 6\nl 7 8 9 0.5 0.25 2\nl 0 0 0\n" + Ball);
  ASSERT_EQ(four.lights.size(), 4u);
  EXPECT_FLOAT_EQ(four.lights[0].strength, Pi / 2);
  EXPECT_FLOAT_EQ(four.lights[3].strength, Pi / 2);
  EXPECT_FLOAT_EQ(four.lights[2].strength, Pi);
  EXPECT_EQ(four.lights[2].color, Spectrum(0.5f, 0.25f, 2));
}

// --- Fills ----------------------------------------------------------------------------------------------

TEST(Nff, AMatteFillIsADiffuseTerm) {
  const scene::Scene scene = Parse("f 1 0.5 0.25 0.5 0 0 0 0\n" + Ball);
  ASSERT_EQ(scene.materials.size(), 1u);
  const scene::Material& material = scene.materials[0];
  ASSERT_EQ(material.terms.size(), 1u);
  EXPECT_EQ(material.terms[0].kind, scene::TermKind::Diffuse);
  EXPECT_EQ(material.terms[0].color.value, Spectrum(0.5f, 0.25f, 0.125f));
  EXPECT_EQ(material.reflectivity.value, Spectrum(0.0f));
  EXPECT_FALSE(material.Refractive());
  EXPECT_GT(material.ior, 0) << "an opaque fill's index of 0 must not reach a division";
  EXPECT_EQ(scene.objects[0].material, 0);
}

TEST(Nff, AShinyFillReflectsAndKeepsItsShares) {
  const scene::Material material = Parse("f 1 0.9 0.7 0.5 0.5 3.0827 0 0\n" + Ball).materials.at(0);
  ASSERT_EQ(material.terms.size(), 2u);
  EXPECT_EQ(material.reflection, scene::ReflectionModel::Constant);
  EXPECT_EQ(material.reflectivity.value, Spectrum(0.5f));

  // The material gives its own colour what is not reflected, here a half: together Kd
  const Spectrum own = material.terms[0].color.value * 0.5f;
  EXPECT_EQ(own, Spectrum(1, 0.9f, 0.7f) * 0.5f);
  EXPECT_EQ(material.terms[1].kind, scene::TermKind::Phong);
  EXPECT_EQ(material.terms[1].color.value, Spectrum(0.5f));
  EXPECT_FLOAT_EQ(material.terms[1].exponent, 3.0827f);
}

TEST(Nff, AGlassFillRefracts) {
  const scene::Material material = Parse("f 1 1 1 0.05 0.1 101 0.8 1.5\n" + Ball).materials.at(0);
  EXPECT_TRUE(material.Refractive());
  EXPECT_EQ(material.transparency.value, Spectrum(0.8f));
  EXPECT_EQ(material.reflectivity.value, Spectrum(0.1f));
  EXPECT_EQ(material.ior, 1.5f);
  EXPECT_FALSE(material.thin);
  EXPECT_NEAR(material.terms.at(0).color.value.x * 0.2f * 0.9f, 0.05f, 1e-7f);
  EXPECT_NEAR(material.terms.at(1).color.value.x * 0.2f, 0.1f, 1e-7f);
}

TEST(Nff, NoFillGivesBackMoreThanArrives) {
  for (const char* fill :
       {"f 1 1 1 1 1 10 1 1.5\n", "f 1 1 1 0.9 0.9 10 0.9 1.5\n", "f 255 0 3 7 9 10 2 1.5\n"}) {
    const scene::Material material = Parse(fill + Ball).materials.at(0);
    for (const scene::Term& term : material.terms)
      EXPECT_LE(std::max({term.color.value.x, term.color.value.y, term.color.value.z}), 1.0f)
          << fill;
    EXPECT_LE(material.reflectivity.value.x, 1.0f);
    EXPECT_LE(material.transparency.value.x, 1.0f);
  }
  EXPECT_EQ(WarningsOf("f 255 0 3 1 0 0 0 0\nf 1 1 1 2 0 0 0 0\n" + Ball),
            (std::vector<std::string>{
                "test.nff:1:1: colours and shares of light above 1 are cut to 1 (2 times)"}));
}

TEST(Nff, EqualFillsAreOneMaterial) {
  const scene::Scene scene = Parse("f 1 0 0 1 0 0 0 0\n" + Ball + "f 0 1 0 1 0 0 0 0\n" + Ball +
                                   "f 1.0 0 0 1 0 0 0 0\n" + Ball);
  EXPECT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.objects[0].material, scene.objects[2].material);
  EXPECT_NE(scene.objects[0].material, scene.objects[1].material);
}

TEST(Nff, ObjectsBeforeTheFirstFillAreWhite) {
  const std::string text = Ball + "p 3 0 0 0 1 0 0 0 1 0\n";
  const scene::Scene scene = Parse(text);
  EXPECT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.materials.at(0).terms.at(0).color.value, Spectrum(1.0f));
  EXPECT_EQ(
      WarningsOf(text),
      (std::vector<std::string>{"test.nff:1:1: objects before the first fill ('f') are white"}));
  EXPECT_EQ(Parse("p 3 0 0 0 1 0 0 0 1 0\n" + Ball).meshes.at(0).triangles.size(), 1u);
}

// --- Objects --------------------------------------------------------------------------------------------

TEST(Nff, Sphere) {
  const scene::Scene scene = Parse("# a comment\n  s 1 2 3 0.5\n");
  EXPECT_EQ(ShapeOf<scene::Sphere>(scene, 0).center, vec3(1, 2, 3));
  EXPECT_EQ(ShapeOf<scene::Sphere>(scene, 0).radius, 0.5f);
  EXPECT_EQ(ToString(scene.objects[0].place), "dir/test.nff:2:3");
}

TEST(Nff, ConesAndCylindersAreOpen) {
  const scene::Scene scene =
      Parse("c\n0 0 0 2\n0 0 3 1\nc 1 1 1 0.5 2 1 1 0.5\nc 0 0 0 1 0 1 0 0\n");
  const scene::Cone& cone = ShapeOf<scene::Cone>(scene, 0);
  EXPECT_EQ(cone.base, vec3(0, 0, 0));
  EXPECT_EQ(cone.top, vec3(0, 0, 3));
  EXPECT_EQ(cone.radius, 2);
  EXPECT_EQ(cone.topRadius, 1);
  EXPECT_FALSE(cone.capped);
  EXPECT_EQ(ShapeOf<scene::Cone>(scene, 1).topRadius, 0.5f);
  EXPECT_EQ(ShapeOf<scene::Cone>(scene, 2).topRadius, 0);
}

TEST(Nff, NegativeRadiiShowBothSides) {
  const std::string text = "f 1 1 1 1 0 0 0 0\ns 0 0 0 -2\nc 0 0 0 -2 0 0 1 -1\n";
  const scene::Scene scene = Parse(text);
  EXPECT_EQ(ShapeOf<scene::Sphere>(scene, 0).radius, 2);
  EXPECT_EQ(ShapeOf<scene::Cone>(scene, 1).radius, 2);
  EXPECT_EQ(WarningsOf(text).size(), 1u);
}

TEST(Nff, WhatHasNoExtentIsLeftOut) {
  const std::string text =
      "f 1 1 1 1 0 0 0 0\ns 1 1 1 0\nc 0 0 0 0 1 0 0 0\np 3 0 0 0 1 1 1 2 2 2\n";
  EXPECT_EQ(Parse(text + Ball).objects.size(), 1u);
  const std::vector<std::string> warnings = WarningsOf(text + Ball);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0], "test.nff:2:1: a shape with radius 0 is left out (2 times)");
  EXPECT_EQ(warnings[1], "test.nff:4:1: a polygon without area is left out");
  EXPECT_THROW(Parse(text), Error) << "nothing else is there to see";
}

const std::string Square = "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string Patch = "pp 3\n0 0 0 0 0 2\n1 0 0 0 3 4\n0 1 0 0 0 0\n";

TEST(Nff, PolygonsOfAFillAreOneMesh) {
  const scene::Scene scene = Parse("f 1 1 1 1 0 0 0 0\n" + Square + Ball + Square);
  ASSERT_EQ(scene.meshes.size(), 1u);
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(ShapeOf<scene::MeshGeometry>(scene, 0).mesh, 0);
  const scene::Mesh& mesh = scene.meshes[0];
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.uvs.empty());
  EXPECT_EQ(mesh.triangles[3], scene::uvec3(4, 6, 7));
}

TEST(Nff, OpaqueMeshesGoOnOverEqualFillsAndGlassOnesDoNot) {
  const std::string matte = "f 1 1 1 1 0 0 0 0\n", glass = "f 1 1 1 0 0 0 0.8 1.1\n";
  EXPECT_EQ(Parse(matte + Square + matte + Square).meshes.size(), 1u);
  EXPECT_EQ(Parse(glass + Square + Square).meshes.size(), 1u);

  // Two bodies of the same glass are two insides
  const scene::Scene bodies = Parse(glass + Square + glass + Square);
  EXPECT_EQ(bodies.meshes.size(), 2u);
  EXPECT_EQ(bodies.objects.size(), 2u);
  EXPECT_EQ(bodies.materials.size(), 1u);
}

TEST(Nff, PatchesBringNormals) {
  const scene::Scene scene = Parse("f 1 1 1 1 0 0 0 0\n" + Square + Patch);
  ASSERT_EQ(scene.meshes.size(), 1u);
  const scene::Mesh& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.normals[0], vec3(0, 0, 1)) << "of the flat polygon";
  EXPECT_EQ(mesh.normals[4], vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals[5], vec3(0, 0.6f, 0.8f));
  EXPECT_EQ(mesh.normals[6], vec3(0, 0, 1)) << "a normal without length is the polygon's";
}

TEST(Nff, ConcavePolygonsKeepTheirShape) {
  const scene::Scene scene = Parse("p 4  0 0 0  4 0 0  4 4 0  2 1 0\n");
  const scene::Mesh& mesh = scene.meshes.at(0);
  double area = 0;
  for (const scene::uvec3& t : mesh.triangles)
    area += 0.5 * double(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                    mesh.positions[t.z] - mesh.positions[t.x])
                             .z);
  EXPECT_NEAR(area, 6, 1e-6);
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

}  // namespace
}  // namespace snell::io
