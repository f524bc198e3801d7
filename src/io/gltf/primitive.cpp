// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "io/gltf/attributes.h"

namespace snell::io {
namespace {

using scene::Mesh;
using scene::uvec3;
using scene::vec2;
using scene::vec3;
using scene::vec4;

template <typename V>
std::vector<V> Vectors(const std::vector<float>& numbers) {
  static_assert(sizeof(V) % sizeof(float) == 0);
  std::vector<V> vectors(numbers.size() * sizeof(float) / sizeof(V));
  if (!vectors.empty()) std::memcpy(vectors.data(), numbers.data(), vectors.size() * sizeof(V));
  return vectors;
}

// Our v counts from the bottom of the picture, glTF's from its top.
std::vector<vec2> ReadUvs(GltfAttributes& attributes, const std::string& name, std::size_t count) {
  if (!attributes.Has(name)) return {};
  std::vector<vec2> uvs = Vectors<vec2>(attributes.Floats(name, 2, count));
  for (vec2& uv : uvs) uv.y = 1 - uv.y;
  return uvs;
}

std::vector<vec4> ReadColors(GltfAttributes& attributes, std::size_t count) {
  if (!attributes.Has("COLOR_0")) return {};
  if (attributes.Components("COLOR_0") == 4)
    return Vectors<vec4>(attributes.Floats("COLOR_0", 4, count));
  std::vector<vec4> colors;
  for (const vec3& color : Vectors<vec3>(attributes.Floats("COLOR_0", 3, count)))
    colors.emplace_back(color, 1.0f);
  return colors;
}

// The triangles of a list, a strip or a fan (glTF 2.0, section 3.7.2.1). Those with two equal corners,
// which join strips, are left out.
std::vector<uvec3> Triangles(const std::vector<std::uint32_t>& indices, int mode) {
  const std::size_t count = mode == TINYGLTF_MODE_TRIANGLES ? indices.size() / 3
                            : indices.size() >= 3           ? indices.size() - 2
                                                            : 0;
  std::vector<uvec3> triangles;
  triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    uvec3 t;
    switch (mode) {
      case TINYGLTF_MODE_TRIANGLES:
        t = {indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]};
        break;
      case TINYGLTF_MODE_TRIANGLE_STRIP:
        t = {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]};
        break;
      default: t = {indices[i + 1], indices[i + 2], indices[0]};
    }
    if (t.x != t.y && t.y != t.z && t.z != t.x) triangles.push_back(t);
  }
  return triangles;
}

bool IsReadable(const tinygltf::Primitive& primitive, GltfFindings& findings,
                const std::string& part) {
  if (primitive.mode < 0 || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    findings.Note("primitives of an unknown mode are left out", part);
  } else if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    findings.Note("points and lines are left out", part);
  } else if (!primitive.attributes.contains("POSITION")) {
    findings.Note("primitives without positions are left out", part);
  } else {
    return true;
  }
  return false;
}

}  // namespace

std::optional<Mesh> ReadGltfPrimitive(GltfData& data, const tinygltf::Primitive& primitive,
                                      std::span<const GltfDeformation> moments,
                                      std::size_t triangleLimit, const std::string& part) {
  GltfFindings& findings = data.document().findings;
  if (!IsReadable(primitive, findings, part)) return {};

  // Read what there is for each vertex
  GltfAttributes attributes(data, primitive, part);
  Mesh mesh;
  mesh.positions = Vectors<vec3>(attributes.Floats("POSITION", 3, GltfData::AnyCount));
  const std::size_t count = mesh.positions.size();
  if (count >= 0xffffffffu) throw data.document().Fault(part, "it has too many vertices");
  if (attributes.Has("NORMAL")) mesh.normals = Vectors<vec3>(attributes.Floats("NORMAL", 3, count));
  if (attributes.Has("TANGENT") && attributes.Has("NORMAL"))
    mesh.tangents = Vectors<vec4>(attributes.Floats("TANGENT", 4, count));
  mesh.uvs = ReadUvs(attributes, "TEXCOORD_0", count);
  mesh.uvs1 = ReadUvs(attributes, "TEXCOORD_1", count);
  mesh.colors = ReadColors(attributes, count);

  Bend(data, primitive, attributes, moments, mesh, part);

  // Connect the vertices
  const std::vector<std::uint32_t> indices = attributes.Indices(count);
  const auto outside = std::ranges::find_if(indices, [&](std::uint32_t i) { return i >= count; });
  if (outside != indices.end())
    throw data.document().Fault(part, fmt::format("index {} of {} vertices", *outside, count));
  const int mode = attributes.IsDraco() ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode == TINYGLTF_MODE_TRIANGLES && indices.size() % 3 != 0)
    findings.Note("the number of a primitive's indices is no multiple of three", part);
  mesh.triangles = Triangles(indices, mode);
  if (mesh.triangles.size() > triangleLimit)
    throw data.document().Fault(part, "the file has more triangles than Snell reads from one file",
                                LiftedBy(&ReadLimits::triangles));
  return FinishGltfMesh(std::move(mesh), findings, part);
}

}  // namespace snell::io
