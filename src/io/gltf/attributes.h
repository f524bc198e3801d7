// SPDX-License-Identifier: Apache-2.0
//
// The vertex attributes and indices of a glTF primitive, from its accessors or from a Draco stream.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/data.h"

namespace snell::io {

// What a stream of KHR_draco_mesh_compression holds: attributes by name, each with a number of components.
struct DracoMesh {
  struct Attribute {
    int components = 0;
    std::vector<float> values;
  };
  std::size_t vertexCount = 0;
  std::map<std::string, Attribute> attributes;
  std::vector<std::uint32_t> indices;  // three a triangle
};

// Throws Error if the stream is damaged or lacks an attribute.
DracoMesh DecodeDraco(GltfData& data, const tinygltf::Primitive& primitive,
                      const std::string& part);

class GltfAttributes {
 public:
  GltfAttributes(GltfData& data, const tinygltf::Primitive& primitive, std::string part);

  bool Has(const std::string& name) const { return primitive_.attributes.contains(name); }
  // How many numbers an attribute has for each vertex.
  int Components(const std::string& name) const;
  // Of an attribute that is there; `count` vertices, unless it is GltfData::AnyCount.
  std::vector<float> Floats(const std::string& name, int components, std::size_t count);
  // In the order of the primitive's mode.
  std::vector<std::uint32_t> Indices(std::size_t vertexCount);
  bool IsDraco() const { return isDraco_; }

 private:
  GltfData& data_;
  const tinygltf::Primitive& primitive_;
  std::string part_;
  bool isDraco_ = false;
  DracoMesh draco_;
};

}  // namespace snell::io
