// SPDX-License-Identifier: Apache-2.0
//
// Objects that are files: what is taken in of them, where it is placed, and what is refused.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "io/gltf/test_files.h"
#include "io/toml/test_scene.h"

namespace snell::io {
namespace {

using Lines = std::vector<std::string>;
using scene::vec3;

const char* const Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

// Two nodes that show one mesh, in two materials that a variant exchanges, a lamp of 10 cd and a camera.
std::string ChairGltf() {
  GltfBuilder builder;
  const int positions = builder.AddTriangle();
  const auto primitive = [&](int material, int other) {
    return fmt::format(
        R"({{"attributes": {{"POSITION": {}}}, "material": {}, "extensions": {{"KHR_materials_variants":
{{"mappings": [{{"material": {}, "variants": [1]}}]}}}}}})",
        positions, material, other);
  };
  return builder.Document(fmt::format(R"("extensionsUsed": ["KHR_lights_punctual"],
"extensions": {{"KHR_lights_punctual": {{"lights": [{{"type": "point", "intensity": 10}}]}},
  "KHR_materials_variants": {{"variants": [{{"name": "plain"}}, {{"name": "exchanged"}}]}}}},
"materials": [{{"name": "Seat"}}, {{"name": "Legs", "emissiveFactor": [1, 1, 1]}}],
"cameras": [{{"type": "perspective", "perspective": {{"yfov": 1, "znear": 0.1}}}}],
"meshes": [{{"name": "chair", "primitives": [{}, {}]}}],
"scenes": [{{"name": "Day", "nodes": [0, 1, 2, 3]}}, {{"name": "Night", "nodes": [1]}}],
"nodes": [{{"mesh": 0, "name": "left"}}, {{"mesh": 0, "name": "right", "translation": [2, 0, 0]}},
  {{"translation": [0, 3, 0], "extensions": {{"KHR_lights_punctual": {{"light": 0}}}}}},
  {{"camera": 0, "name": "eye"}}])",
                                      primitive(0, 1), primitive(1, 0)));
}

TEST(TomlInclusion, TakesInObjectsAndLightsOfGltf) {
  TestScene file(R"(
[[object]]
name = "a"
file = "sub/chair.gltf"
translate = [0, 0, 5]
casts_shadow = false
[[object]]
file = "sub/../sub/chair.gltf"
scale = 2
lights = false
cameras = true
)");
  file.Write("sub/chair.gltf", ChairGltf());
  const scene::Scene scene = file.Read();
  EXPECT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.materials.size(), 2u);
  ASSERT_EQ(scene.objects.size(), 8u);
  EXPECT_EQ(scene.objects[0].name, "a/left");
  EXPECT_FALSE(scene.objects[0].castsShadow);
  EXPECT_EQ(scene.objects[2].toWorld[3], glm::dvec4(2, 0, 5, 1));
  EXPECT_EQ(scene.objects[6].toWorld[3], glm::dvec4(4, 0, 0, 1));
  EXPECT_EQ(scene.objects[5].name, "left");
  EXPECT_TRUE(scene.objects[5].castsShadow);
  EXPECT_EQ(std::get<scene::MeshGeometry>(scene.objects[4].geometry).mesh, 0);

  // Candela count as W/sr, nits as W/(sr·m²)
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_FLOAT_EQ(scene.lights[0].strength, 10);
  EXPECT_EQ(scene.lights[0].position, vec3(0, 3, 5));
  EXPECT_EQ(scene.materials[1].physical->emission.value, vec3(1));
  EXPECT_EQ(scene.settings.exposure, 0);
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].name, "eye");
}

TEST(TomlInclusion, ReplacesMaterials) {
  TestScene file(R"(
[material.red]
type = "diffuse"
[[object]]
file = "chair.gltf"
materials = { Seat = "red" }
[[object]]
file = "chair.gltf"
material = "gold"
materials = { Legs = { type = "mirror" } }
[[object]]
file = "chair.gltf"
)");
  file.Write("chair.gltf", ChairGltf());
  const scene::Scene scene = file.Read();
  std::vector<std::string> names;
  for (const scene::Object& object : scene.objects)
    names.push_back(scene.materials[std::size_t(object.material)].name);
  EXPECT_EQ(names, (Lines{"red", "Legs", "red", "Legs", "gold", "", "gold", "", "Seat", "Legs",
                          "Seat", "Legs"}));
  EXPECT_EQ(scene.meshes.size(), 2u);
}

TEST(TomlInclusion, ChoosesSceneVariantAndStrength) {
  TestScene file(R"(
[[object]]
file = "chair.gltf"
scene = "Night"
variant = "exchanged"
[[object]]
file = "chair.gltf"
light_scale = 0.5
time = 1
)");
  file.Write("chair.gltf", ChairGltf());
  const scene::Scene scene = file.Read();
  ASSERT_EQ(scene.objects.size(), 6u);
  EXPECT_EQ(scene.objects[0].name, "right");
  EXPECT_EQ(scene.materials[std::size_t(scene.objects[0].material)].name, "Legs");
  EXPECT_EQ(scene.materials[std::size_t(scene.objects[2].material)].name, "Seat");
  EXPECT_FLOAT_EQ(scene.lights.at(0).strength, 5);
  EXPECT_EQ(file.warnings.back(),
            "scene.toml:7:8: 'chair.gltf' has no animations: the time changes nothing");
}

TEST(TomlInclusion, RefusesNamesThatTheFileDoesNotHave) {
  const auto errors = [](const char* keys) {
    TestScene file(std::string("[[object]]\nfile = \"chair.gltf\"\n") + keys);
    return file.Write("chair.gltf", ChairGltf()).Errors();
  };
  EXPECT_EQ(
      errors("materials = { Seet = \"gold\", Zebra = \"gold\" }\n"),
      (Lines{"scene.toml:3:15: 'chair.gltf' has no material 'Seet'; did you mean 'Seat'?",
             "scene.toml:3:30: 'chair.gltf' has no material 'Zebra'; it has 'Seat', 'Legs'"}));
  EXPECT_EQ(errors("scene = \"Nigth\"\n"),
            Lines{"scene.toml:2:8: cannot include chair.gltf: there is no scene 'Nigth'; did you "
                  "mean 'Night'?"});
  EXPECT_EQ(errors("variant = \"plane\"\n"),
            Lines{"scene.toml:2:8: cannot include chair.gltf: there is no variant 'plane'; did you "
                  "mean 'plain'?"});
  EXPECT_EQ(errors("smooth = 3\n"), Lines{"scene.toml:3:10: 'smooth' is for mesh files"});
}

TEST(TomlInclusion, KeepsTheMaterialsOfObjUnlessOneReplacesAll) {
  TestScene file(R"(
[[object]]
file = "t.obj"
[[object]]
file = "t.obj"
material = "glass"
[[object]]
group = "g"
material = "gold"
[[group.g.object]]
file = "t.obj"
[[object]]
file = "c.ply"
[[object]]
file = "c.obj"
)");
  file.Write("t.mtl", "newmtl red\nKd 1 0 0\n");
  file.Write("t.obj", std::string(Triangle) +
                          "mtllib t.mtl\nusemtl red\nf 1 2 3\no rest\nusemtl none\nf 3 2 1\n");
  file.Write("c.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
  file.Write("c.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const scene::Scene scene = file.Read();
  std::vector<std::string> names;
  for (const scene::Object& object : scene.objects)
    names.push_back(scene.materials[std::size_t(object.material)].name);
  EXPECT_EQ(names, (Lines{"red", "default", "glass", "red", "gold", "default", "vertex colors"}));
}

TEST(TomlInclusion, TakesInNativeScenesAndNff) {
  TestScene file(R"(
[[object]]
name = "lamp"
file = "parts/lamp.toml"
translate = [1, 0, 0]
[[object]]
file = "parts/ball.nff"
lights = false
)");
  file.Write("parts/lamp.toml", R"(
[environment]
color = 1
[material.shade]
type = "diffuse"
color = "checker"
[[light]]
type = "point"
name = "bulb"
[[object]]
name = "foot"
shape = "box"
material = "shade"
[[object]]
file = "../mesh.obj"
)");
  file.Write("mesh.obj", std::string(Triangle) + "f 1 2 3\n");
  file.Write("parts/ball.nff",
             "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 8\nl 0 5 0\n"
             "f 1 0 0 1 0 0 0 0\ns 0 0 0 1\n");
  const scene::Scene scene = file.Read();
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[0].name, "lamp/foot");
  EXPECT_EQ(scene.objects[0].toWorld[3], glm::dvec4(1, 0, 0, 1));
  const scene::Material& shade = scene.materials.at(std::size_t(scene.objects[0].material));
  EXPECT_EQ(shade.name, "shade");
  EXPECT_EQ(scene.textures.at(std::size_t(shade.terms.at(0).color.texture)).name, "checker");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].name, "lamp/bulb");
  EXPECT_EQ(scene.lights[0].position.x, 1);
  EXPECT_TRUE(scene.cameras.empty());
  EXPECT_EQ(scene.environment.top, vec3(0));
}

TEST(TomlInclusion, MayNotGoInCirclesNorDeepDown) {
  TestScene circle("[[object]]\nfile = \"a.toml\"\n");
  circle.Write("a.toml", "[[object]]\nfile = \"scene.toml\"\n");
  EXPECT_EQ(circle.Errors(), Lines{"a.toml:2:8: 'scene.toml' includes itself"});

  TestScene deep("[[object]]\nfile = \"1.toml\"\n");
  for (int i = 1; i < 40; ++i)
    deep.Write(std::to_string(i) + ".toml",
               "[[object]]\nfile = \"" + std::to_string(i + 1) + ".toml\"\n");
  deep.Write("40.toml", "");
  EXPECT_EQ(deep.Errors(), Lines{"16.toml:2:8: files are included more than 16 deep"});
}

TEST(TomlInclusion, OfABadSceneTwiceIsNoCircle) {
  TestScene file("[[object]]\nfile = \"a.toml\"\n[[object]]\nfile = \"b.toml\"\n");
  file.Write("a.toml", "x = 1\n").Write("b.toml", "[[object]]\nfile = \"a.toml\"\n");
  for (const std::string& line : file.Errors())
    EXPECT_EQ(line, "a.toml:1:1: unknown key 'x' in the scene file");
}

TEST(TomlInclusion, TellsMistakesWhereTheyStand) {
  TestScene file("[[object]]\nfile = \"a.toml\"\n[[object]]\nfile = \"b.gltf\"\n");
  file.Write("a.toml", "\n[[object]]\nshape = \"spere\"\n").Write("b.gltf", "{}");
  const Lines errors = file.Errors();
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_TRUE(errors[0].starts_with("scene.toml:4:8: cannot include b.gltf: ")) << errors[0];
  EXPECT_TRUE(errors[1].starts_with("a.toml:3:9: 'shape': unknown choice 'spere'")) << errors[1];
}

TEST(TomlInclusion, ReadsNothingOutsideOfTheScenesFolder) {
  TestScene outside;
  outside.Write("secret.png", OnePixel);
  TestScene file("[[object]]\nfile = \"sub/a.obj\"\n");
  file.Write("sub/a.obj", std::string(Triangle) + "mtllib a.mtl\nusemtl m\nf 1 2 3\n");
  const auto images = [&](const std::string& name) {
    file.Write("sub/a.mtl", "newmtl m\nmap_Kd " + name + "\n");
    return file.Read().images.size();
  };
  file.Write("inside.png", OnePixel);
  EXPECT_EQ(images("../inside.png"), 1u);
  const std::string other = outside.folder().filename().string();
  std::filesystem::create_symlink(outside.folder() / "secret.png", file.folder() / "sub/link.png");
  EXPECT_EQ(images("../../" + other + "/secret.png"), 0u);
  EXPECT_EQ(images((outside.folder() / "secret.png").string()), 0u);
  EXPECT_EQ(images("link.png"), 0u);

  // Unless it may
  file.options.folders = {outside.folder()};
  EXPECT_EQ(images("../../" + other + "/secret.png"), 1u);
  EXPECT_EQ(images((outside.folder() / "secret.png").string()), 1u);
  EXPECT_EQ(images("link.png"), 1u);
  EXPECT_EQ(images("secret.png"), 1u);
  EXPECT_EQ(images("/etc/secret2.png"), 0u);
}

// Every model of the shared assets holds as much in a scene as alone.
TEST(TomlInclusion, TakesInTheAssets) {
  std::error_code ignored;
  const auto assets = std::filesystem::weakly_canonical(
      std::filesystem::path(SNELL_SOURCE_DIR) / ".." / "shared" / "assets" / "gltf", ignored);
  if (!std::filesystem::is_directory(assets, ignored))
    GTEST_SKIP() << "the folder of shared assets is absent";
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(assets)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".gltf" && extension != ".glb") continue;
    TestScene file("[[object]]\nfile = \"" + entry.path().string() + "\"\nscale = 2\n");
    file.options.folders = {assets};
    std::size_t objects = 0;
    try {
      objects = ReadGltf(entry.path(), {}, {}).scene.objects.size();
    } catch (const Error&) {
      EXPECT_FALSE(file.Errors().empty()) << entry.path();
      continue;
    }
    ++count;
    EXPECT_EQ(file.Errors(), Lines()) << entry.path();
    EXPECT_EQ(file.Read().objects.size(), objects) << entry.path();
  }
  EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace snell::io
