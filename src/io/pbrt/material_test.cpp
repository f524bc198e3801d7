// SPDX-License-Identifier: Apache-2.0
//
// Materials, textures and spectra.
#include <gtest/gtest.h>

#include <cmath>

#include "io/pbrt/spectra.h"
#include "io/pbrt/test_scene.h"

namespace snell::io {
namespace {

void ExpectNear(const scene::Spectrum& value, const scene::Spectrum& expected, float tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], tolerance);
}

class PbrtMaterials : public testing::Test {
 protected:
  // The material of a sphere after these statements.
  const scene::Material& Material(const std::string& text) {
    scene_ = file_.ReadWorld(text);
    EXPECT_EQ(file_.error, "");
    if (scene_.materials.empty()) scene_.materials.emplace_back().physical.emplace();
    return scene_.materials.front();
  }
  const scene::OpenPbr& Pbr(const std::string& text) { return *Material(text).physical; }

  PbrtTestScene file_;
  scene::Scene scene_;
};

TEST_F(PbrtMaterials, WithoutOneShapesAreGrey) {
  const scene::OpenPbr pbr = Pbr("");
  EXPECT_EQ(pbr.baseColor.value, scene::Spectrum(0.5f));
  EXPECT_EQ(pbr.specularWeight.value, 0);
  EXPECT_TRUE(file_.warnings.empty());
}

TEST_F(PbrtMaterials, DiffuseHasNoHighlight) {
  const scene::OpenPbr pbr = Pbr("Material \"diffuse\" \"rgb reflectance\" [ 0.1 0.2 0.3 ]");
  EXPECT_EQ(pbr.baseColor.value, scene::Spectrum(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(pbr.specularWeight.value, 0);
}

// pbrt's α is the root of the roughness, OpenPBR's α its square.
TEST_F(PbrtMaterials, RoughnessIsTurnedIntoOpenPbrs) {
  EXPECT_FLOAT_EQ(
      Pbr("Material \"coateddiffuse\" \"float roughness\" 0.0625").specularRoughness.value, 0.5f);
  EXPECT_FLOAT_EQ(Pbr("Material \"coateddiffuse\" \"float roughness\" 0.25 "
                      "\"bool remaproughness\" false")
                      .specularRoughness.value,
                  0.5f);
  EXPECT_EQ(Pbr("Material \"dielectric\"").specularRoughness.value, 0);
}

TEST_F(PbrtMaterials, UnevenRoughnessHasADirection) {
  const scene::OpenPbr pbr =
      Pbr("Material \"conductor\" \"float uroughness\" 0.1 \"float vroughness\" 0.4 "
          "\"bool remaproughness\" false");
  // OpenPBR's widths along and across
  const float a = pbr.specularRoughnessAnisotropy.value;
  const float along = pbr.specularRoughness.value * pbr.specularRoughness.value *
                      std::sqrt(2 / (1 + (1 - a) * (1 - a)));
  EXPECT_NEAR(along, 0.4f, 1e-5f);
  EXPECT_NEAR(along * (1 - a), 0.1f, 1e-5f);
  EXPECT_NEAR(pbr.anisotropyRotation, 1.5708f, 1e-4f);
}

TEST_F(PbrtMaterials, MetalsHaveTheColorsOfTheirIndices) {
  ExpectNear(Pbr("Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" "
                 "\"spectrum k\" \"metal-Au-k\"")
                 .baseColor.value,
             {1.0f, 0.78f, 0.34f}, 0.07f);
  ExpectNear(Pbr("Material \"conductor\" \"spectrum eta\" \"metal-Ag-eta\" "
                 "\"spectrum k\" \"metal-Ag-k\"")
                 .baseColor.value,
             {0.98f, 0.98f, 0.98f}, 0.02f);
  ExpectNear(Pbr("Material \"conductor\" \"spectrum eta\" \"metal-Al-eta\" "
                 "\"spectrum k\" \"metal-Al-k\"")
                 .baseColor.value,
             {0.91f, 0.92f, 0.92f}, 0.03f);
  ExpectNear(Pbr("Material \"conductor\"").baseColor.value, {0.95f, 0.64f, 0.54f}, 0.05f);
  EXPECT_EQ(scene_.materials[0].physical->baseMetalness.value, 1);
  // (n − 1)² + k² over (n + 1)² + k²
  ExpectNear(
      Pbr("Material \"conductor\" \"rgb eta\" [ 1 2 3 ] \"rgb k\" [ 1 0 0 ]").baseColor.value,
      {0.2f, 1.0f / 9, 0.25f}, 1e-5f);
  EXPECT_EQ(Pbr("Material \"conductor\" \"rgb reflectance\" [ 0.2 0.6 0.9 ]").baseColor.value,
            scene::Spectrum(0.2f, 0.6f, 0.9f));
}

TEST_F(PbrtMaterials, GlassHasItsIndex) {
  EXPECT_FLOAT_EQ(Pbr("Material \"dielectric\" \"float eta\" 1.33").specularIor, 1.33f);
  EXPECT_FLOAT_EQ(Pbr("Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"").specularIor,
                  1.5168f);
  EXPECT_EQ(Pbr("Material \"dielectric\"").transmissionWeight.value, 1);
  EXPECT_TRUE(Material("Material \"thindielectric\"").thin);
  EXPECT_FALSE(Material("Material \"dielectric\"").thin);
}

TEST_F(PbrtMaterials, CoatedMetalsHaveACoat) {
  const scene::OpenPbr pbr =
      Pbr("Material \"coatedconductor\" \"float interface.roughness\" 0.0625 "
          "\"float conductor.roughness\" 0.0081 \"float interface.eta\" 1.4");
  EXPECT_EQ(pbr.coatWeight.value, 1);
  EXPECT_FLOAT_EQ(pbr.coatRoughness.value, 0.5f);
  EXPECT_FLOAT_EQ(pbr.coatIor, 1.4f);
  EXPECT_FLOAT_EQ(pbr.specularRoughness.value, 0.3f);
  EXPECT_EQ(pbr.baseMetalness.value, 1);
  EXPECT_TRUE(file_.warnings.empty());
}

TEST_F(PbrtMaterials, DiffuseTransmissionKeepsBothParts) {
  const scene::OpenPbr pbr =
      Pbr("Material \"diffusetransmission\" \"rgb reflectance\" [ 0.2 0.2 0.2 ] "
          "\"rgb transmittance\" [ 0.6 0.6 0.6 ]");
  const float weight = pbr.diffuseTransmissionWeight.value;
  EXPECT_NEAR(pbr.baseColor.value.x * (1 - weight), 0.2f, 1e-5f);
  EXPECT_NEAR(pbr.diffuseTransmissionColor.value.x * weight, 0.6f, 1e-5f);
}

TEST_F(PbrtMaterials, MixesAreMeans) {
  const std::string two =
      "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"rgb reflectance\" [ 0 0 0 ]\n"
      "MakeNamedMaterial \"b\" \"string type\" \"diffuse\" \"rgb reflectance\" [ 1 1 1 ]\n"
      "Material \"mix\" \"string materials\" [ \"a\" \"b\" ] \"float amount\" ";
  EXPECT_FLOAT_EQ(Pbr(two + "0.25").baseColor.value.x, 0.25f);
  EXPECT_FLOAT_EQ(Pbr(two + "1").baseColor.value.x, 1);
}

TEST_F(PbrtMaterials, ApproximationsAreReported) {
  for (const char* type : {"subsurface", "hair", "measured", "matte", "anything"}) {
    Pbr("Material \"" + std::string(type) + "\"");
    EXPECT_TRUE(file_.Warned("approximated")) << type;
  }
}

TEST_F(PbrtMaterials, NamesThatAreNotKnownAreMistakes) {
  file_.ReadWorld("MakeNamedMaterial \"gold\" \"string type\" \"diffuse\" NamedMaterial \"glod\"");
  EXPECT_EQ(file_.error, "a.pbrt:2:50: there is no material 'glod'; did you mean 'gold'?");
}

TEST_F(PbrtMaterials, PicturesAreShown) {
  file_.Paint("a.png", {0.5f, 0.25f, 0.1f});
  const scene::OpenPbr pbr = Pbr(
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.png\" \"float uscale\" 4 "
      "\"float scale\" 0.5 \"string wrap\" \"clamp\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"t\"");
  ASSERT_GE(pbr.baseColor.texture, 0);
  const scene::Texture& texture = scene_.textures[std::size_t(pbr.baseColor.texture)];
  EXPECT_EQ(pbr.baseColor.value, scene::Spectrum(0.5f));
  EXPECT_EQ(texture.placement[0][0], 0.25);
  EXPECT_EQ(texture.wrapU, scene::Wrap::Clamp);
  EXPECT_TRUE(scene_.images[std::size_t(texture.image)].srgb);
}

TEST_F(PbrtMaterials, CheckerboardsAlternate) {
  const scene::OpenPbr pbr =
      Pbr("Texture \"t\" \"spectrum\" \"checkerboard\" \"float uscale\" 8 \"float vscale\" 4 "
          "\"rgb tex1\" [ 1 0 0 ] \"rgb tex2\" [ 0 1 0 ]\n"
          "Material \"diffuse\" \"texture reflectance\" \"t\"");
  const scene::Texture& texture = scene_.textures.at(std::size_t(pbr.baseColor.texture));
  EXPECT_EQ(texture.kind, scene::TextureKind::Checker);
  EXPECT_EQ(texture.colorA, scene::Spectrum(1, 0, 0));
  EXPECT_EQ(texture.placement[0][0], 0.125);
  EXPECT_EQ(texture.placement[1][1], 0.25);
}

TEST_F(PbrtMaterials, TexturesOfRoughnessAreTurnedIntoOpenPbrs) {
  const scene::OpenPbr pbr =
      Pbr("Texture \"t\" \"float\" \"checkerboard\" \"float tex1\" 0.0625 \"float tex2\" 1\n"
          "Material \"conductor\" \"texture roughness\" \"t\"");
  const scene::Texture& texture = scene_.textures.at(std::size_t(pbr.specularRoughness.texture));
  EXPECT_FLOAT_EQ(texture.colorA.x, 0.5f);
  EXPECT_FLOAT_EQ(texture.colorB.x, 1);
  file_.Paint("a.png", image::vec3(0.25f));
  const scene::OpenPbr picture =
      Pbr("Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"a.png\" \"string encoding\" "
          "\"linear\"\nMaterial \"conductor\" \"texture roughness\" \"t\" \"bool remaproughness\" "
          "false");
  const scene::Texture& made = scene_.textures.at(std::size_t(picture.specularRoughness.texture));
  EXPECT_NEAR(scene_.images[std::size_t(made.image)].bytes[0] / 255.0, std::sqrt(137 / 255.0),
              0.005);
}

TEST_F(PbrtMaterials, TexturesOfTexturesAreTheirMeans) {
  const std::string two =
      "Texture \"a\" \"spectrum\" \"constant\" \"rgb value\" [ 0.2 0.4 0.6 ]\n"
      "Texture \"c\" \"spectrum\" \"checkerboard\"\n";
  ExpectNear(
      Pbr(two + "Texture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"a\" \"float scale\" 0.5 "
                "Material \"diffuse\" \"texture reflectance\" \"t\"")
          .baseColor.value,
      {0.1f, 0.2f, 0.3f}, 1e-6f);
  EXPECT_TRUE(file_.warnings.empty());
  ExpectNear(
      Pbr(two + "Texture \"t\" \"spectrum\" \"mix\" \"texture tex1\" \"a\" \"texture tex2\" \"c\" "
                "Material \"diffuse\" \"texture reflectance\" \"t\"")
          .baseColor.value,
      {0.35f, 0.45f, 0.55f}, 1e-6f);
  EXPECT_TRUE(file_.Warned("approximated by its mean"));
  Pbr("Texture \"t\" \"float\" \"fbm\" Material \"conductor\" \"texture roughness\" \"t\"");
  EXPECT_TRUE(file_.Warned("'fbm' texture approximated by a constant"));
}

TEST(PbrtSpectra, WhiteStaysWhite) {
  ExpectNear(ReflectanceColor([](double) { return 0.5; }), scene::Spectrum(0.5f), 1e-6f);
  ExpectNear(*NamedLight("stdillum-D65"), scene::Spectrum(1), 2e-3f);
}

TEST(PbrtSpectra, BlackBodiesHaveTheirColors) {
  // Illuminant A is the black body of 2856 K
  const scene::Spectrum a = LightColor([](double nm) { return BlackbodyRadiance(nm, 2856); });
  ExpectNear(a, *NamedLight("stdillum-A"), 0.02f);
  EXPECT_GT(a.x, a.y);
  EXPECT_GT(a.y, a.z);
  EXPECT_EQ(LightColor([](double nm) { return BlackbodyRadiance(nm, 0); }), scene::Spectrum(0.0f));
}

TEST(PbrtSpectra, TablesAreInterpolated) {
  const PbrtTable table = ParseTable("# a comment\n400 1\n500 3 # more\n", "a.spd");
  EXPECT_EQ(table.At(300), 1);
  EXPECT_EQ(table.At(450), 2);
  EXPECT_EQ(table.At(600), 3);
  EXPECT_THROW(ParseTable("400 1 500", "a.spd"), Error);
  EXPECT_THROW(ParseTable("400 1 400 2", "a.spd"), Error);
  EXPECT_THROW(ParseTable("x", "a.spd"), Error);
}

TEST_F(PbrtMaterials, SpectraComeFromTheTextOrFiles) {
  EXPECT_NEAR(
      Pbr("Material \"diffuse\" \"spectrum reflectance\" [ 300 0.5 800 0.5 ]").baseColor.value.y,
      0.5f, 1e-5f);
  file_.Write("red.spd", "600 0\n610 1\n");
  const scene::Spectrum red =
      Pbr("Material \"diffuse\" \"spectrum reflectance\" \"red.spd\"").baseColor.value;
  EXPECT_GT(red.x, 5 * red.y);
  Pbr("Material \"diffuse\" \"spectrum reflectance\" \"none.spd\"");
  EXPECT_TRUE(file_.Warned("neither known by name nor found as a file"));
}

TEST_F(PbrtMaterials, ColorSpacesBecomeRec709) {
  ExpectNear(Pbr("ColorSpace \"rec2020\" Material \"diffuse\" \"rgb reflectance\" [ 0.5 0.5 0.5 ]")
                 .baseColor.value,
             scene::Spectrum(0.5f), 1e-4f);
  const scene::Spectrum green =
      Pbr("ColorSpace \"dci-p3\" Material \"diffuse\" \"rgb reflectance\" [ 0.2 0.5 0.2 ]")
          .baseColor.value;
  EXPECT_LT(green.x, 0.2f);
  EXPECT_GT(green.y, 0.5f);
}

}  // namespace
}  // namespace snell::io
