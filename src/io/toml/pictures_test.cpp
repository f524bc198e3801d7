// SPDX-License-Identifier: Apache-2.0
//
// Pictures in native scenes: read, placed, shown by physical materials and maps, refused with their place.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace snell::io
