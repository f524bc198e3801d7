// SPDX-License-Identifier: Apache-2.0
//
// What the TOML reader makes of good scenes: records, defaults, units, colours, materials, meshes.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "io/toml/sections.h"
#include "io/toml/test_scene.h"
#include "scene/validate.h"

namespace snell::io {
namespace {

using scene::TermKind;

constexpr float Degree = 0.01745329252f;

scene::Scene Read(const std::string& text) { return TestScene(text).Read(); }

scene::Material Material(const std::string& keys) {
  return Read("[material.m]\n" + keys).materials.at(0);
}

scene::Light Light(const std::string& keys) { return Read("[[light]]\n" + keys).lights.at(0); }

template <class Shape>
Shape ShapeOf(const std::string& keys) {
  return std::get<Shape>(Read("[[object]]\n" + keys).objects.at(0).geometry);
}

TEST(TomlScene, MayBeEmpty) {
  const scene::Scene scene = Read("");
  const scene::RenderSettings defaults;
  EXPECT_EQ(scene.name, "scene.toml");
  EXPECT_TRUE(scene.cameras.empty());
  EXPECT_TRUE(scene.objects.empty());
  EXPECT_EQ(scene.settings.width, defaults.width);
  EXPECT_EQ(scene.settings.spp, defaults.spp);
}

TEST(TomlScene, TakesWindowsLinesAndAByteOrderMark) {
  EXPECT_EQ(Read("\xef\xbb\xbf[render]\r\nspp = 3\r\n").settings.spp, 3);
}

TEST(TomlScene, ReadsSettings) {
  const scene::RenderSettings settings = Read(R"([render]
size = [320, 200]
spp = 9
integrator = "whitted"
max_depth = 5
min_contribution = 0.25
filter = "tent"
filter_radius = 1.5
exposure = -1
shadows = "opaque"
clamp_indirect = 2.5
seed = 4294967295
)")
                                             .settings;
  EXPECT_EQ(settings.width, 320);
  EXPECT_EQ(settings.height, 200);
  EXPECT_EQ(settings.spp, 9);
  EXPECT_EQ(settings.maxDepth, 5);
  EXPECT_EQ(settings.minContribution, 0.25f);
  EXPECT_EQ(settings.filter, scene::PixelFilter::Tent);
  EXPECT_EQ(settings.filterRadius, 1.5f);
  EXPECT_EQ(settings.exposure, -1);
  EXPECT_FALSE(settings.tintedShadows);
  EXPECT_EQ(settings.clampIndirect, 2.5f);
  EXPECT_EQ(settings.seed, 4294967295u);
}

TEST(TomlScene, ReadsCameras) {
  const scene::Scene scene = Read(R"(
[[camera]]
name = "front"
position = [1, 2, 3]
look_at = [4, 5, 6]
fov = 90
[[camera]]
name = "top"
type = "orthographic"
position = [0, 9, 0]
direction = [0, -2, 0]
up = [0, 0, -1]
height = 7
)");
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_EQ(scene.cameras[0].lookAt, vec3(4, 5, 6));
  EXPECT_FLOAT_EQ(scene.cameras[0].fov, 90 * Degree);
  EXPECT_EQ(scene.cameras[1].kind, scene::CameraKind::Orthographic);
  EXPECT_EQ(scene.cameras[1].lookAt, vec3(0, 0, 0));
  EXPECT_EQ(scene.cameras[1].height, 7);
  EXPECT_FLOAT_EQ(Read("[camera]\n").cameras.at(0).fov, 40 * Degree);
}

TEST(TomlScene, KeepsTheDigitsOfDirectionsFarAway) {
  const scene::Camera camera =
      Read("[camera]\nposition = [1e5, 1e5, 1e5]\ndirection = [0.01, 0, -1]\n").cameras.at(0);
  const vec3 way = camera.lookAt - camera.position;
  EXPECT_NEAR(way.x / way.z, -0.01f, 1e-6);
}

TEST(TomlScene, ReadsTheEnvironment) {
  const auto plain = Read("[environment]\ncolor = [1, 2, 3]\nior = 1.33\n").environment;
  EXPECT_EQ(plain.bottom, vec3(1, 2, 3));
  EXPECT_EQ(plain.top, vec3(1, 2, 3));
  EXPECT_EQ(plain.ior, 1.33f);
  const auto gradient =
      Read("[environment]\nbottom = 0.25\ntop = \"#ffffff\"\ntop_elevation = 30\n").environment;
  EXPECT_EQ(gradient.bottom, vec3(0.25f));
  EXPECT_EQ(gradient.top, vec3(1.0f));
  EXPECT_FLOAT_EQ(gradient.topElevation, 30 * Degree);
}

// --- Lights

TEST(TomlLights, HaveTheirOwnMeasures) {
  const scene::Light sun =
      Light("type = \"directional\"\ndirection = [0, 0, -5]\nirradiance = 3\nangular_size = 0.5");
  EXPECT_EQ(sun.kind, scene::LightKind::Directional);
  EXPECT_EQ(sun.direction, vec3(0, 0, -1));
  EXPECT_EQ(sun.strength, 3);
  EXPECT_FLOAT_EQ(sun.angularSize, 0.5f * Degree);

  const scene::Light spot =
      Light("type = \"spot\"\nposition = [0, 2, 0]\nlook_at = [0, 0, 0]\nouter_angle = 20");
  EXPECT_EQ(spot.direction, vec3(0, -1, 0));
  EXPECT_FLOAT_EQ(spot.outerAngle, 20 * Degree);
  EXPECT_FLOAT_EQ(spot.innerAngle, 16 * Degree);

  const scene::Light point =
      Light("type = \"point\"\nfalloff = \"linear\"\nfalloff_factor = 2\nrange = 9\nradius = 0.1");
  EXPECT_EQ(point.falloff, scene::Falloff::Linear);
  EXPECT_EQ(point.falloffFactor, 2);
  EXPECT_EQ(point.range, 9);
  EXPECT_EQ(point.radius, 0.1f);

  const scene::Light triangle =
      Light("type = \"triangle\"\nvertices = [[1, 1, 1], [2, 1, 1], [1, 1, 3]]\nvisible = false");
  EXPECT_EQ(triangle.position, vec3(1, 1, 1));
  EXPECT_EQ(triangle.edgeU, vec3(1, 0, 0));
  EXPECT_EQ(triangle.edgeV, vec3(0, 0, 2));
  EXPECT_FALSE(triangle.visible);
}

TEST(TomlLights, SpreadTheirPowerOverTheirSurface) {
  // Radiance L from an area A is the power π A L
  EXPECT_NEAR(Light("type = \"rectangle\"\ncorner = [0, 0, 0]\nedge_u = [2, 0, 0]\nedge_v = [0, 0, "
                    "3]\npower = 60")
                  .strength,
              60 / (M_PI * 6), 1e-5);
  EXPECT_NEAR(Light("type = \"triangle\"\nvertices = [[0, 0, 0], [2, 0, 0], [0, 0, 3]]\npower = 60")
                  .strength,
              60 / (M_PI * 3), 1e-5);
  EXPECT_NEAR(Light("type = \"disk\"\nradius = 2\npower = 60").strength, 60 / (M_PI * 4 * M_PI),
              1e-5);
  EXPECT_NEAR(Light("type = \"sphere\"\nradius = 2\npower = 60").strength, 60 / (M_PI * 16 * M_PI),
              1e-5);
}

// --- Objects

TEST(TomlObjects, HaveTheirShapes) {
  EXPECT_EQ(ShapeOf<scene::Sphere>("shape = \"sphere\"\nradius = 2").radius, 2);
  EXPECT_EQ(ShapeOf<scene::Plane>("shape = \"plane\"\nnormal = [0, 0, 4]").normal, vec3(0, 0, 1));
  EXPECT_EQ(ShapeOf<scene::Disk>("shape = \"disk\"\ninner_radius = 0.5").innerRadius, 0.5f);
  EXPECT_EQ(ShapeOf<scene::Rectangle>("shape = \"rectangle\"\nedge_u = [4, 0, 0]").edgeU,
            vec3(4, 0, 0));
  EXPECT_EQ(ShapeOf<scene::Box>("shape = \"box\"\nmax = [2, 3, 4]").upper, vec3(2, 3, 4));
  EXPECT_EQ(ShapeOf<scene::Cone>("shape = \"cylinder\"\nradius = 3").topRadius, 3);
  EXPECT_EQ(ShapeOf<scene::Cone>("shape = \"cone\"\nradius = 3").topRadius, 0);
  EXPECT_FALSE(ShapeOf<scene::Cone>("shape = \"cone\"\ncapped = false").capped);
  EXPECT_EQ(ShapeOf<scene::Torus>("shape = \"torus\"\naxis = [2, 0, 0]").axis, vec3(1, 0, 0));
}

TEST(TomlObjects, KnowTheirNamePlaceAndVisibility) {
  const scene::Object object =
      Read(
          "\n[[object]]\nname = \"ball\"\nshape = \"sphere\"\nvisible_to_camera = false\n"
          "visible_in_reflections = false\ncasts_shadow = false")
          .objects.at(0);
  EXPECT_EQ(object.name, "ball");
  EXPECT_EQ(object.place.line, 2);
  EXPECT_FALSE(object.visibleToCamera);
  EXPECT_FALSE(object.visibleToSecondary);
  EXPECT_FALSE(object.castsShadow);
}

TEST(TomlObjects, MayBeATriangle) {
  const scene::Scene scene = Read(R"([[object]]
shape = "triangle"
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
normals = [[0, 0, 2], [0, 0, 1], [0, 3, 3]]
uvs = [[0, 0], [1, 0], [0.5, 1]]
)");
  const scene::Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(std::get<scene::MeshGeometry>(scene.objects.at(0).geometry).mesh, 0);
  EXPECT_EQ(mesh.triangles, std::vector<scene::uvec3>{scene::uvec3(0, 1, 2)});
  EXPECT_EQ(mesh.normals.at(0), vec3(0, 0, 1));
  EXPECT_EQ(mesh.uvs.at(2), vec2(0.5f, 1));
}

TEST(TomlObjects, MayBeMeshesOfPolygons) {
  // A concave pentagon and a square that stands on its first edge
  const scene::Scene scene = Read(R"([[object]]
[object.mesh]
positions = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0], [4, 0, 4], [0, 0, 4]]
polygons = [[0, 1, 2, 3, 4], [1, 0, 6, 5]]
smooth = 0
)");
  const scene::Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(mesh.triangles.size(), 5u);
  EXPECT_TRUE(mesh.normals.empty());
  double area = 0;
  for (const scene::uvec3& t : mesh.triangles) {
    const vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    area += 0.5 * double(glm::length(glm::cross(b - a, c - a)));
  }
  EXPECT_NEAR(area, 16 - 6 + 16, 1e-5);
}

TEST(TomlObjects, SmoothMeshesUnderTheCreaseAngle) {
  // Two squares that meet at 30 degrees
  const std::string mesh =
      "[[object]]\nmesh = { positions = [[0, 0, 0], [0, 0, 1], [1, 0, 1], [1, 0, 0], [1.866, 0.5, "
      "1], [1.866, 0.5, 0]], "
      "polygons = [[0, 1, 2, 3], [3, 2, 4, 5]]";
  EXPECT_EQ(Read(mesh + " }").meshes.at(0).positions.size(), 6u);
  EXPECT_EQ(Read(mesh + " }").meshes.at(0).normals.size(), 6u);
  EXPECT_EQ(Read(mesh + ", smooth = 20 }").meshes.at(0).positions.size(), 8u);
  EXPECT_TRUE(Read(mesh + ", smooth = 0 }").meshes.at(0).normals.empty());
}

// --- Colours and textures

TEST(TomlColors, AreWrittenInManyWays) {
  const auto color = [](const std::string& value) {
    return Material("type = \"diffuse\"\ncolor = " + value).terms.at(1).color.value;
  };
  EXPECT_EQ(color("[0.1, 0.2, 0.3]"), vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(color("0.5"), vec3(0.5f));
  EXPECT_EQ(color("1"), vec3(1.0f));
  EXPECT_EQ(color("\"#ff0000\""), vec3(1, 0, 0));
  EXPECT_EQ(color("\"#0F0\""), vec3(0, 1, 0));
  // sRGB 128/255 and, on the linear foot of the curve, 10/255
  EXPECT_NEAR(color("\"#80800a\"").x, 0.2158605f, 1e-6);
  EXPECT_NEAR(color("\"#80800a\"").z, 10 / 255.0f / 12.92f, 1e-7);
}

TEST(TomlTextures, AreFoundByNameOrBuiltIn) {
  const scene::Scene scene = Read(R"(
[material.m]
type = "phong"
diffuse = "marble"
specular = { texture = "mine", tint = [1, 0.5, 0.25] }
ambient = "marble"
emission = { texture = "checker", tint = 20 }
[texture.mine]
type = "stripes"
space = "world"
smooth = true
color_a = "#f00"
)");
  const scene::Material& material = scene.materials.at(0);
  const auto texture = [&](const ColorInput& color) {
    return scene.textures.at(std::size_t(color.texture));
  };
  EXPECT_EQ(texture(material.terms.at(0).color).kind, scene::TextureKind::Marble);
  EXPECT_EQ(texture(material.terms.at(1).color).space, scene::TextureSpace::Object);
  EXPECT_EQ(material.terms.at(0).color.texture, material.terms.at(1).color.texture);
  EXPECT_EQ(material.terms.at(1).color.value, vec3(1.0f));
  EXPECT_EQ(texture(material.terms.at(2).color).kind, scene::TextureKind::Stripes);
  EXPECT_EQ(texture(material.terms.at(2).color).space, scene::TextureSpace::World);
  EXPECT_EQ(texture(material.terms.at(2).color).colorA, vec3(1, 0, 0));
  EXPECT_TRUE(texture(material.terms.at(2).color).smooth);
  EXPECT_EQ(material.terms.at(2).color.value, vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(material.emission.value, vec3(20.0f));
  EXPECT_EQ(scene.textures.size(), 3u);
}

TEST(TomlTextures, HideTheBuiltInOnesOfTheirName) {
  const scene::Scene scene = Read(
      "[material.m]\ntype = \"diffuse\"\ncolor = \"marble\"\n[texture.marble]\ntype = \"wood\"\n");
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].kind, scene::TextureKind::Wood);
}

// --- Materials

TEST(TomlMaterials, AreStacksOfTerms) {
  const scene::Material material = Material(R"(
terms = [{ type = "ambient", color = 0.1 }, { type = "blinn", color = "#fff", exponent = 99, normalized = true }, { type = "diffuse" }]
reflectivity = 0.5
reflection = "fresnel"
transparency = [0.1, 0.2, 0.3]
thin = true
priority = -3
attenuation_color = 0.5
attenuation_distance = 2)");
  ASSERT_EQ(material.terms.size(), 3u);
  EXPECT_EQ(material.terms[0].kind, TermKind::Ambient);
  EXPECT_EQ(material.terms[1].kind, TermKind::Blinn);
  EXPECT_EQ(material.terms[1].exponent, 99);
  EXPECT_TRUE(material.terms[1].normalized);
  EXPECT_EQ(material.terms[2].color.value, vec3(1.0f));
  EXPECT_EQ(material.reflection, scene::ReflectionModel::Fresnel);
  EXPECT_EQ(material.transparency.value, vec3(0.1f, 0.2f, 0.3f));
  EXPECT_TRUE(material.thin);
  EXPECT_EQ(material.priority, -3);
  EXPECT_EQ(material.attenuationDistance, 2);
}

TEST(TomlMaterials, HaveShorthands) {
  const scene::Material phong =
      Material("type = \"phong\"\ndiffuse = 0.5\nspecular = 0.25\nshininess = 7");
  ASSERT_EQ(phong.terms.size(), 3u);
  EXPECT_EQ(phong.terms[0].kind, TermKind::Ambient);
  EXPECT_EQ(phong.terms[0].color.value, vec3(0.5f));
  EXPECT_EQ(phong.terms[1].kind, TermKind::Diffuse);
  EXPECT_EQ(phong.terms[2].kind, TermKind::Phong);
  EXPECT_EQ(phong.terms[2].exponent, 7);
  EXPECT_FALSE(phong.terms[2].normalized);
  EXPECT_EQ(Material("type = \"blinn\"").terms.at(2).kind, TermKind::Blinn);

  // What is black is left out
  const scene::Material matt = Material("type = \"phong\"\nambient = 0\nspecular = 0");
  ASSERT_EQ(matt.terms.size(), 1u);
  EXPECT_EQ(matt.terms[0].kind, TermKind::Diffuse);

  const scene::Material glass = Material("type = \"dielectric\"\nior = 1.7\ncolor = [1, 0.5, 1]");
  EXPECT_EQ(glass.transparency.value, vec3(1, 0.5f, 1));
  EXPECT_EQ(glass.ior, 1.7f);
  EXPECT_TRUE(glass.terms.empty());

  const scene::Material mirror = Material("type = \"mirror\"\ncolor = 0.5");
  EXPECT_EQ(mirror.reflectivity.value, vec3(0.5f));
  EXPECT_EQ(mirror.reflection, scene::ReflectionModel::Constant);
  EXPECT_EQ(Material("type = \"metal\"").reflection, scene::ReflectionModel::Schlick);
}

TEST(TomlMaterials, CanStartFromPresets) {
  const scene::Scene scene = Read(R"(
[[object]]
shape = "sphere"
material = "glass"
[[object]]
shape = "sphere"
material = "glass"
[[object]]
shape = "sphere"
material = { preset = "glass", ior = 1.9 }
[[object]]
shape = "sphere"
material = "gold"
[[object]]
shape = "sphere"
[material.gold]
preset = "plastic"
diffuse = "#c01818"
)");
  const auto material = [&](std::size_t i) {
    return scene.materials.at(std::size_t(scene.objects.at(i).material));
  };
  EXPECT_EQ(scene.objects[0].material, scene.objects[1].material);
  EXPECT_FLOAT_EQ(material(0).ior, 1.5168f);
  EXPECT_EQ(material(0).transparency.value, vec3(1.0f));
  EXPECT_EQ(material(0).terms.at(0).kind, TermKind::Phong);
  EXPECT_TRUE(material(0).terms.at(0).normalized);
  EXPECT_EQ(material(2).ior, 1.9f);
  EXPECT_EQ(material(3).reflection, scene::ReflectionModel::Fresnel);
  EXPECT_NEAR(material(3).terms.at(1).color.value.x, 0.5271151f, 1e-6);
  EXPECT_FALSE(material(4).terms.empty());
}

TEST(TomlMaterials, OfAllPresetsAreValid) {
  std::string text;
  for (const Preset& preset : Presets())
    text += std::string("[[object]]\nshape = \"sphere\"\nmaterial = \"") + preset.name + "\"\n";
  TestScene file(text);
  const scene::Scene scene = file.Read();
  EXPECT_EQ(scene.materials.size(), Presets().size());
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_NO_THROW(scene::Validate(scene, {}));
}

}  // namespace
}  // namespace snell::io
