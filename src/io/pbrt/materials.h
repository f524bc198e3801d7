// SPDX-License-Identifier: Apache-2.0
//
// pbrt's materials as OpenPBR surfaces. docs/pbrt.md has the mapping and what it approximates.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "io/pbrt/textures.h"

namespace snell::io {

struct PbrtMaterial {
  scene::Material record;
  bool isInterface = false;  // only bounds a medium, and is not seen
};

// What a shape adds to its material.
struct PbrtSurface {
  int material = 0;             // of PbrtMaterials
  scene::ScalarInput alpha{1};  // below 1: gaps
  scene::Spectrum emission{0.0f};
};

class PbrtMaterials {
 public:
  // Material 0 is pbrt's default: diffuse, 0.5.
  PbrtMaterials(PbrtContext& context, const PbrtTextures& textures);

  // The number of a new material.
  int Make(const std::string& type, const PbrtParameters& parameters);
  void SetName(const std::string& name, int material) { named_[name] = material; }
  // Throws Error if there is no material of this name.
  int Named(const std::string& name, const Place& place) const;
  const PbrtMaterial& At(int material) const { return materials_[std::size_t(material)]; }

  // The scene's material for a surface; equal ones are one.
  scene::MaterialIndex Use(const PbrtSurface& surface);

 private:
  PbrtMaterial Mix(const PbrtParameters& parameters);

  PbrtContext& context_;
  const PbrtTextures& textures_;
  std::vector<PbrtMaterial> materials_;
  std::map<std::string, int> named_;
  std::map<std::vector<float>, scene::MaterialIndex> used_;
  std::map<std::tuple<scene::TextureIndex, float, float>, scene::TextureIndex> powers_;
  std::uint64_t madeBytes_ = 0;  // of pictures made of others

  friend class PbrtMaterialReader;
};

// The reader of one material statement.
class PbrtMaterialReader {
 public:
  PbrtMaterialReader(PbrtMaterials& materials, const PbrtParameters& parameters)
      : owner_(materials),
        context_(materials.context_),
        textures_(materials.textures_),
        parameters_(parameters) {}

  PbrtMaterial Read(const std::string& type);

 private:
  void ReadDiffuse();
  void ReadCoatedDiffuse();
  void ReadConductor(const std::string& prefix);
  void ReadCoatedConductor();
  void ReadDielectric(bool thin);
  void ReadDiffuseTransmission();
  void ReadSubsurface();
  void ReadHair();
  void ReadOlder(const std::string& type);
  void ReadRelief();

  // Roughness as pbrt has it, as OpenPBR's, with its direction.
  void ReadRoughness(const std::string& prefix, float absent);
  scene::ScalarInput OpenPbrRoughness(const scene::ScalarInput& roughness, bool remap);
  scene::TextureIndex Power(scene::TextureIndex texture, float scale, float exponent);
  float Ior(std::string_view name, float absent);
  scene::Spectrum Quantity(std::string_view name, const scene::Spectrum& absent);

  PbrtMaterials& owner_;
  PbrtContext& context_;
  const PbrtTextures& textures_;
  const PbrtParameters& parameters_;
  PbrtMaterial made_;
  scene::OpenPbr pbr_;
};

}  // namespace snell::io
