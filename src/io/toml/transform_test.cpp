// SPDX-License-Identifier: Apache-2.0
//
// Transforms as scenes write them, against maps worked out by hand: steps, groups, lights in groups.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>

#include "io/toml/sections.h"
#include "io/toml/test_scene.h"

namespace snell::io {
namespace {

using glm::dvec3;
using glm::dvec4;

// Where the first object of a scene puts a point of its own space.
dvec3 Moved(const scene::Object& object, const dvec3& p) {
  return dvec3(object.toWorld * dvec4(p, 1.0));
}

dvec3 Moved(const std::string& transforms, const dvec3& p) {
  const scene::Scene scene = TestScene("[[object]]\nshape = \"sphere\"\n" + transforms).Read();
  return Moved(scene.objects.at(0), p);
}

void ExpectNear(const dvec3& a, const dvec3& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(TomlTransform, IsTheIdentityUnlessGiven) {
  const scene::Scene scene = TestScene("[[object]]\nshape = \"sphere\"\n").Read();
  EXPECT_EQ(scene.objects[0].toWorld, Affine(1.0));
}

TEST(TomlTransform, ScalesThenRotatesThenTranslates) {
  // Whatever the order of the keys
  const char* const text = R"(
translate = [10, 0, 0]
scale = [2, 3, 4]
rotate = { axis = "y", angle = 90 })";
  EXPECT_EQ(Moved(text, {1, 0, 0}), dvec3(10, 0, -2));
  EXPECT_EQ(Moved(text, {0, 1, 0}), dvec3(10, 3, 0));
  EXPECT_EQ(Moved(text, {0, 0, 1}), dvec3(14, 0, 0));
}

TEST(TomlTransform, TurnsByTheRightHandRule) {
  EXPECT_EQ(Moved("rotate = { axis = \"x\", angle = 90 }", {0, 1, 0}), dvec3(0, 0, 1));
  EXPECT_EQ(Moved("rotate = { axis = \"z\", angle = 90 }", {1, 0, 0}), dvec3(0, 1, 0));
  EXPECT_EQ(Moved("rotate = { axis = \"z\", angle = -450 }", {1, 0, 0}), dvec3(0, -1, 0));
  ExpectNear(Moved("rotate = { axis = \"z\", angle = 30 }", {1, 0, 0}), {std::sqrt(0.75), 0.5, 0});
  // A third of a turn about the diagonal exchanges the axes
  ExpectNear(Moved("rotate = { axis = [5, 5, 5], angle = 120 }", {1, 2, 3}), {3, 1, 2});
}

TEST(TomlTransform, AppliesTurnsAndStepsFromFirstToLast) {
  EXPECT_EQ(
      Moved("rotate = [{ axis = \"x\", angle = 90 }, { axis = \"y\", angle = 90 }]", {0, 1, 0}),
      dvec3(1, 0, 0));
  EXPECT_EQ(
      Moved("transform = [{ translate = [1, 0, 0] }, { scale = 2 }, { translate = [0, 0, 5] }]",
            {1, 1, 1}),
      dvec3(4, 2, 7));
  EXPECT_EQ(Moved("transform = []", {1, 2, 3}), dvec3(1, 2, 3));
}

TEST(TomlTransform, LooksWithTheZAxis) {
  const char* const text = "transform = [{ look_at = { from = [1, 2, 3], to = [5, 2, 3] } }]";
  ExpectNear(Moved(text, {0, 0, 0}), {1, 2, 3});
  ExpectNear(Moved(text, {0, 0, 1}), {2, 2, 3});
  ExpectNear(Moved(text, {0, 1, 0}), {1, 3, 3});
  ExpectNear(Moved(text, {1, 0, 0}), {1, 2, 2});
}

TEST(TomlTransform, TakesMatricesRowByRow) {
  const char* const twelve = "transform = [{ matrix = [1, 2, 0, 10,  0, 1, 0, 20,  0, 0, 1, 30] }]";
  const char* const sixteen =
      "transform = [{ matrix = [1, 2, 0, 10,  0, 1, 0, 20,  0, 0, 1, 30,  0, 0, 0, 1] }]";
  EXPECT_EQ(Moved(twelve, {1, 1, 1}), dvec3(13, 21, 31));
  EXPECT_EQ(Moved(sixteen, {1, 1, 1}), dvec3(13, 21, 31));
}

TEST(TomlTransform, MayMirror) {
  const scene::Scene scene =
      TestScene("[[object]]\nshape = \"sphere\"\nscale = [-1, 2, 3]\n").Read();
  EXPECT_EQ(glm::determinant(scene.objects[0].toWorld), -6);
}

TEST(TomlTransform, PlacesTextures) {
  const scene::Scene scene = TestScene(R"(
[texture.plain]
type = "wood"
[texture.moved]
type = "wood"
translate = [1, 2, 3]
[texture.scaled]
type = "wood"
scale = 3
[texture.steps]
type = "wood"
transform = [{ translate = [1, 2, 3] }]
)")
                                 .Read();
  const auto corner = [&](int i) {
    return dvec3(scene.textures.at(std::size_t(i)).placement * dvec4(1, 1, 1, 1));
  };
  ExpectNear(corner(0), dvec3(0.12));
  ExpectNear(corner(1), dvec3(1.12, 2.12, 3.12));
  ExpectNear(corner(2), dvec3(3));
  ExpectNear(corner(3), dvec3(2, 3, 4));  // all of the placement
}

const char* const Forest = R"(
[[object]]
name = "forest"
group = "pair"
scale = 2
material = "gold"
[[object]]
group = "pair"
translate = [0, 0, 100]
casts_shadow = false

[[group.pair.object]]
name = "left"
group = "tree"
translate = [-1, 0, 0]
material = "chrome"
[[group.pair.object]]
group = "tree"
translate = [1, 0, 0]
rotate = { axis = "y", angle = 180 }
scale = [-1, 1, 1]

[[group.tree.object]]
name = "crown"
shape = "sphere"
translate = [0, 3, 0]
[[group.tree.object]]
shape = "cylinder"
material = "rubber"
visible_to_camera = false
)";

TEST(TomlGroups, MultiplyOuterByInner) {
  const scene::Scene scene = TestScene(Forest).Read();
  ASSERT_EQ(scene.objects.size(), 8u);
  EXPECT_EQ(Moved(scene.objects[0], {0, 0, 0}), dvec3(-2, 6, 0));
  EXPECT_EQ(Moved(scene.objects[0], {1, 0, 0}), dvec3(0, 6, 0));
  EXPECT_EQ(Moved(scene.objects[2], {1, 0, 1}), dvec3(4, 6, -2));
  EXPECT_EQ(Moved(scene.objects[4], {0, 0, 0}), dvec3(-1, 3, 100));
  EXPECT_GT(glm::determinant(scene.objects[0].toWorld), 0);
  EXPECT_LT(glm::determinant(scene.objects[2].toWorld), 0);
}

TEST(TomlGroups, HandMaterialsDownToMembersThatHaveNone) {
  const scene::Scene scene = TestScene(Forest).Read();
  const auto material = [&](std::size_t i) {
    return scene.materials.at(std::size_t(scene.objects[i].material)).name;
  };
  EXPECT_EQ(material(0), "chrome");
  EXPECT_EQ(material(1), "rubber");
  EXPECT_EQ(material(2), "gold");
  EXPECT_EQ(material(4), "chrome");
  EXPECT_EQ(material(6), material(6));
  EXPECT_NE(material(6), "gold");
  EXPECT_EQ(scene.materials.size(), 4u);
}

TEST(TomlGroups, HandDownNamesAndVisibility) {
  const scene::Scene scene = TestScene(Forest).Read();
  EXPECT_EQ(scene.objects[0].name, "forest/left/crown");
  EXPECT_EQ(scene.objects[2].name, "forest/crown");
  EXPECT_EQ(scene.objects[3].name, "forest");
  EXPECT_TRUE(scene.objects[0].visibleToCamera);
  EXPECT_FALSE(scene.objects[1].visibleToCamera);
  EXPECT_TRUE(scene.objects[0].castsShadow);
  EXPECT_FALSE(scene.objects[4].castsShadow);
  EXPECT_EQ(scene.objects[0].place.line, 23);
}

TEST(TomlGroups, ShareTheMeshesOfTheirMembers) {
  const scene::Scene scene = TestScene(R"(
[[object]]
group = "g"
[[object]]
group = "g"
translate = [1, 0, 0]
[[group.g.object]]
shape = "triangle"
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
)")
                                 .Read();
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.meshes.size(), 1u);
}

TEST(TomlGroups, MoveTheirLights) {
  const scene::Scene scene = TestScene(R"(
[[object]]
name = "lamp"
group = "lamp"
scale = [-2, 2, 2]
translate = [0, 5, 0]
[[group.lamp.light]]
name = "bulb"
type = "sphere"
center = [1, 0, 0]
radius = 0.5
power = 80
[[group.lamp.light]]
type = "rectangle"
corner = [0, 0, 0]
edge_u = [1, 0, 0]
edge_v = [0, 0, 1]
radiance = 3
[[group.lamp.light]]
type = "spot"
direction = [1, 0, 0]
)")
                                 .Read();
  ASSERT_EQ(scene.lights.size(), 3u);
  const scene::Light& bulb = scene.lights[0];
  EXPECT_EQ(bulb.name, "lamp/bulb");
  EXPECT_EQ(bulb.position, vec3(-2, 5, 0));
  EXPECT_FLOAT_EQ(bulb.radius, 1);
  // All of the power still leaves the larger surface: 80 W over π · 4π · 1² sr·m²
  EXPECT_NEAR(bulb.strength, 80 / (4 * M_PI * M_PI), 1e-5);

  // (1, 0, 0) × (0, 0, 1) shines down; so does the mirrored light
  const scene::Light& panel = scene.lights[1];
  EXPECT_EQ(glm::cross(panel.edgeU, panel.edgeV), vec3(0, -4, 0));
  EXPECT_EQ(panel.strength, 3);
  EXPECT_EQ(scene.lights[2].direction, vec3(-1, 0, 0));
}

TEST(TomlGroups, RefuseWhatCannotBePlaced) {
  const char* const lamp = "[[group.g.light]]\ntype = \"sphere\"\n";
  EXPECT_EQ(
      TestScene(std::string("[[object]]\ngroup = \"g\"\nscale = [1, 2, 1]\n") + lamp).Errors(),
      std::vector<std::string>{
          "scene.toml:4:1: a round light cannot be scaled unevenly by its groups"});

  std::string tiny =
      "[[object]]\ngroup = \"g\"\nscale = 1e-9\n[[group.g.object]]\nshape = \"box\"\nscale = "
      "1e-9\n";
  EXPECT_EQ(TestScene(tiny).Errors(),
            std::vector<std::string>{
                "scene.toml:4:1: the transforms of the groups around this object cannot be used: "
                "it scales by 1e-18; the limits are 1e-15 and 1e+15"});
}

TEST(TomlGroups, StayWithinTheirLimits) {
  // Each group holds the next one twice: 2⁴⁰ boxes
  std::string text = "[[object]]\ngroup = \"g0\"\n";
  for (int i = 0; i < 40; ++i)
    for (int twice = 0; twice < 2; ++twice)
      text += "[[group.g" + std::to_string(i) + ".object]]\ngroup = \"g" + std::to_string(i + 1) +
              "\"\n";
  const std::string end = "[[group.g40.object]]\nshape = \"box\"\n";
  const std::vector<std::string> tooMany = TestScene(text + end).Errors();
  ASSERT_EQ(tooMany.size(), 1u);
  EXPECT_EQ(
      tooMany[0],
      "scene.toml: with all groups placed the scene has more than 10,000,000 objects and lights; "
      "--limit objects=N raises the limit");

  // The same without anything in the end
  EXPECT_TRUE(TestScene(text + "[group.g40]\n").Read().objects.empty());

  std::string deep = "[[object]]\ngroup = \"g0\"\n";
  for (int i = 0; i < 5000; ++i)
    deep +=
        "[[group.g" + std::to_string(i) + ".object]]\ngroup = \"g" + std::to_string(i + 1) + "\"\n";
  const std::vector<std::string> tooDeep = TestScene(deep + "[group.g5000]\n").Errors();
  ASSERT_EQ(tooDeep.size(), 1u);
  EXPECT_EQ(tooDeep[0], "scene.toml:129:1: groups are nested more than 64 deep");
}

}  // namespace
}  // namespace snell::io
