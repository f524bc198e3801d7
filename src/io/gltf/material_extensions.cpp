// SPDX-License-Identifier: Apache-2.0
//
// The material extensions of glTF in terms of OpenPBR.
#include <algorithm>
#include <cmath>
#include <limits>

#include "io/gltf/materials.h"

namespace snell::io {

using scene::Spectrum;

// The index of refraction of a surface that reflects this much of light from straight above.
static float IorOf(float reflectance) {
  const float root = std::sqrt(std::min(reflectance, 0.98f));
  return (1 + root) / (1 - root);
}

static float Largest(Spectrum s) { return std::max({s.x, s.y, s.z}); }

// Diffuse and specular colours of their own: a dielectric that reflects as much as the specular colour says.
void GltfMaterialReader::ReadGlossiness(const GltfValue& extension) {
  const std::vector<double> diffuse = extension.Numbers("diffuseFactor", {1, 1, 1, 1});
  pbr_.baseColor = {Color({float(diffuse[0]), float(diffuse[1]), float(diffuse[2])}),
                    textures_.Get({extension, "diffuseTexture"}, GltfPictureUse::Color, part_)};
  if (to_.alphaMode != scene::AlphaMode::Opaque)
    to_.opacity = {Within(diffuse[3]), pbr_.baseColor.texture, 3};
  pbr_.baseMetalness = {0};

  const GltfTextureInfo both(extension, "specularGlossinessTexture");
  const Spectrum specular = Color(extension.Vector("specularFactor", glm::vec3(1.0f)));
  const float most = Largest(specular);
  pbr_.specularIor = IorOf(most);
  pbr_.specularWeight = {most > 0 ? 1.0f : 0.0f};
  pbr_.specularColor = {most > 0 ? specular / most : Spectrum(1.0f),
                        textures_.Get(both, GltfPictureUse::Color, part_)};
  const float gloss = Number(extension, "glossinessFactor", 1);
  const scene::TextureIndex roughness =
      textures_.Get(both, GltfPictureUse::Gloss, part_, double(gloss));
  pbr_.specularRoughness = {roughness >= 0 ? 1.0f : 1 - gloss, roughness, 3};
}

void GltfMaterialReader::ReadSpecular() {
  const double ior = Extension("KHR_materials_ior").Number("ior", 1.5);
  pbr_.specularIor = ior == 0 ? IorOf(1) : Within(ior, 1, 100);

  const GltfValue extension = Extension("KHR_materials_specular");
  pbr_.specularWeight = Scalar(extension, "specularFactor", 1, "specularTexture", 3);
  Spectrum color = extension.Vector("specularColorFactor", glm::vec3(1.0f));
  for (int i = 0; i < 3; ++i) color[i] = Within(double(color[i]), 0, 1e6);

  // Colours above 1 reflect more than the index of refraction says: raise that instead
  if (const float most = Largest(color); most > 1) {
    const float root = (pbr_.specularIor - 1) / (pbr_.specularIor + 1);
    if (!Extension("KHR_materials_transmission")) pbr_.specularIor = IorOf(root * root * most);
    color /= most;
  }
  pbr_.specularColor = {
      color, textures_.Get({extension, "specularColorTexture"}, GltfPictureUse::Color, part_)};
  // Where all is metal, glTF's two say nothing
  if (pbr_.baseMetalness.value == 1 && pbr_.baseMetalness.texture < 0) {
    pbr_.specularWeight = {1};
    pbr_.specularColor = {Spectrum(1.0f)};
  }
}

void GltfMaterialReader::ReadTransmission() {
  const GltfValue extension = Extension("KHR_materials_transmission");
  const GltfValue volume = Extension("KHR_materials_volume");
  const bool isSolid = volume.Number("thicknessFactor", 0) > 0;
  pbr_.transmissionWeight = Scalar(extension, "transmissionFactor", 0, "transmissionTexture", 0);
  const bool transmits =
      pbr_.transmissionWeight.value > 0 ||
      Extension("KHR_materials_diffuse_transmission").Number("diffuseTransmissionFactor", 0) > 0;
  if (!transmits) return;

  // A body has two sides, whatever the file says; a sheet has no inside
  to_.thin = !isSolid;
  if (isSolid) to_.doubleSided = true;
  const double distance =
      volume.Number("attenuationDistance", std::numeric_limits<double>::infinity());
  const bool absorbs = isSolid && std::isfinite(distance) && distance > 0;
  if (absorbs) {
    pbr_.transmissionColor.value = Color(volume.Vector("attenuationColor", glm::vec3(1.0f)));
    pbr_.transmissionDepth = float(distance);
  }
  pbr_.transmissionTintedByBase = true;
  if (const float dispersion =
          Number(Extension("KHR_materials_dispersion"), "dispersion", 0, 0, 1e6);
      dispersion > 0) {
    pbr_.transmissionDispersionScale = 1;
    pbr_.transmissionDispersionAbbeNumber = 20 / dispersion;
  }
}

void GltfMaterialReader::ReadDiffuseTransmission() {
  const GltfValue extension = Extension("KHR_materials_diffuse_transmission");
  pbr_.diffuseTransmissionWeight =
      Scalar(extension, "diffuseTransmissionFactor", 0, "diffuseTransmissionTexture", 3);
  pbr_.diffuseTransmissionColor = Colored(extension, "diffuseTransmissionColorFactor",
                                          glm::vec3(1.0f), "diffuseTransmissionColorTexture");
}

// glTF's coat has the index 1.5, and what lies below is no darker for it.
void GltfMaterialReader::ReadCoat() {
  const GltfValue extension = Extension("KHR_materials_clearcoat");
  if (!extension) return;
  pbr_.coatWeight = Scalar(extension, "clearcoatFactor", 0, "clearcoatTexture", 0);
  pbr_.coatRoughness =
      Scalar(extension, "clearcoatRoughnessFactor", 0, "clearcoatRoughnessTexture", 1);
  pbr_.coatIor = 1.5f;
  pbr_.coatDarkening = 0;
  pbr_.coatNormal.texture =
      textures_.Get({extension, "clearcoatNormalTexture"}, GltfPictureUse::Numbers, part_);
  pbr_.coatNormal.scale = float(extension.Object("clearcoatNormalTexture").Number("scale", 1));
}

// The largest channel of glTF's colour is the weight, so that a black sheen is none.
void GltfMaterialReader::ReadSheen() {
  const GltfValue extension = Extension("KHR_materials_sheen");
  pbr_.fuzzColor = Colored(extension, "sheenColorFactor", glm::vec3(0.0f), "sheenColorTexture");
  pbr_.fuzzRoughness = Scalar(extension, "sheenRoughnessFactor", 0, "sheenRoughnessTexture", 3);
  pbr_.fuzzWeight = {Largest(pbr_.fuzzColor.value)};
  if (pbr_.fuzzWeight.value > 0) {
    pbr_.fuzzColor.value /= pbr_.fuzzWeight.value;
  } else {
    pbr_.fuzzColor = {Spectrum(1.0f)};
  }
}

// Nanometres become micrometres.
void GltfMaterialReader::ReadIridescence() {
  const GltfValue extension = Extension("KHR_materials_iridescence");
  if (!extension) return;
  pbr_.thinFilmWeight = Scalar(extension, "iridescenceFactor", 0, "iridescenceTexture", 0);
  pbr_.thinFilmIor = Number(extension, "iridescenceIor", 1.3, 1, 100);
  pbr_.thinFilmThickness = {
      Number(extension, "iridescenceThicknessMaximum", 400, 0, 1e6) / 1000,
      textures_.Get({extension, "iridescenceThicknessTexture"}, GltfPictureUse::Numbers, part_), 1};
  pbr_.thinFilmThicknessLeast =
      Number(extension, "iridescenceThicknessMinimum", 100, 0, 1e6) / 1000;
}

void GltfMaterialReader::ReadAnisotropy() {
  const GltfValue extension = Extension("KHR_materials_anisotropy");
  if (!extension) return;
  pbr_.specularRoughnessAnisotropy =
      Scalar(extension, "anisotropyStrength", 0, "anisotropyTexture", 2);
  pbr_.anisotropyOfGltf = true;
  pbr_.anisotropyMapped = pbr_.specularRoughnessAnisotropy.texture >= 0;
  pbr_.anisotropyRotation = float(extension.Number("anisotropyRotation", 0));
}

}  // namespace snell::io
