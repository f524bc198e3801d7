// SPDX-License-Identifier: Apache-2.0
//
// glTF's materials and textures as OpenPBR surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/matrix.hpp>

#include "image/color.h"
#include "image/write.h"
#include "io/gltf/test_files.h"

namespace snell::io {
namespace {

using scene::Spectrum;
using scene::vec3;

// A triangle of this material, and a picture of one pixel with the codes 255 0 51, beside it.
GltfResult ReadMaterial(const std::string& material, const std::string& members = "") {
  GltfBuilder builder;
  builder.AddTriangle();
  const TemporaryFile file(
      "a.gltf", builder.Mesh(R"({"attributes": {"POSITION": 0}, "material": 0})",
                             fmt::format(R"(, "materials": [{{{}}}]{})", material, members)));
  image::Image picture(1, 1);
  picture.pixels[0] = vec3(1, 0, 0.0331047f);
  image::WriteImage(file.path().parent_path() / "one.png", picture);
  return ReadGltfFile(file.path());
}

const std::string OneTexture =
    R"(, "textures": [{"source": 0, "sampler": 0}], "images": [{"uri": "one.png"}],
"samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9729, "minFilter": 9729}])";

// Pictures of 16 bits keep them: encoded colours are decoded, numbers stay.
TEST(GltfMaterial, PicturesOf16Bits) {
  GltfBuilder builder;
  builder.AddTriangle();
  const TemporaryFile file(
      "a.gltf",
      builder.Mesh(
          R"({"attributes": {"POSITION": 0}, "material": 0})",
          fmt::format(
              R"(, "materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0}},
"metallicRoughnessTexture": {{"index": 0}}}}}}]{})",
              OneTexture)));
  image::Image picture(1, 1);
  const vec3 color(0.3f, 0.0301f, 0.7001f);
  picture.pixels[0] = color;
  image::WriteOptions options;
  options.bits = 16;
  image::WriteImage(file.path().parent_path() / "one.png", picture, options);
  const GltfResult result = ReadGltfFile(file.path());
  ASSERT_EQ(result.error, "");
  ASSERT_EQ(result.scene.images.size(), 2u);
  for (const scene::Image& image : result.scene.images) {
    ASSERT_EQ(image.floats.size(), 4u);
    EXPECT_TRUE(image.bytes.empty());
    EXPECT_FALSE(image.srgb);
    EXPECT_EQ(image.floats[3], 1.0f);
  }
  for (int c = 0; c < 3; ++c) {
    const std::size_t at = std::size_t(c);
    EXPECT_NEAR(result.scene.images[0].floats[at], color[c], 2e-5f);
    EXPECT_NEAR(result.scene.images[1].floats[at], image::EncodeSrgb(color[c]), 1e-5f);
  }
}

TEST(GltfMaterial, MetalAndRoughness) {
  const GltfResult result = ReadMaterial(
      R"("name": "m", "doubleSided": true, "alphaMode": "MASK", "alphaCutoff": 0.25,
"emissiveFactor": [0.5, 0, 0], "normalTexture": {"index": 0, "scale": 0.5},
"extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}},
"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.6,
"roughnessFactor": 0.7, "baseColorTexture": {"index": 0},
"metallicRoughnessTexture": {"index": 0, "texCoord": 1}})",
      OneTexture);
  ASSERT_EQ(result.error, "");
  EXPECT_EQ(result.warnings, "");
  const scene::Material& material = result.scene.materials.at(0);
  const scene::OpenPbr& pbr = result.material();
  EXPECT_EQ(material.name, "m");
  EXPECT_TRUE(material.doubleSided);
  EXPECT_EQ(material.alphaMode, scene::AlphaMode::Mask);
  EXPECT_FLOAT_EQ(material.alphaCutoff, 0.25f);
  EXPECT_FLOAT_EQ(material.opacity.value, 0.4f);
  EXPECT_EQ(material.opacity.channel, 3);
  EXPECT_EQ(material.opacity.texture, pbr.baseColor.texture);
  EXPECT_FLOAT_EQ(material.normalMap.scale, 0.5f);
  EXPECT_EQ(pbr.baseColor.value, Spectrum(0.1f, 0.2f, 0.3f));
  EXPECT_FLOAT_EQ(pbr.baseMetalness.value, 0.6f);
  EXPECT_EQ(pbr.baseMetalness.channel, 2);
  EXPECT_FLOAT_EQ(pbr.specularRoughness.value, 0.7f);
  EXPECT_EQ(pbr.specularRoughness.channel, 1);
  EXPECT_EQ(pbr.emission.value, Spectrum(2, 0, 0));
  EXPECT_EQ(pbr.specularIor, 1.5f);

  // One picture as colour and as numbers; textures differ in coordinates too
  ASSERT_EQ(result.scene.images.size(), 2u);
  EXPECT_EQ(result.scene.images[0].bytes, (std::vector<std::uint8_t>{255, 0, 51, 255}));
  EXPECT_EQ(result.scene.images[0].bytes, result.scene.images[1].bytes);
  EXPECT_TRUE(result.scene.images[0].srgb);
  EXPECT_FALSE(result.scene.images[1].srgb);
  EXPECT_EQ(result.scene.images[0].name, "one.png");
  ASSERT_EQ(result.scene.textures.size(), 3u);
  const scene::Texture& roughness =
      result.scene.textures[std::size_t(pbr.specularRoughness.texture)];
  EXPECT_EQ(roughness.uvSet, 1);
  EXPECT_EQ(roughness.image, 1);
  EXPECT_EQ(roughness.wrapU, scene::Wrap::Clamp);
  EXPECT_EQ(roughness.wrapV, scene::Wrap::Mirror);
  EXPECT_EQ(roughness.filter, scene::TextureFilter::Linear);
}

TEST(GltfMaterial, WithoutAMaterialTheDefaultOfTheFormat) {
  GltfBuilder builder;
  builder.AddTriangle();
  const GltfResult result = ReadGltfText(builder.Mesh(R"({"attributes": {"POSITION": 0}})"));
  EXPECT_EQ(result.material().baseColor.value, Spectrum(1.0f));
  EXPECT_EQ(result.material().baseMetalness.value, 1);
  EXPECT_EQ(result.material().specularRoughness.value, 1);
}

TEST(GltfMaterial, PicturesThatCannotBeReadLeaveTheFactor) {
  const std::string material =
      R"("pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1], "baseColorTexture": {"index": 0}})";
  for (const auto& [textures, warning] :
       {std::pair(R"(, "textures": [{"source": 0}], "images": [{"uri": "none.png"}])",
                  "the picture none.png is left out: cannot read the file: No such file or "
                  "directory (material 0)\n"),
        {R"(, "textures": [{"source": 0}], "images": [{"uri": "../x.png"}])",
         "the picture ../x.png is left out: '../x.png' lies outside the scene's folder; files are "
         "read only from the scene's own folder and the folders in it; --allow FOLDER adds others "
         "(material 0)\n"},
        {R"(, "textures": [{"source": 0}], "images": [{"uri": "data:;base64,AAAA"}])",
         "the picture data URI is left out: not a known picture format (material 0)\n"},
        {R"(, "textures": [{"source": 0}], "images": [{"bufferView": 5}])",
         "the picture in buffer view 5 is left out: there is no buffer view 5 (material 0)\n"},
        {R"(, "textures": [{"source": 3}])",
         "textures without a picture are left out (material 0)\n"},
        {R"(, "textures": [{"extensions": {"KHR_texture_basisu": {"source": 0}}}])",
         "textures with KTX2 pictures only (KHR_texture_basisu) are left out (material 0)\n"},
        {"", "a texture does not exist (material 0)\n"}}) {
    const GltfResult result = ReadMaterial(material, textures);
    ASSERT_EQ(result.error, "");
    EXPECT_EQ(result.warnings, warning);
    EXPECT_EQ(result.material().baseColor.texture, -1);
    EXPECT_EQ(result.material().baseColor.value, Spectrum(0.1f, 0.2f, 0.3f));
  }
}

// Where a point of glTF's texture coordinates is in the picture, both with v down.
glm::dvec2 InPicture(const std::string& transform, double u, double v) {
  const GltfResult result = ReadMaterial(
      fmt::format(R"("pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0, "extensions":
{{"KHR_texture_transform": {{{}}}}}}}}})",
                  transform),
      OneTexture);
  EXPECT_EQ(result.error, "");
  const glm::dvec4 p =
      glm::inverse(result.scene.textures.at(0).placement) * glm::dvec4(u, 1 - v, 0, 1);
  return {p.x, 1 - p.y};
}

TEST(GltfMaterial, TextureTransforms) {
  const auto expect = [](glm::dvec2 p, double u, double v) {
    EXPECT_NEAR(p.x, u, 1e-6);
    EXPECT_NEAR(p.y, v, 1e-6);
  };
  expect(InPicture("", 0.3, 0.4), 0.3, 0.4);
  expect(InPicture(R"("offset": [0.5, 0.25])", 0.1, 0.2), 0.6, 0.45);
  expect(InPicture(R"("scale": [2, 3])", 0.1, 0.2), 0.2, 0.6);
  // Khronos' TextureTransformTest: the point at 67.5° shows what is at 45°
  const double angle = 0.39269908169872414 * 3;
  expect(InPicture(R"("rotation": 0.39269908169872414)", std::cos(angle), std::sin(angle)),
         std::sqrt(0.5), std::sqrt(0.5));
  expect(InPicture(R"("offset": [-0.2, -0.1], "rotation": 0.3, "scale": [1.5, 1.5])", 0.43, 0.75),
         -0.2 + std::cos(0.3) * 0.645 + std::sin(0.3) * 1.125,
         -0.1 - std::sin(0.3) * 0.645 + std::cos(0.3) * 1.125);
  // What cannot be undone is ignored
  expect(InPicture(R"("scale": [0, 1])", 0.3, 0.4), 0.3, 0.4);
}

TEST(GltfMaterial, GlassAsSheetAndBody) {
  const GltfResult sheet = ReadMaterial(
      R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 1]},
"extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.9}})");
  EXPECT_TRUE(sheet.scene.materials.at(0).thin);
  EXPECT_FLOAT_EQ(sheet.material().transmissionWeight.value, 0.9f);
  EXPECT_EQ(sheet.material().transmissionColor.value, Spectrum(1.0f));
  EXPECT_TRUE(sheet.material().transmissionTintedByBase);
  EXPECT_EQ(sheet.material().transmissionDepth, 0);

  const GltfResult body = ReadMaterial(
      R"("extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
"KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 0.2,
"attenuationColor": [0.1, 0.2, 0.3]}, "KHR_materials_ior": {"ior": 1.7},
"KHR_materials_dispersion": {"dispersion": 0.5}})");
  EXPECT_FALSE(body.scene.materials.at(0).thin);
  EXPECT_TRUE(body.scene.materials.at(0).doubleSided);
  EXPECT_EQ(body.material().transmissionColor.value, Spectrum(0.1f, 0.2f, 0.3f));
  EXPECT_FLOAT_EQ(body.material().transmissionDepth, 0.2f);
  EXPECT_FLOAT_EQ(body.material().specularIor, 1.7f);
  EXPECT_FLOAT_EQ(body.material().transmissionDispersionAbbeNumber /
                      body.material().transmissionDispersionScale,
                  40);
}

TEST(GltfMaterial, Layers) {
  const GltfResult result = ReadMaterial(
      R"("pbrMetallicRoughness": {"metallicFactor": 0}, "extensions": {
"KHR_materials_clearcoat": {"clearcoatFactor": 0.8, "clearcoatRoughnessFactor": 0.1},
"KHR_materials_sheen": {"sheenColorFactor": [0.5, 0.25, 0], "sheenRoughnessFactor": 0.4},
"KHR_materials_iridescence": {"iridescenceFactor": 1, "iridescenceThicknessMaximum": 550},
"KHR_materials_anisotropy": {"anisotropyStrength": 0.6, "anisotropyRotation": 1.5},
"KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": 0.3,
"diffuseTransmissionColorFactor": [1, 0, 0]},
"KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [2, 1, 1]}})");
  ASSERT_EQ(result.error, "");
  const scene::OpenPbr& pbr = result.material();
  EXPECT_FLOAT_EQ(pbr.coatWeight.value, 0.8f);
  EXPECT_FLOAT_EQ(pbr.coatRoughness.value, 0.1f);
  EXPECT_FLOAT_EQ(pbr.fuzzWeight.value, 0.5f);
  EXPECT_EQ(pbr.fuzzColor.value, Spectrum(1, 0.5f, 0));
  EXPECT_FLOAT_EQ(pbr.thinFilmThickness.value, 0.55f);
  EXPECT_FLOAT_EQ(pbr.thinFilmThicknessLeast, 0.1f);
  EXPECT_FLOAT_EQ(pbr.thinFilmIor, 1.3f);
  EXPECT_FLOAT_EQ(pbr.specularRoughnessAnisotropy.value, 0.6f);
  EXPECT_TRUE(pbr.anisotropyOfGltf);
  EXPECT_FLOAT_EQ(pbr.anisotropyRotation, 1.5f);
  EXPECT_FLOAT_EQ(pbr.diffuseTransmissionWeight.value, 0.3f);
  EXPECT_TRUE(result.scene.materials.at(0).thin);
  // Twice the reflectance of 1.5, which is 0.04
  EXPECT_FLOAT_EQ(pbr.specularWeight.value, 0.5f);
  EXPECT_EQ(pbr.specularColor.value, Spectrum(1, 0.5f, 0.5f));
  EXPECT_NEAR(std::pow((pbr.specularIor - 1) / (pbr.specularIor + 1), 2), 0.08, 1e-6);
}

TEST(GltfMaterial, Unlit) {
  const GltfResult result = ReadMaterial(
      R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.6, 0.7, 1]},
"extensions": {"KHR_materials_unlit": {}})");
  EXPECT_EQ(result.material().emission.value, Spectrum(0.5f, 0.6f, 0.7f));
  EXPECT_EQ(result.material().baseWeight, 0);
  EXPECT_EQ(result.material().specularWeight.value, 0);
}

TEST(GltfMaterial, SpecularAndGlossiness) {
  const GltfResult result = ReadMaterial(
      R"("extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.1, 0.2, 0.3, 1],
"specularFactor": [0.04, 0.02, 0], "glossinessFactor": 0.5,
"specularGlossinessTexture": {"index": 0}}})",
      OneTexture);
  ASSERT_EQ(result.error, "");
  const scene::OpenPbr& pbr = result.material();
  EXPECT_EQ(pbr.baseColor.value, Spectrum(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(pbr.baseMetalness.value, 0);
  EXPECT_NEAR(pbr.specularIor, 1.5f, 1e-5f);
  EXPECT_EQ(pbr.specularColor.value, Spectrum(1, 0.5f, 0));
  EXPECT_EQ(pbr.specularRoughness.value, 1);
  EXPECT_EQ(pbr.specularRoughness.channel, 3);
  const scene::Texture& roughness =
      result.scene.textures.at(std::size_t(pbr.specularRoughness.texture));
  // Half of full gloss leaves half of the roughness: 255 · (1 − 0.5)
  EXPECT_EQ(result.scene.images.at(std::size_t(roughness.image)).bytes.at(3), 128);
}

TEST(GltfMaterial, NumbersOutOfRangeAreCut) {
  const GltfResult result =
      ReadMaterial(R"("pbrMetallicRoughness": {"metallicFactor": 7, "roughnessFactor": -1})");
  EXPECT_EQ(result.material().baseMetalness.value, 1);
  EXPECT_EQ(result.material().specularRoughness.value, 0);
  EXPECT_EQ(result.warnings,
            "numbers of materials that are out of range are cut (2 times, first in material 0)\n");
}

}  // namespace
}  // namespace snell::io
