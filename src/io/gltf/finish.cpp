// SPDX-License-Identifier: Apache-2.0
//
// The end of reading a primitive: what the rest of Snell relies on.
#include <cmath>
#include <glm/geometric.hpp>

#include "io/gltf/primitive.h"

namespace snell::io {
namespace {

using scene::Mesh;
using scene::uvec3;
using scene::vec2;
using scene::vec3;
using scene::vec4;

constexpr std::uint32_t Unused = 0xffffffffu;

bool IsFinite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <typename V>
void Keep(std::vector<V>& values, const std::vector<std::uint32_t>& sources) {
  if (values.empty()) return;
  std::vector<V> kept;
  kept.reserve(sources.size());
  for (const std::uint32_t source : sources) kept.push_back(values[source]);
  values = std::move(kept);
}

// Renumber the vertices in the order in which the triangles use them.
void DropUnused(Mesh& mesh) {
  std::vector<std::uint32_t> numberOf(mesh.positions.size(), Unused), sources;
  for (uvec3& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& number = numberOf[triangle[k]];
      if (number == Unused) {
        number = std::uint32_t(sources.size());
        sources.push_back(triangle[k]);
      }
      triangle[k] = number;
    }
  }
  Keep(mesh.positions, sources);
  Keep(mesh.normals, sources);
  Keep(mesh.tangents, sources);
  Keep(mesh.uvs, sources);
  Keep(mesh.uvs1, sources);
  Keep(mesh.colors, sources);
}

// Make a vector of unit length; false if it has no direction.
bool Normalize(vec3& v) {
  const double length = glm::length(glm::dvec3(v));
  if (!(length > 0) || !std::isfinite(length)) return false;
  v = vec3(glm::dvec3(v) / length);
  return true;
}

// Give vertices without a sound normal the mean of their triangles'.
void FinishNormals(Mesh& mesh, GltfFindings& findings, const std::string& part) {
  std::vector<bool> isBad(mesh.normals.size(), false);
  bool anyBad = false;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (Normalize(mesh.normals[i])) continue;
    isBad[i] = anyBad = true;
    mesh.normals[i] = vec3(0.0f);
  }
  if (!anyBad) return;
  findings.Note("normals without a direction are made anew", part);
  std::vector<glm::dvec3> sums(mesh.normals.size(), glm::dvec3(0.0));
  for (const uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    for (int k = 0; k < 3; ++k) sums[t[k]] += normal;
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (!isBad[i]) continue;
    const double length = glm::length(sums[i]);
    mesh.normals[i] = length > 0 && std::isfinite(length) ? vec3(sums[i] / length) : vec3(0, 1, 0);
  }
}

// Tangents are all sound, or none.
void FinishTangents(Mesh& mesh, GltfFindings& findings, const std::string& part) {
  for (vec4& tangent : mesh.tangents) {
    vec3 direction(tangent);
    if (!Normalize(direction) || !std::isfinite(tangent.w)) {
      findings.Note("tangents without a direction: the mesh's are left out", part);
      mesh.tangents.clear();
      return;
    }
    tangent = vec4(direction, tangent.w < 0 ? -1.0f : 1.0f);
  }
}

void FinishUvs(std::vector<vec2>& uvs, GltfFindings& findings, const std::string& part) {
  for (vec2& uv : uvs) {
    if (std::isfinite(uv.x) && std::isfinite(uv.y)) continue;
    findings.Note("texture coordinates that are not finite are set to 0", part);
    uv = vec2(0.0f);
  }
}

void FinishColors(Mesh& mesh, GltfFindings& findings, const std::string& part) {
  for (vec4& color : mesh.colors) {
    for (int k = 0; k < 4; ++k) {
      if (color[k] >= 0 && std::isfinite(color[k])) continue;
      findings.Note("colours of vertices that are negative or not finite are set to 0", part);
      color[k] = 0;
    }
  }
}

}  // namespace

std::optional<Mesh> FinishGltfMesh(Mesh mesh, GltfFindings& findings, const std::string& part) {
  const std::size_t removed = std::erase_if(mesh.triangles, [&](const uvec3& t) {
    return !IsFinite(mesh.positions[t.x]) || !IsFinite(mesh.positions[t.y]) ||
           !IsFinite(mesh.positions[t.z]);
  });
  if (removed > 0) findings.Note("triangles with positions that are not finite are left out", part);
  if (mesh.triangles.empty()) {
    findings.Note("primitives without triangles are left out", part);
    return {};
  }
  DropUnused(mesh);
  FinishNormals(mesh, findings, part);
  FinishTangents(mesh, findings, part);
  FinishUvs(mesh.uvs, findings, part);
  FinishUvs(mesh.uvs1, findings, part);
  FinishColors(mesh, findings, part);
  return mesh;
}

}  // namespace snell::io
