// SPDX-License-Identifier: Apache-2.0
//
// Physical materials in native scenes: OpenPBR's names, real metals and glasses, numbers as textures, and what does not
// go together.
#include <gtest/gtest.h>

#include "io/toml/test_scene.h"
#include "scene/measured.h"

namespace snell::io {
namespace {

using scene::OpenPbr;

scene::Material MaterialOf(const std::string& keys) {
  const scene::Scene scene = TestScene("[texture.t]\ntype = \"checker\"\n[material.m]\n" + keys +
                                       "\n[[object]]\nshape = \"sphere\"\nmaterial = \"m\"\n")
                                 .Read();
  return scene.materials.at(std::size_t(scene.objects.at(0).material));
}

TEST(TomlPhysical, HasAllNamesOfOpenPbr) {
  const scene::Material material = MaterialOf(R"(type = "openpbr"
base_weight = 0.9
base_diffuse_roughness = 0.3
specular_weight = 1.5
specular_roughness_anisotropy = 0.4
specular_ior = 1.7
transmission_weight = 0.5
transmission_color = [0.1, 0.2, 0.3]
transmission_depth = 2
transmission_dispersion_scale = 0.5
transmission_dispersion_abbe_number = 30
coat_weight = 0.6
coat_color = [0.9, 0.8, 0.7]
coat_roughness_anisotropy = 0.2
coat_ior = 1.4
coat_darkening = 0.5
coat_normal_map = "t"
coat_normal_scale = 0.7
thin_film_weight = 0.8
thin_film_thickness = 0.35
thin_film_ior = 1.8
emission_luminance = 1366
emission_color = [1, 0.5, 0]
geometry_opacity = 0.9
geometry_thin_walled = true
geometry_tangent_rotation = 90)");
  const OpenPbr& m = *material.physical;
  EXPECT_EQ(m.baseWeight, 0.9f);
  EXPECT_EQ(m.baseDiffuseRoughness, 0.3f);
  EXPECT_EQ(m.specularWeight.value, 1.5f);
  EXPECT_EQ(m.specularRoughnessAnisotropy.value, 0.4f);
  EXPECT_EQ(m.specularIor, 1.7f);
  EXPECT_EQ(m.transmissionColor.value, scene::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(m.transmissionDepth, 2);
  EXPECT_EQ(m.transmissionDispersionScale, 0.5f);
  EXPECT_EQ(m.transmissionDispersionAbbeNumber, 30);
  EXPECT_EQ(m.coatColor.value, scene::vec3(0.9f, 0.8f, 0.7f));
  EXPECT_EQ(m.coatRoughnessAnisotropy, 0.2f);
  EXPECT_EQ(m.coatIor, 1.4f);
  EXPECT_EQ(m.coatDarkening, 0.5f);
  EXPECT_GE(m.coatNormal.texture, 0);
  EXPECT_EQ(m.coatNormal.scale, 0.7f);
  EXPECT_EQ(m.thinFilmWeight.value, 0.8f);
  EXPECT_EQ(m.thinFilmThickness.value, 0.35f);
  EXPECT_EQ(m.thinFilmIor, 1.8f);
  EXPECT_EQ(m.emission.value, scene::vec3(2, 1, 0));  // 683 lm/W
  EXPECT_NEAR(m.anisotropyRotation, 1.5707963f, 1e-6f);
  EXPECT_EQ(material.opacity.value, 0.9f);
  EXPECT_EQ(material.alphaMode, scene::AlphaMode::Blend);
  EXPECT_TRUE(material.thin);
}

TEST(TomlPhysical, NumbersMayBeTextures) {
  const OpenPbr m = *MaterialOf(
                         "type = \"openpbr\"\nspecular_roughness = \"t\"\nthin_film_thickness = "
                         "{ texture = \"t\", channel = \"blue\", factor = 0.6 }")
                         .physical;
  EXPECT_GE(m.specularRoughness.texture, 0);
  EXPECT_EQ(m.specularRoughness.value, 1);
  EXPECT_EQ(m.thinFilmThickness.channel, 2);
  EXPECT_EQ(m.thinFilmThickness.value, 0.6f);
}

TEST(TomlPhysical, MetalsAndGlassesByName) {
  OpenPbr gold;
  SetMetal(*scene::FindMetal("gold"), gold);
  const OpenPbr m = *MaterialOf("metal = \"gold\"\nspecular_roughness = 0.2").physical;
  EXPECT_EQ(m.baseColor.value, gold.baseColor.value);
  EXPECT_EQ(m.specularColor.value, gold.specularColor.value);
  EXPECT_EQ(m.baseMetalness.value, 1);
  EXPECT_EQ(m.specularRoughness.value, 0.2f);

  const OpenPbr glass = *MaterialOf("glass = \"SF11\"\ntransmission_weight = 0.9").physical;
  EXPECT_NEAR(glass.specularIor, 1.78472f, 1e-4f);
  EXPECT_NEAR(glass.transmissionDispersionAbbeNumber, 25.76f, 0.05f);
  EXPECT_EQ(glass.transmissionDispersionScale, 1);
  EXPECT_EQ(glass.transmissionWeight.value, 0.9f);
  EXPECT_EQ(glass.specularRoughness.value, 0);
}

TEST(TomlPhysical, SaysWhatDoesNotGoTogether) {
  const auto wrong = [](const std::string& keys) {
    const std::vector<std::string> errors = TestScene("[material.m]\n" + keys).Errors();
    return errors.size() == 1 ? errors[0] : std::string();
  };
  EXPECT_NE(wrong("metal = \"gold\"\nbase_color = 0.5").find("'metal' and 'base_color' exclude"),
            std::string::npos);
  EXPECT_NE(wrong("glass = \"BK7\"\nior = 1.4").find("'glass' and 'ior' exclude"),
            std::string::npos);
  EXPECT_NE(wrong("metal = \"unobtainium\"").find("unobtainium"), std::string::npos);
  EXPECT_NE(wrong("type = \"openpbr\"\ncoat_darkening = 2").find("from 0 to 1"), std::string::npos);
}

}  // namespace
}  // namespace snell::io
