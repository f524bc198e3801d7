// SPDX-License-Identifier: Apache-2.0
//
// Pictures in native scenes: read, placed, shown by physical materials and maps, refused with their place.
#include <gtest/gtest.h>

#include <cmath>

#include "io/toml/test_scene.h"

namespace snell::io {
namespace {

TEST(TomlPictures, AreReadAndShownByMaterials) {
  TestScene file(R"(
[texture.bricks]
type = "image"
file = "bricks.png"
wrap_u = "mirror"
filter = "nearest"
[texture.relief]
type = "image"
file = "bricks.png"
data = true
[material.wall]
type = "openpbr"
base_color = "bricks"
base_metalness = 0.5
ior = 1.6
normal_map = "relief"
normal_scale = 0.7
[[object]]
shape = "sphere"
material = "wall"
)");
  file.Write("bricks.png", OnePixel);
  const scene::Scene scene = file.Read();
  ASSERT_EQ(scene.images.size(), 2u);
  EXPECT_EQ(scene.images[0].floats.size(), 4u);
  EXPECT_NEAR(scene.images[0].floats[0], 1.0f, 0.02f);
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(scene.textures[0].kind, scene::TextureKind::Image);
  EXPECT_EQ(scene.textures[0].image, 0);
  EXPECT_EQ(scene.textures[0].wrapU, scene::Wrap::Mirror);
  EXPECT_EQ(scene.textures[0].filter, scene::TextureFilter::Nearest);
  const scene::Material& wall = scene.materials.at(0);
  ASSERT_TRUE(wall.physical.has_value());
  EXPECT_EQ(wall.physical->baseColor.texture, 0);
  EXPECT_FLOAT_EQ(wall.physical->baseMetalness.value, 0.5f);
  EXPECT_FLOAT_EQ(wall.physical->specularIor, 1.6f);
  EXPECT_EQ(wall.normalMap.texture, 1);
  EXPECT_FLOAT_EQ(wall.normalMap.scale, 0.7f);
}

TEST(TomlPictures, ThatCannotBeReadAreFaultsWithTheirPlace) {
  TestScene file("[texture.t]\ntype = \"image\"\nfile = \"broken.png\"\n");
  file.Write("broken.png", "no picture");
  const std::vector<std::string> errors = file.Errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("scene.toml:3:"), std::string::npos) << errors[0];
  EXPECT_NE(errors[0].find("broken.png"), std::string::npos) << errors[0];
}

TEST(TomlEnvironment, ReadsMaps) {
  TestScene file(
      "[environment]\nmap = \"sky.hdr\"\nrotation = 90\nstrength = 2\nvisible = false\n");
  file.Write("sky.hdr", OnePixel);
  const scene::Scene scene = file.Read();
  ASSERT_EQ(scene.environment.map, 0);
  EXPECT_EQ(scene.images.at(0).width, 1);
  EXPECT_EQ(scene.environment.mapScale, scene::Spectrum(2.0f));
  EXPECT_NEAR(scene.environment.rotation, 1.5708f, 1e-4f);
  EXPECT_FALSE(scene.environment.visible);
  EXPECT_TRUE(scene.environment.ambient);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_NE(file.warnings[0].find("scene.toml:2:7"), std::string::npos) << file.warnings[0];
  EXPECT_NE(file.warnings[0].find("not twice as wide as high"), std::string::npos);

  file.Write("sky.hdr", "no picture");
  const std::vector<std::string> errors = file.Errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("scene.toml:2:7: cannot use the map"), std::string::npos) << errors[0];
}

TEST(TomlEnvironment, ReadsSkies) {
  const scene::Scene scene =
      TestScene(
          "[environment]\nstrength = 0.5\nrotation = 10\nsky = { elevation = 30, azimuth = 100 }\n")
          .Read();
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.environment.sun, 0);
  EXPECT_NEAR(scene.lights[0].direction.x, -0.866f, 1e-3f);
  EXPECT_NEAR(scene.lights[0].direction.y, -0.5f, 1e-3f);
  EXPECT_EQ(scene.lights[0].strength, 0.5f);
  EXPECT_NEAR(scene.environment.rotation, -1.5708f, 1e-3f);

  const scene::Scene alone =
      TestScene("[environment]\nsky = { direction = [1, 1, 0], sun = false }\n").Read();
  EXPECT_TRUE(alone.lights.empty());
  EXPECT_NEAR(alone.environment.rotation, -1.5708f, 1e-3f);

  // Summer's noon in London
  const scene::Scene noon =
      TestScene(
          "[environment]\nsky = { time = \"2026-06-21T12:02:00Z\", latitude = "
          "51.5, longitude = 0 }\n")
          .Read();
  EXPECT_NEAR(std::asin(-noon.lights.at(0).direction.y), 61.94f * 0.0174533f, 1e-3f);
  EXPECT_GT(noon.lights.at(0).direction.z, -1);
  EXPECT_LT(noon.lights.at(0).direction.z, -0.4f);
}

TEST(TomlEnvironment, RefusesHalfAPlace) {
  const auto errors =
      TestScene("[environment]\nsky = { time = \"2026-06-21T12:00:00Z\", latitude = 5 }\n")
          .Errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("belong together"), std::string::npos) << errors[0];
  const auto bad = TestScene("[environment]\nsky = { time = \"noon\" }\n").Errors();
  ASSERT_EQ(bad.size(), 1u);
  EXPECT_NE(bad[0].find("scene.toml:2:16: 'time': expected a time"), std::string::npos) << bad[0];
}

}  // namespace
}  // namespace snell::io
