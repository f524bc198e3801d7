// SPDX-License-Identifier: Apache-2.0
//
// The NFF reader: what every entity becomes, and what wrong files are told.
#include "io/nff.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>

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

std::string ErrorOf(const std::string& text) {
  try {
    ParseNff(text, "t.nff", {});
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
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
  EXPECT_EQ(ErrorOf(text), "t.nff: nothing to see: no sphere, cone or polygon in this NFF file");
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

// --- The text -------------------------------------------------------------------------------------------

TEST(Nff, LineEndsCommentsAndBlanksMeanNothing) {
  const std::string words = "f 1 0 0 1 0 0 0 0 # red\ns 1e0 +2 -.5 5E-1#small\n\n#end";
  std::string crLf, cr;
  for (const char c : words) {
    crLf += c == '\n' ? "\r\n" : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  for (const std::string& text : {words, crLf, cr, "\xEF\xBB\xBF" + words, "\t\f" + words}) {
    const scene::Scene scene = Parse(text);
    EXPECT_EQ(ShapeOf<scene::Sphere>(scene, 0).center, vec3(1, 2, -0.5f));
    EXPECT_EQ(ShapeOf<scene::Sphere>(scene, 0).radius, 0.5f);
    EXPECT_EQ(scene.objects[0].place.line, 2);
  }
}

TEST(Nff, ErrorsNameThePlaceAndTheForm) {
  EXPECT_EQ(ErrorOf("s 0 0 0\ns 1 1 1 1\n"),
            "t.nff:2:1: expected a number, found 's'; the form is: s X Y Z RADIUS");
  EXPECT_EQ(ErrorOf("\n  s 0 zero 0 1\n"),
            "t.nff:2:7: expected a number, found 'zero'; the form is: s X Y Z RADIUS");
  EXPECT_EQ(
      ErrorOf("l 1 2"),
      "t.nff:1:6: expected a number, found the end of the file; the form is: l X Y Z [RED GREEN "
      "BLUE]");
  EXPECT_EQ(ErrorOf("l 1 2 3 1\n" + Ball),
            "t.nff:2:1: expected a number, found 's'; the form is: l X Y Z [RED GREEN BLUE]");
  EXPECT_EQ(ErrorOf("s 0 0 0 1 7\n"),
            "t.nff:1:11: '7' is a number too many; the form is: s X Y Z RADIUS");
  EXPECT_EQ(ErrorOf("x 1 2 3\n"),
            "t.nff:1:1: unknown entity 'x'; NFF has v, b, l, f, s, c, p and pp");
  EXPECT_EQ(ErrorOf("angle 45\n"),
            "t.nff:1:1: 'angle' stands outside of a view; a view begins with 'v'");
}

TEST(Nff, ErrorsOfValues) {
  const std::string fill = "the form is: f RED GREEN BLUE KD KS SHINE T INDEX";
  EXPECT_EQ(ErrorOf("f 1 1 1 -1 0 0 0 0\n"), "t.nff:1:9: -1 must not be negative; " + fill);
  EXPECT_EQ(
      ErrorOf("f 1 1 1 0 0 0 0.5 0\n"),
      "t.nff:1:19: a surface that light passes through needs an index of refraction; 1 lets light "
      "pass straight on");
  for (const char* number : {"nan", "inf", "1e39", "-1e999", "1..2", "0x10", "1,5", "-", "+", "1f"})
    EXPECT_NE(ErrorOf(std::string("s 0 0 ") + number + " 1\n").find("t.nff:1:7: "),
              std::string::npos)
        << number;
  EXPECT_EQ(
      ErrorOf("p 2 0 0 0 1 1 1\n"),
      "t.nff:1:3: expected a whole number from 3 to 10000, found '2'; the form is: p COUNT, then X "
      "Y Z of each corner");
  EXPECT_NE(ErrorOf("p 2000000000 0 0 0\n").find("from 3 to 10000"), std::string::npos);
  EXPECT_NE(ErrorOf("p 3.5 0 0 0\n").find("whole number"), std::string::npos);
  EXPECT_EQ(ErrorOf("c 1 2 3 1 1 2 3 1\n"),
            "t.nff:1:1: the cone's base and apex are the same point");
  EXPECT_EQ(ErrorOf("c 1 2 3 1 1 2 4 -1\n"), "t.nff:1:1: the cone's radii must not differ in sign");
}

TEST(Nff, ErrorsOfViews) {
  const std::string rest = " at 0 0 0 up 0 1 0 angle 45\n" + Ball;
  EXPECT_NE(ErrorOf("v" + rest).find("t.nff:1:1: the view has no 'from'"), std::string::npos);
  EXPECT_NE(
      ErrorOf("v from 0 0 1 from 0 0 2" + rest).find("t.nff:1:14: the view has a second 'from'"),
      std::string::npos);
  EXPECT_EQ(ErrorOf("v from 0 0 0" + rest),
            "t.nff:1:1: the view's 'from' and 'at' are the same point");
  EXPECT_EQ(ErrorOf("v from 0 3 0" + rest),
            "t.nff:1:1: the view's 'up' has no length or points along the view");
  EXPECT_EQ(ErrorOf("v from 0 0 5 at 0 0 0 up 0 1 0 angle 180\n" + Ball),
            "t.nff:1:38: the angle must lie between 0 and 179 degrees, not 180");
  EXPECT_NE(ErrorOf("v resolution 0 5" + rest).find("from 1 to 65536, found '0'"),
            std::string::npos);
  EXPECT_NE(ErrorOf("v resolution 1e9 5" + rest).find("from 1 to 65536"), std::string::npos);
}

TEST(Nff, AllErrorsOfAFileAreTold) {
  const std::string text =
      "v\nfrom 0 0 x\nat 0 0 0\nup 0 1 0\nangle 45\nl 1 2 3\nb 0 0 red\nq\ns 0 0 0 1 2 3\n" + Ball;
  try {
    Parse(text);
    FAIL();
  } catch (const Error& error) {
    std::vector<int> lines;
    for (const Diagnostic& diagnostic : error.diagnostics()) lines.push_back(diagnostic.place.line);
    EXPECT_EQ(lines, (std::vector<int>{2, 7, 8, 9}));
  }

  std::string many;
  for (int i = 0; i < 1000; ++i) many += "what is this\n";
  try {
    Parse(many);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.diagnostics().size(), 20u);
  }
}

TEST(Nff, OtherFilesAreRefused) {
  EXPECT_EQ(ErrorOf(""), "t.nff: nothing to see: no sphere, cone or polygon in this NFF file");
  EXPECT_EQ(ErrorOf("nff\nversion 2.0\n"),
            "t.nff:1:1: this is WorldToolKit's file format of the same name, not Haines' NFF");
  EXPECT_EQ(ErrorOf(std::string("s 0 0\0 0 1", 10)),
            "t.nff, byte 5: this is not an NFF file, which is text");
  const std::string strange = ErrorOf("\x01\x02\xff" + std::string(100, 'x') + "\n");
  EXPECT_EQ(strange,
            "t.nff:1:1: unknown entity '???xxxxxxxxxxxxxxxxxxxxx...'; NFF has v, b, l, f, s, c, p "
            "and pp");
  EXPECT_THROW(ReadNff("/no/such/file.nff", {}), Error);
}

TEST(Nff, ReadsFiles) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "snell_nff_test.nff";
  std::ofstream(path) << "f 1 1 1 1 0 0 0 0\n" << Ball;
  const scene::Scene scene = ReadNff(path, {});
  EXPECT_EQ(scene.name, "snell_nff_test.nff");
  EXPECT_EQ(scene.objects.size(), 1u);
  std::filesystem::remove(path);
}

TEST(Nff, DamagedFilesGiveAResultOrAnError) {
  const std::string whole =
      "v\nfrom 1 2 3\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 64 64\nb 0 0 1\nl 1 2 3\n"
      "f 1 1 1 0.5 0.5 10 0.2 1.5\ns 0 0 0 1\nc 0 0 0 1 0 0 1 0.5\n" +
      Square + Patch;
  const auto tryIt = [](const std::string& text) {
    try {
      ParseNff(text, "t.nff", {});
    } catch (const Error&) {
    }
  };
  for (std::size_t length = 0; length <= whole.size(); ++length) tryIt(whole.substr(0, length));

  const std::string letters = "0123456789.-+eEvblfscp# \n\r\tx\xff";
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    std::string text = whole;
    for (int k = 0; k < 1 + i % 8; ++k)
      text[random() % text.size()] = letters[random() % letters.size()];
    tryIt(text);
  }
}

}  // namespace
}  // namespace snell::io
