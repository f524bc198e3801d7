// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/materials.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace snell::io {

using scene::Spectrum;

GltfMaterials::GltfMaterials(GltfData& data, scene::Scene& scene)
    : document_(data.document()), scene_(scene), textures_(data, scene) {
  known_.assign(document_.model.materials.size(), -1);
}

scene::MaterialIndex GltfMaterials::Get(int material) {
  const bool exists = material >= 0 && std::size_t(material) < known_.size();
  if (material >= 0 && !exists)
    document_.findings.Note("a material does not exist",
                            GltfPart("material", std::size_t(material)));
  scene::MaterialIndex& known = exists ? known_[std::size_t(material)] : default_;
  if (known >= 0) return known;
  static const tinygltf::Material Default;
  const tinygltf::Material& from =
      exists ? document_.model.materials[std::size_t(material)] : Default;
  const std::string part = exists ? GltfPart("material", std::size_t(material), from.name) : "";
  scene::Material made = GltfMaterialReader(from, textures_, document_.findings, part).Read();
  made.name = exists ? (from.name.empty() ? part : from.name) : "default";
  known = scene::MaterialIndex(scene_.materials.size());
  scene_.materials.push_back(std::move(made));
  return known;
}

float GltfMaterialReader::Within(double number, double least, double most) {
  if (number >= least && number <= most) return float(number);
  findings_.Note("numbers of materials that are out of range are cut", part_);
  return float(std::isnan(number) ? least : std::clamp(number, least, most));
}

float GltfMaterialReader::Number(const GltfValue& object, const char* key, double fallback,
                                 double least, double most) {
  return Within(object.Number(key, fallback), least, most);
}

Spectrum GltfMaterialReader::Color(glm::vec3 color) {
  return {Within(double(color.x)), Within(double(color.y)), Within(double(color.z))};
}

scene::ScalarInput GltfMaterialReader::Scalar(const GltfValue& object, const char* factor,
                                              double fallback, const char* texture, int channel) {
  return {Number(object, factor, fallback),
          textures_.Get({object, texture}, GltfPictureUse::Numbers, part_), channel};
}

scene::ColorInput GltfMaterialReader::Colored(const GltfValue& object, const char* factor,
                                              glm::vec3 fallback, const char* texture) {
  return {Color(object.Vector(factor, fallback)),
          textures_.Get({object, texture}, GltfPictureUse::Color, part_)};
}

scene::Material GltfMaterialReader::Read() {
  ReadCore();
  const GltfValue glossiness = Extension("KHR_materials_pbrSpecularGlossiness");
  if (glossiness) ReadGlossiness(glossiness);
  ReadEmission();
  if (Extension("KHR_materials_unlit")) {
    ReadUnlit();
  } else if (!glossiness) {
    ReadSpecular();
    ReadTransmission();
    ReadDiffuseTransmission();
    ReadCoat();
    ReadSheen();
    ReadIridescence();
    ReadAnisotropy();
  }
  to_.physical = std::move(pbr_);
  return std::move(to_);
}

void GltfMaterialReader::ReadCore() {
  const tinygltf::PbrMetallicRoughness& metal = from_.pbrMetallicRoughness;
  const GltfTextureInfo roughness(metal.metallicRoughnessTexture);
  const std::vector<double>& base = metal.baseColorFactor;
  pbr_.baseColor = {
      Color({float(base[0]), float(base[1]), float(base[2])}),
      textures_.Get(GltfTextureInfo(metal.baseColorTexture), GltfPictureUse::Color, part_)};
  const scene::TextureIndex surface = textures_.Get(roughness, GltfPictureUse::Numbers, part_);
  pbr_.baseMetalness = {Within(metal.metallicFactor), surface, 2};
  pbr_.specularRoughness = {Within(metal.roughnessFactor), surface, 1};

  // Coverage
  to_.doubleSided = from_.doubleSided;
  to_.alphaCutoff = Within(from_.alphaCutoff, 0, 1e6);
  if (from_.alphaMode == "MASK") to_.alphaMode = scene::AlphaMode::Mask;
  if (from_.alphaMode == "BLEND") to_.alphaMode = scene::AlphaMode::Blend;
  if (to_.alphaMode != scene::AlphaMode::Opaque)
    to_.opacity = {Within(base[3]), pbr_.baseColor.texture, 3};

  // Relief
  to_.normalMap.texture =
      textures_.Get(GltfTextureInfo(from_.normalTexture), GltfPictureUse::Numbers, part_);
  if (std::isfinite(float(from_.normalTexture.scale)))
    to_.normalMap.scale = float(from_.normalTexture.scale);
  if (from_.occlusionTexture.index >= 0)
    findings_.Note("occlusion textures are ignored; shadows are traced");
}

void GltfMaterialReader::ReadEmission() {
  const GltfValue extension = Extension("KHR_materials_emissive_strength");
  const float strength = Number(extension, "emissiveStrength", 1, 0, 1e30);
  const std::vector<double>& factor = from_.emissiveFactor;
  pbr_.emission.value = Spectrum(0.0f);
  if (factor.size() == 3)
    pbr_.emission.value = Color({float(factor[0]), float(factor[1]), float(factor[2])}) * strength;
  if (pbr_.emission.value != Spectrum(0.0f))
    pbr_.emission.texture =
        textures_.Get(GltfTextureInfo(from_.emissiveTexture), GltfPictureUse::Color, part_);
}

// A surface that glows in its own colour and reflects nothing.
void GltfMaterialReader::ReadUnlit() {
  pbr_.emission = pbr_.baseColor;
  pbr_.baseWeight = 0;
  pbr_.baseMetalness = {0};
  pbr_.specularWeight = {0};
}

}  // namespace snell::io
