// SPDX-License-Identifier: Apache-2.0
//
// KHR_draco_mesh_compression: primitives packed by Draco, unpacked by its own decoder.
#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <limits>

#include "io/gltf/attributes.h"
#include "io/gltf/value.h"
#include "util/text.h"

namespace snell::io {
namespace {

// Best case of a mesh whose faces and vertices cost next to nothing; keeps small damaged files from asking
// for large memory.
constexpr std::uint64_t MostPerByte = 4096;

// What integers of this type divide by if an accessor calls them normalized.
float LargestOf(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8: return std::numeric_limits<std::int8_t>::max();
    case draco::DT_UINT8: return std::numeric_limits<std::uint8_t>::max();
    case draco::DT_INT16: return std::numeric_limits<std::int16_t>::max();
    case draco::DT_UINT16: return std::numeric_limits<std::uint16_t>::max();
    default: return 1;
  }
}

DracoMesh::Attribute Convert(const draco::Mesh& mesh, const draco::PointAttribute& from,
                             bool normalized) {
  DracoMesh::Attribute attribute;
  attribute.components = from.num_components();
  const std::size_t width = std::size_t(attribute.components);
  attribute.values.resize(std::size_t(mesh.num_points()) * width);
  const float scale = normalized && !from.normalized() ? 1 / LargestOf(from.data_type()) : 1.0f;
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    const draco::AttributeValueIndex value = from.mapped_index(point);
    float* to = &attribute.values[std::size_t(point.value()) * width];
    if (value.value() >= from.size() || !from.ConvertValue<float>(value, from.num_components(), to))
      continue;
    for (std::size_t k = 0; k < width; ++k) to[k] *= scale;
  }
  return attribute;
}

}  // namespace

DracoMesh DecodeDraco(GltfData& data, const tinygltf::Primitive& primitive,
                      const std::string& part) {
  const GltfValue extension(primitive.extensions, "KHR_draco_mesh_compression");
  const auto fault = [&](std::string_view message) {
    return data.document().Fault(part + ", KHR_draco_mesh_compression", message);
  };
  const std::string_view bytes = data.View(extension.Integer("bufferView"));
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) throw fault(decoded.status().error_msg_string());
  const draco::Mesh& from = *decoded.value();
  if (from.num_points() == 0 || from.num_faces() == 0) throw fault("it holds no triangles");
  if (std::uint64_t(from.num_points()) + from.num_faces() > bytes.size() * MostPerByte)
    throw fault("the data is damaged");

  DracoMesh mesh;
  mesh.vertexCount = from.num_points();
  const GltfValue ids = extension.Object("attributes");
  for (const auto& [name, accessor] : primitive.attributes) {
    const int id = ids.Integer(name);
    if (id < 0) continue;
    const draco::PointAttribute* attribute = from.GetAttributeByUniqueId(std::uint32_t(id));
    if (!attribute) throw fault(fmt::format("it has no attribute {} for {}", id, name));
    if (attribute->num_components() < 1 || attribute->num_components() > 4)
      throw fault(fmt::format("{} has a wrong number of components", name));
    mesh.attributes[name] = Convert(from, *attribute, data.Accessor(accessor).normalized);
  }
  mesh.indices.reserve(std::size_t(from.num_faces()) * 3);
  for (draco::FaceIndex face(0); face < from.num_faces(); ++face)
    for (int corner = 0; corner < 3; ++corner)
      mesh.indices.push_back(from.face(face)[std::size_t(corner)].value());
  return mesh;
}

}  // namespace snell::io
