// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/attributes.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "util/text.h"

namespace snell::io {

GltfAttributes::GltfAttributes(GltfData& data, const tinygltf::Primitive& primitive,
                               std::string part)
    : data_(data), primitive_(primitive), part_(std::move(part)) {
  isDraco_ = primitive.extensions.contains("KHR_draco_mesh_compression");
  if (isDraco_) draco_ = DecodeDraco(data, primitive, part_);
}

int GltfAttributes::Components(const std::string& name) const {
  if (const auto found = draco_.attributes.find(name); found != draco_.attributes.end())
    return found->second.components;
  const int type = data_.Accessor(primitive_.attributes.at(name)).type;
  return tinygltf::GetNumComponentsInType(std::uint32_t(type));
}

std::vector<float> GltfAttributes::Floats(const std::string& name, int components,
                                          std::size_t count) {
  // A stream may leave attributes to plain accessors
  const auto found = draco_.attributes.find(name);
  if (found == draco_.attributes.end())
    return data_.Floats(primitive_.attributes.at(name), components, count);
  if (found->second.components != components)
    throw data_.document().Fault(
        part_, fmt::format("{} has {} for each vertex, {} are needed", name,
                           Plural(std::uint64_t(found->second.components), "number"), components));
  return found->second.values;
}

std::vector<std::uint32_t> GltfAttributes::Indices(std::size_t vertexCount) {
  if (isDraco_) return std::move(draco_.indices);
  if (const auto found = primitive_.attributes.find(GltfDocument::Indices);
      found != primitive_.attributes.end())
    return data_.Indices(found->second);
  std::vector<std::uint32_t> indices(vertexCount);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

}  // namespace snell::io
