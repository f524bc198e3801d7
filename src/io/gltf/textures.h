// SPDX-License-Identifier: Apache-2.0
//
// The textures of a glTF document in the scene: pictures decoded once, samplers, texture coordinates and
// KHR_texture_transform.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "io/gltf/data.h"
#include "io/gltf/value.h"
#include "scene/scene.h"

namespace snell::io {

// A material's reference to a texture (glTF's textureInfo).
struct GltfTextureInfo {
  GltfTextureInfo() = default;
  // tinygltf's three kinds
  template <typename Info>
  explicit GltfTextureInfo(const Info& info)
      : texture(info.index),
        coordinates(info.texCoord),
        transform(info.extensions, "KHR_texture_transform") {}
  // A member of an extension
  GltfTextureInfo(const GltfValue& object, const std::string& key)
      : texture(object.Object(key).Integer("index")),
        coordinates(object.Object(key).Integer("texCoord", 0)),
        transform(object.Object(key).Object("extensions").Object("KHR_texture_transform")) {}

  int texture = -1;
  int coordinates = 0;
  GltfValue transform;
};

// What a picture's numbers mean: encoded colours, numbers, or glossiness in alpha, which becomes roughness:
// 1 - alpha · gloss.
enum class GltfPictureUse { Color, Numbers, Gloss };

// A picture with the numbers that its file has, as bytes if they fit.
struct GltfPicture {
  scene::Image texels;
  std::string fault;  // why there is none; empty if there is
};

class GltfTextures {
 public:
  // Decodes the pictures of all textures, on all threads.
  GltfTextures(GltfData& data, scene::Scene& scene);

  // -1 where there is no texture, or none that can be shown, which is noted.
  scene::TextureIndex Get(const GltfTextureInfo& info, GltfPictureUse use, const std::string& part,
                          double gloss = 1);

 private:
  using Key = std::tuple<int, GltfPictureUse, double>;

  std::vector<int> Sources(const tinygltf::Texture& texture) const;
  scene::ImageIndex ImageOf(int image, GltfPictureUse use, double gloss);

  GltfData& data_;
  scene::Scene& scene_;
  std::map<int, GltfPicture> pictures_;    // by glTF's image
  std::map<int, scene::ImageIndex> home_;  // where a picture's bytes went
  std::map<Key, scene::ImageIndex> images_;
  std::map<std::vector<double>, scene::TextureIndex> textures_;
};

// Decode an image of the document; a fault is told in the result.
GltfPicture ReadGltfPicture(const GltfDocument& document, std::string_view viewBytes, int image);

// From the picture's space to our texture coordinates, both with v up, by KHR_texture_transform.
scene::Affine GltfPlacement(const GltfValue& transform);

}  // namespace snell::io
