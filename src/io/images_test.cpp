// SPDX-License-Identifier: Apache-2.0
#include "io/images.h"

#include <gtest/gtest.h>

#include <limits>

#include "image/color.h"
#include "io/obj/test_scene.h"
#include "util/file.h"

namespace snell::io {
namespace {

using image::vec3;

scene::Image Decode(const ObjTestScene& test, const std::string& name, ImageUse use) {
  return DecodeTexels(ReadFile(test.folder() / name), name, use);
}

TEST(Images, EveryByteIsKept) {
  image::Image picture(256, 1);
  for (int x = 0; x < 256; ++x) picture.At(x, 0) = image::DecodeSrgb(vec3(float(x) / 255));
  const ObjTestScene test;
  image::WriteImage(test.folder() / "a.png", picture);
  for (const ImageUse use : {ImageUse::Color, ImageUse::Data}) {
    const scene::Image texels = Decode(test, "a.png", use);
    EXPECT_EQ(texels.srgb, use == ImageUse::Color);
    EXPECT_TRUE(texels.floats.empty());
    ASSERT_EQ(texels.bytes.size(), 1024u);
    for (std::size_t x = 0; x < 256; ++x) {
      EXPECT_EQ(texels.bytes[x * 4], x);
      EXPECT_EQ(texels.bytes[x * 4 + 3], 255);
    }
  }
  image::WriteImage(test.folder() / "a.jpg", picture);
  EXPECT_EQ(Decode(test, "a.jpg", ImageUse::Color).bytes.size(), 1024u);
}

TEST(Images, DeepPicturesBecomeFloats) {
  ObjTestScene test;
  image::Image picture(2, 1);
  picture.pixels = {vec3(0.2f, 0.3f, 0.4f), vec3(7, -1, std::numeric_limits<float>::infinity())};
  image::WriteImage(test.folder() / "a.png", picture, {.bits = 16});
  const scene::Image color = Decode(test, "a.png", ImageUse::Color);
  ASSERT_EQ(color.floats.size(), 8u);
  EXPECT_NEAR(color.floats[1], 0.3f, 1e-4f);
  const scene::Image data = Decode(test, "a.png", ImageUse::Data);
  EXPECT_NEAR(data.floats[1], image::EncodeSrgb(0.3f), 1e-4f);

  image::WriteImage(test.folder() / "a.exr", picture, {.exrFloat = true});
  const scene::Image light = Decode(test, "a.exr", ImageUse::Color);
  EXPECT_EQ(light.floats, (std::vector<float>{0.2f, 0.3f, 0.4f, 1, 7, 0, 0, 1}));
  EXPECT_EQ(Decode(test, "a.exr", ImageUse::Data).floats[5], -1);
}

TEST(Images, WebpHasCodesAsPngHas) {
  // A lossless picture of one pixel
  const char file[] =
      "RIFF\x1a\0\0\0WEBPVP8L\x0d\0\0\0\x2f\0\0\0\x10\x07\x10\x11\x11\x88\x88\xfe\x07";
  const std::string bytes(file, sizeof file);
  const scene::Image color = DecodeTexels(bytes, "a.webp", ImageUse::Color);
  EXPECT_EQ(color.bytes.size(), 4u);
  EXPECT_TRUE(color.srgb);
  EXPECT_FALSE(DecodeTexels(bytes, "a.webp", ImageUse::Data).srgb);
}

TEST(Images, AlphaIsNotMultiplied) {
  ObjTestScene test;
  test.Paint("a.png", vec3(1, 0, 0), 0.5f);
  EXPECT_EQ(Decode(test, "a.png", ImageUse::Color).bytes,
            (std::vector<std::uint8_t>{255, 0, 0, 255, 255, 0, 0, 128}));
}

TEST(Images, LoadsEachFileOnceAndNothingOutside) {
  ObjTestScene outside, test;
  outside.Paint("secret.png", vec3(1));
  test.Write("bad.png", "\x89PNG\r\n\x1a\n").Write("sub/empty", "").Paint("sub/Good.png", vec3(1));
  std::filesystem::create_symlink(outside.folder() / "secret.png", test.folder() / "link.png");
  int warnings = 0;
  ImageLoader loader({test.folder()}, [&](const Diagnostic&) { ++warnings; });
  scene::Scene scene;
  const auto load = [&](const std::string& name, ImageUse use = ImageUse::Color) {
    return loader.Load(scene, name, use, {});
  };
  EXPECT_EQ(load("sub/Good.png"), 0);
  EXPECT_EQ(load("sub\\good.PNG"), 0);
  EXPECT_EQ(load("./sub/../sub/Good.png"), 0);
  EXPECT_EQ(load("sub/Good.png", ImageUse::Data), 1);
  EXPECT_EQ(loader.Load(scene, "good.png", ImageUse::Color, {}, test.folder() / "sub"), 0);
  EXPECT_EQ(warnings, 0);
  EXPECT_EQ(load("bad.png"), -1);
  EXPECT_EQ(load("bad.png"), -1);
  EXPECT_EQ(warnings, 1);
  for (const std::string& name :
       {std::string("link.png"), std::string("none.png"), std::string(), std::string("sub"),
        std::string("a\0b", 3), std::string("../"), (outside.folder() / "secret.png").string()})
    EXPECT_EQ(load(name), -1) << name;
  EXPECT_EQ(warnings, 8);
  for (int i = 0; i < 1000; ++i) load(std::to_string(i));
  EXPECT_EQ(warnings, 32);
  EXPECT_EQ(scene.images.size(), 2u);
}

}  // namespace
}  // namespace snell::io
