// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/materials.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <cmath>
#include <string_view>

#include "io/images.h"
#include "io/obj/mtl_material.h"

namespace snell::io {
namespace {

class MaterialReader {
 public:
  MaterialReader(const aiScene& file, const std::string& path, ImageLoader& images,
                 Findings& findings)
      : file_(file), path_(path), images_(images), findings_(findings) {}

  MtlMaterial Read(const aiMaterial& from) {
    from_ = &from;
    to_ = {};
    to_.file = path_;
    aiString name;
    if (from.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) to_.name = name.C_Str();
    ReadColors();
    ReadNumbers();
    for (const auto& [type, key] : {std::pair(aiTextureType_DIFFUSE, MtlMapKey::Kd),
                                    {aiTextureType_BASE_COLOR, MtlMapKey::Kd},
                                    {aiTextureType_SPECULAR, MtlMapKey::Ks},
                                    {aiTextureType_EMISSIVE, MtlMapKey::Ke},
                                    {aiTextureType_OPACITY, MtlMapKey::D},
                                    {aiTextureType_NORMALS, MtlMapKey::Normal},
                                    {aiTextureType_HEIGHT, MtlMapKey::Bump},
                                    {aiTextureType_METALNESS, MtlMapKey::Pm},
                                    {aiTextureType_DIFFUSE_ROUGHNESS, MtlMapKey::Pr}})
      ReadMap(type, key);
    for (const aiTextureType type : {aiTextureType_AMBIENT, aiTextureType_DISPLACEMENT,
                                     aiTextureType_REFLECTION, aiTextureType_SHININESS})
      if (from.GetTextureCount(type) > 0)
        findings_.Add("texture", "of a kind that is not read", to_.name, {path_});
    return std::move(to_);
  }

 private:
  void SetColor(const char* key, MtlColor color, float factor = 1) {
    aiColor4D value;
    if (from_->Get(key, 0, 0, value) != aiReturn_SUCCESS) return;
    const scene::vec3 scaled = factor * scene::vec3(value.r, value.g, value.b);
    if (std::isfinite(scaled.x) && std::isfinite(scaled.y) && std::isfinite(scaled.z))
      to_.colors[std::size_t(color)] = scaled;
  }

  bool SetNumber(const char* key, MtlNumber number) {
    ai_real value = 0;
    if (from_->Get(key, 0, 0, value) != aiReturn_SUCCESS || !std::isfinite(value)) return false;
    to_.numbers[std::size_t(number)] = float(value);
    return true;
  }

  void ReadColors() {
    ai_real strength = 1;
    if (from_->Get(AI_MATKEY_SHININESS_STRENGTH, strength) != aiReturn_SUCCESS) strength = 1;
    SetColor("$clr.diffuse", MtlColor::Kd);
    SetColor("$clr.base", MtlColor::Kd);
    SetColor("$clr.specular", MtlColor::Ks, float(strength));
    SetColor("$clr.emissive", MtlColor::Ke);
    int shading = aiShadingMode_Phong;
    from_->Get(AI_MATKEY_SHADING_MODEL, shading);
    const bool matt = shading == aiShadingMode_Gouraud || shading == aiShadingMode_Flat ||
                      shading == aiShadingMode_NoShading;
    to_.numbers[std::size_t(MtlNumber::Illum)] = matt ? 1.0f : 2.0f;
  }

  void ReadNumbers() {
    // 0 is what files say that do not know it
    if (SetNumber("$mat.shininess", MtlNumber::Ns) && !(to_.Of(MtlNumber::Ns) > 0.0f))
      to_.numbers[std::size_t(MtlNumber::Ns)].reset();
    SetNumber("$mat.refracti", MtlNumber::Ni);
    SetNumber("$mat.metallicFactor", MtlNumber::Pm);
    SetNumber("$mat.roughnessFactor", MtlNumber::Pr);
    // Programs that mean nothing by it write 0
    if (SetNumber("$mat.opacity", MtlNumber::D) && to_.Of(MtlNumber::D) == 0.0f) {
      findings_.Add("material", "with opacity 0, taken for 1", to_.name, {path_});
      to_.numbers[std::size_t(MtlNumber::D)] = 1.0f;
    }
  }

  void ReadMap(aiTextureType type, MtlMapKey key) {
    aiString name;
    unsigned uvSet = 0;
    aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap,
                                 aiTextureMapMode_Wrap};
    if (from_->GetTexture(type, 0, &name, nullptr, &uvSet, nullptr, nullptr, modes) !=
        aiReturn_SUCCESS)
      return;
    if (uvSet != 0)
      findings_.Add("texture", "with its second coordinates, shown by the first ones", to_.name,
                    {path_});
    MtlMap map;
    map.name = name.C_Str();
    map.clamp = modes[0] == aiTextureMapMode_Clamp;
    aiUVTransform transform;
    if (from_->Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == aiReturn_SUCCESS) {
      const scene::vec2 scale(transform.mScaling.x, transform.mScaling.y);
      const scene::vec2 offset(transform.mTranslation.x, transform.mTranslation.y);
      const bool sound = std::isfinite(offset.x) && std::isfinite(offset.y) &&
                         std::abs(scale.x) > 1e-6f && std::abs(scale.y) > 1e-6f &&
                         std::isfinite(scale.x) && std::isfinite(scale.y);
      if (sound) map.scale = scale, map.offset = offset;
      if (transform.mRotation != 0)
        findings_.Add("texture", "that is turned, shown upright", to_.name, {path_});
    }
    if (const aiTexture* embedded = file_.GetEmbeddedTexture(name.C_Str())) {
      if (embedded->mHeight != 0) {
        findings_.Add("embedded picture", "that is not compressed, left out", map.name, {path_});
        return;
      }
      images_.Provide(map.name, std::string_view(reinterpret_cast<const char*>(embedded->pcData),
                                                 embedded->mWidth));
    }
    to_.maps[std::size_t(key)] = std::move(map);
  }

  const aiScene& file_;
  const std::string& path_;
  ImageLoader& images_;
  Findings& findings_;
  const aiMaterial* from_ = nullptr;
  MtlMaterial to_;
};

}  // namespace

std::vector<scene::MaterialIndex> ReadAssimpMaterials(const aiScene& file,
                                                      const std::filesystem::path& path,
                                                      const ReadOptions& options,
                                                      const WarningSink& warn, Findings& findings,
                                                      scene::Scene& scene) {
  ImageLoader images(FoldersOf(path, options), warn, options.limits);
  MtlConverter converter(scene, images, findings);
  const std::string name = path.string();
  MaterialReader reader(file, name, images, findings);
  std::vector<scene::MaterialIndex> indices(file.mNumMaterials, -1);
  for (unsigned i = 0; i < file.mNumMaterials; ++i) {
    MtlMaterial read = reader.Read(*file.mMaterials[i]);
    if (read.name == AI_DEFAULT_MATERIAL_NAME || LowerExtension(path) == "off") continue;
    scene.materials.push_back(converter.Convert(read));
    indices[i] = scene::MaterialIndex(scene.materials.size()) - 1;
  }
  return indices;
}

}  // namespace snell::io
