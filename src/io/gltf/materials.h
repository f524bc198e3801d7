// SPDX-License-Identifier: Apache-2.0
//
// glTF's materials, with their extensions, as OpenPBR surfaces. docs/gltf.md says what is approximated.
#pragma once

#include <string>
#include <vector>

#include "io/gltf/textures.h"
#include "scene/scene.h"

namespace snell::io {

class GltfMaterials {
 public:
  GltfMaterials(GltfData& data, scene::Scene& scene);

  // The scene's material for one of glTF's; its default for -1.
  scene::MaterialIndex Get(int material);

 private:
  scene::Material Convert(const tinygltf::Material& from, const std::string& part);

  const GltfDocument& document_;
  scene::Scene& scene_;
  GltfTextures textures_;
  std::vector<scene::MaterialIndex> known_;
  scene::MaterialIndex default_ = -1;
};

// Reads the inputs of one material.
class GltfMaterialReader {
 public:
  GltfMaterialReader(const tinygltf::Material& from, GltfTextures& textures, GltfFindings& findings,
                     std::string part)
      : from_(from), textures_(textures), findings_(findings), part_(std::move(part)) {}

  scene::Material Read();

 private:
  GltfValue Extension(const char* name) const { return GltfValue(from_.extensions, name); }
  // A number that must lie in [least, most], else it is cut, which is noted.
  float Number(const GltfValue& object, const char* key, double fallback, double least = 0,
               double most = 1);
  float Within(double number, double least = 0, double most = 1);
  scene::Spectrum Color(glm::vec3 color);
  scene::ScalarInput Scalar(const GltfValue& object, const char* factor, double fallback,
                            const char* texture, int channel);
  scene::ColorInput Colored(const GltfValue& object, const char* factor, glm::vec3 fallback,
                            const char* texture);

  void ReadCore();
  void ReadGlossiness(const GltfValue& extension);
  void ReadSpecular();
  void ReadTransmission();
  void ReadDiffuseTransmission();
  void ReadCoat();
  void ReadSheen();
  void ReadIridescence();
  void ReadAnisotropy();
  void ReadEmission();
  void ReadUnlit();

  const tinygltf::Material& from_;
  GltfTextures& textures_;
  GltfFindings& findings_;
  std::string part_;
  scene::Material to_;
  scene::OpenPbr pbr_;
};

}  // namespace snell::io
