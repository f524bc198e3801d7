// SPDX-License-Identifier: Apache-2.0
//
// What statements of material libraries become.
#include "io/obj/mtl.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/obj/mtl_material.h"
#include "io/obj/test_scene.h"

namespace snell::io {
namespace {

using scene::AlphaMode;
using scene::Material;
using scene::vec2;
using scene::vec3;

MtlMap MapOf(const std::string& text, Findings* findings = nullptr) {
  Findings ignored;
  return ReadMtlMap(text, {.file = "a.mtl", .line = 7}, findings ? *findings : ignored);
}

TEST(Mtl, MapOptionsStandBeforeOrAfterTheName) {
  const MtlMap map = MapOf("-s 2 3 1 -o 0.5 -clamp on -bm 0.25 -imfchan m 2 my file.png");
  EXPECT_EQ(map.scale, vec2(2, 3));
  EXPECT_EQ(map.offset, vec2(0.5f, 0));
  EXPECT_TRUE(map.clamp);
  EXPECT_EQ(map.bump, 0.25f);
  EXPECT_EQ(map.channel, 'm');
  EXPECT_EQ(map.name, "2 my file.png");
  const MtlMap after = MapOf("-colorspace sRGB  bump map.jpg -bm 1.5");
  EXPECT_EQ(after.name, "bump map.jpg");
  EXPECT_EQ(after.bump, 1.5f);
  EXPECT_EQ(after.colorSpace, "srgb");
  EXPECT_EQ(MapOf("-s 1 1 1 2.png").name, "2.png");
  EXPECT_EQ(MapOf("\"a b.png\"").name, "a b.png");
}

TEST(Mtl, MapErrorsNameTheLine) {
  EXPECT_THROW(MapOf(""), Error);
  EXPECT_THROW(MapOf("-s"), Error);
  EXPECT_THROW(MapOf("-mm 1 a.png"), Error);
  EXPECT_THROW(MapOf("-clamp"), Error);
  try {
    MapOf("-bm x.png");
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a.mtl:7: option '-bm' needs 1 number");
  }
}

TEST(Mtl, ErrorsNameTheLine) {
  ObjTestScene test;
  const auto errorOf = [&](const std::string& text) {
    test.ReadMaterial(text);
    return test.error;
  };
  EXPECT_EQ(errorOf("Kd 1 x 0\n"), "a.mtl:2: 'x' is not a number");
  EXPECT_EQ(errorOf("\r\nKd\r\n"), "a.mtl:3: a color needs one number or three");
  EXPECT_EQ(errorOf("Ns\n"), "a.mtl:2: 'Ns' needs a number");
  EXPECT_EQ(errorOf("newmtl\n"), "a.mtl:2: 'newmtl' needs a name");
  EXPECT_EQ(errorOf(std::string("Ns 1\0", 5)),
            "a.mtl: not a text file in ASCII or UTF-8: it holds zero bytes");
}

TEST(Mtl, OddStatementsAreCounted) {
  ObjTestScene test;
  const Material material = test.ReadMaterial(
      "Kt 1 1 1\nKt 0 0 0\nbleh\nNs nan\nKd 2 -1 0.5\nrefl a.png\ndecal b.png\ndecal c.png\n"
      "Ka 1 1 1\nnewmtl m\nKd 0 0 0\n");
  EXPECT_EQ(material.physical->baseColor.value, vec3(1, 0, 0.5f));
  EXPECT_EQ(test.warnings,
            (std::vector<std::string>{
                "a.mtl:2: 3 unknown material statements left out, the first one 'Kt'",
                "a.mtl:5: 1 number of materials infinite or undefined, left out",
                "a.mtl:7: 1 reflection map not read: 'a.png'",
                "a.mtl:8: 2 decals not read, the first one 'b.png'",
                "a.mtl:11: 1 material defined twice; the first definition counts: 'm'",
                "a.mtl:1: 1 color of materials beyond what is possible, clamped: 'm'"}));
}

TEST(Mtl, DiffuseAndHighlight) {
  ObjTestScene test;
  Material material = test.ReadMaterial("Kd 0.2 0.3 0.4\nKs 0.2 0.4 0.1\nNs 30\nNi 1.7\n");
  EXPECT_EQ(material.name, "m");
  EXPECT_EQ(material.physical->baseColor.value, vec3(0.2f, 0.3f, 0.4f));
  EXPECT_EQ(material.physical->specularWeight.value, 0.4f);
  EXPECT_EQ(material.physical->specularColor.value, vec3(0.5f, 1, 0.25f));
  EXPECT_FLOAT_EQ(material.physical->specularRoughness.value, 0.5f);
  EXPECT_EQ(material.physical->specularIor, 1.7f);
  EXPECT_EQ(test.ReadMaterial("Kd 1 1 1\n").physical->specularWeight.value, 0);
  EXPECT_EQ(test.ReadMaterial("Ks 1 1 1\nillum 1\n").physical->specularWeight.value, 0);
  EXPECT_EQ(test.ReadMaterial("Ks 1 1 1\nNi 1\n").physical->specularIor, 1.5f);
  EXPECT_EQ(test.ReadMaterial("Ke 5 6 7\n").physical->emission.value, vec3(5, 6, 7));
}

TEST(Mtl, MirrorsAndGlass) {
  ObjTestScene test;
  const Material mirror = test.ReadMaterial("Kd 0 0 0\nKs 0.9 0.8 0.7\nillum 3\n");
  EXPECT_EQ(mirror.physical->baseMetalness.value, 1);
  EXPECT_EQ(mirror.physical->specularRoughness.value, 0);
  EXPECT_NEAR(mirror.physical->baseColor.value.y, 0.8f, 1e-6f);
  const Material gloss = test.ReadMaterial("Kd 1 0 0\nKs 0.25 0.25 0.25\nillum 3\n");
  EXPECT_FLOAT_EQ(gloss.physical->specularIor, 3);  // ((3 − 1) / (3 + 1))² = 1/4

  for (const char* illum : {"4", "6", "7", "9"}) {
    const Material glass =
        test.ReadMaterial(std::string("d 0.25\nTf 1 0.5 0.5\nNi 1.3\nillum ") + illum + "\n");
    EXPECT_EQ(glass.physical->transmissionWeight.value, 0.75f);
    EXPECT_EQ(glass.physical->transmissionColor.value, vec3(1, 0.5f, 0.5f));
    EXPECT_EQ(glass.physical->specularIor, 1.3f);
    EXPECT_EQ(glass.opacity.value, 1);
    EXPECT_EQ(glass.alphaMode, AlphaMode::Opaque);
    EXPECT_TRUE(glass.Refractive());
  }
  const Material tinted = test.ReadMaterial("Tf 0.4 0.8 0.8\nillum 6\n");
  EXPECT_EQ(tinted.physical->transmissionWeight.value, 0.8f);
  EXPECT_EQ(tinted.physical->transmissionColor.value, vec3(0.5f, 1, 1));
}

TEST(Mtl, Opacity) {
  ObjTestScene test;
  Material material = test.ReadMaterial("d 0.25\n");
  EXPECT_EQ(material.opacity.value, 0.25f);
  EXPECT_EQ(material.alphaMode, AlphaMode::Blend);
  EXPECT_EQ(test.ReadMaterial("Tr 0.25\n").opacity.value, 0.75f);
  EXPECT_EQ(test.ReadMaterial("d 1\nTr 0\n").alphaMode, AlphaMode::Opaque);
  EXPECT_TRUE(test.warnings.empty());
  EXPECT_EQ(test.ReadMaterial("Tr 0\nd 0.5\n").opacity.value, 0.5f);
  ASSERT_EQ(test.warnings.size(), 1u);
  EXPECT_EQ(test.warnings[0],
            "a.mtl:1: 1 material with 'd' and 'Tr' that contradict each other: 'd' counts: 'm'");

  // By the map's luminance, or its alpha if it has one
  test.Paint("grey.png", vec3(0.5f)).Paint("hole.png", vec3(1), 0).Paint("veil.png", vec3(1), 0.5f);
  material = test.ReadMaterial("map_d grey.png\n");
  EXPECT_EQ(material.alphaMode, AlphaMode::Blend);
  EXPECT_EQ(material.opacity.channel, 1);
  material = test.ReadMaterial("map_d hole.png\n");
  EXPECT_EQ(material.alphaMode, AlphaMode::Mask);
  EXPECT_EQ(material.opacity.channel, 3);
  EXPECT_EQ(test.ReadMaterial("map_d veil.png\n").alphaMode, AlphaMode::Blend);
  EXPECT_EQ(test.ReadMaterial("map_d -imfchan r veil.png\n").opacity.channel, 0);
}

TEST(Mtl, PhysicalKeys) {
  ObjTestScene test;
  test.Paint("p.png", vec3(0.5f));
  const Material material = test.ReadMaterial(
      "Ks 0 0 0\nPr 0.4\nPm 0.6\nPs 0.1\nPc 0.5\nPcr 0.03\naniso 0.7\nanisor 0.25\nmap_Pm p.png\n"
      "map_Pc p.png\n");
  const scene::OpenPbr& pbr = *material.physical;
  EXPECT_EQ(pbr.specularWeight.value, 1);
  EXPECT_EQ(pbr.specularRoughness.value, 0.4f);
  EXPECT_EQ(pbr.baseMetalness.value, 0.6f);
  EXPECT_GE(pbr.baseMetalness.texture, 0);
  EXPECT_EQ(pbr.fuzzWeight.value, 0.1f);
  EXPECT_EQ(pbr.coatWeight.value, 0.5f);
  EXPECT_GE(pbr.coatWeight.texture, 0);
  EXPECT_EQ(pbr.coatRoughness.value, 0.03f);
  EXPECT_EQ(pbr.specularRoughnessAnisotropy.value, 0.7f);
  EXPECT_FLOAT_EQ(pbr.anisotropyRotation, 1.5707963f);
  ASSERT_EQ(test.contents.images.size(), 1u);
  EXPECT_FALSE(test.contents.images[0].srgb);
}

TEST(Mtl, MapsBecomeTextures) {
  ObjTestScene test;
  test.Paint("p.png", vec3(0.5f));
  Material material = test.ReadMaterial("Kd 0 0 0\nmap_Kd -s 2 4 -o 0.5 -clamp on p.png\n");
  EXPECT_EQ(material.physical->baseColor.value, vec3(1));
  ASSERT_EQ(test.contents.textures.size(), 1u);
  const scene::Texture& texture = test.contents.textures[0];
  EXPECT_EQ(texture.kind, scene::TextureKind::Image);
  EXPECT_EQ(texture.wrapV, scene::Wrap::Clamp);
  // uv (1, 1) shows the picture's (2.5, 4)
  const glm::dvec4 uv = texture.placement * glm::dvec4(2.5, 4, 0, 1);
  EXPECT_DOUBLE_EQ(uv.x, 1);
  EXPECT_DOUBLE_EQ(uv.y, 1);
  EXPECT_TRUE(test.contents.images.at(0).srgb);

  // Each file is read once for each use
  test.ReadMaterial("map_Kd p.png\nmap_Ke p.png\nmap_Pr P.PNG\nmap_Pm p.png\nnorm p.png\n");
  EXPECT_EQ(test.contents.images.size(), 2u);
  EXPECT_EQ(test.contents.textures.size(), 5u);

  // Where the picture is missing, black is not meant either
  material = test.ReadMaterial("Kd 0 0 0\nmap_Kd none.png\nmap_Ke none.png\n");
  EXPECT_GT(material.physical->baseColor.value.x, 0.5f);
  EXPECT_EQ(material.physical->emission.value, vec3(0));
  EXPECT_EQ(test.warnings,
            std::vector<std::string>{"a.mtl:3: the picture 'none.png' is not found in "
                                     "the scene's folder"});
}

TEST(Mtl, ExponentMapsBecomeRoughness) {
  ObjTestScene test;
  test.Paint("p.png", vec3(1));
  const Material material = test.ReadMaterial("Ks 1 1 1\nNs 30\nmap_Ns p.png\n");
  const scene::ScalarInput roughness = material.physical->specularRoughness;
  EXPECT_EQ(roughness.value, 1);
  ASSERT_EQ(roughness.texture, 0);
  const int image = test.contents.textures[0].image;
  EXPECT_EQ(test.contents.images.at(std::size_t(image)).bytes.at(0), 128);  // (2 / 32)^(1/4) = 1/2
}

TEST(Mtl, ReliefMaps) {
  ObjTestScene test;
  test.Paint("p.png", vec3(0.5f));
  const Material material = test.ReadMaterial("norm -bm 2 p.png\nbump -bm 0.5 p.png\n");
  EXPECT_GE(material.normalMap.texture, 0);
  EXPECT_EQ(material.normalMap.scale, 2);
  // The picture is half a metre long on the triangle
  EXPECT_FLOAT_EQ(material.bumpMap.scale, 0.5f * 0.5f * BumpHeight);
}

TEST(Mtl, DisplacementIsMeasuredLikeBumps) {
  ObjTestScene test;
  test.Paint("h.png", image::vec3(0.5f));
  const Material material = test.ReadMaterial("disp -bm 2 -imfchan b h.png\nbump -bm 2 h.png\n");
  EXPECT_EQ(test.warnings, std::vector<std::string>());
  EXPECT_GE(material.displacement.texture, 0);
  EXPECT_EQ(material.displacement.channel, 2);
  EXPECT_EQ(material.displacement.middle, 0);
  EXPECT_EQ(material.displacement.scale, material.bumpMap.scale);
}

}  // namespace
}  // namespace snell::io
