// SPDX-License-Identifier: Apache-2.0
//
// The end of reading a primitive: what the rest of Snell relies on.
#include <algorithm>
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
  for (scene::MeshKey& key : mesh.keys) {
    Keep(key.positions, sources);
    Keep(key.normals, sources);
    Keep(key.tangents, sources);
  }
}

// Make a vector of unit length; false if it has no direction.
bool Normalize(vec3& v) {
  const double length = glm::length(glm::dvec3(v));
  if (!(length > 0) || !std::isfinite(length)) return false;
  v = vec3(glm::dvec3(v) / length);
  return true;
}

// Give vertices without a sound normal the mean of their triangles'.
void FinishNormals(const std::vector<uvec3>& triangles, const std::vector<vec3>& positions,
                   std::vector<vec3>& normals, GltfFindings& findings, const std::string& part) {
  std::vector<bool> isBad(normals.size(), false);
  bool anyBad = false;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (Normalize(normals[i])) continue;
    isBad[i] = anyBad = true;
    normals[i] = vec3(0.0f);
  }
  if (!anyBad) return;
  findings.Note("normals without a direction are made anew", part);
  std::vector<glm::dvec3> sums(normals.size(), glm::dvec3(0.0));
  for (const uvec3& t : triangles) {
    const glm::dvec3 a(positions[t.x]), b(positions[t.y]), c(positions[t.z]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    for (int k = 0; k < 3; ++k) sums[t[k]] += normal;
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!isBad[i]) continue;
    const double length = glm::length(sums[i]);
    normals[i] = length > 0 && std::isfinite(length) ? vec3(sums[i] / length) : vec3(0, 1, 0);
  }
}

// Make tangents sound; false if some have no direction.
bool NormalizeTangents(std::vector<vec4>& tangents) {
  for (vec4& tangent : tangents) {
    vec3 direction(tangent);
    if (!Normalize(direction) || !std::isfinite(tangent.w)) return false;
    tangent = vec4(direction, tangent.w < 0 ? -1.0f : 1.0f);
  }
  return true;
}

// Tangents are all sound, or none.
void FinishTangents(Mesh& mesh, GltfFindings& findings, const std::string& part) {
  bool good = NormalizeTangents(mesh.tangents);
  for (scene::MeshKey& key : mesh.keys) good = NormalizeTangents(key.tangents) && good;
  if (good) return;
  findings.Note("tangents without a direction: the mesh's are left out", part);
  mesh.tangents.clear();
  for (scene::MeshKey& key : mesh.keys) key.tangents.clear();
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
  const auto isUndefined = [](const std::vector<vec3>& positions, const uvec3& t) {
    return !IsFinite(positions[t.x]) || !IsFinite(positions[t.y]) || !IsFinite(positions[t.z]);
  };
  const std::size_t removed = std::erase_if(mesh.triangles, [&](const uvec3& t) {
    return isUndefined(mesh.positions, t) ||
           std::ranges::any_of(
               mesh.keys, [&](const scene::MeshKey& key) { return isUndefined(key.positions, t); });
  });
  if (removed > 0) findings.Note("triangles with positions that are not finite are left out", part);
  if (mesh.triangles.empty()) {
    findings.Note("primitives without triangles are left out", part);
    return {};
  }
  DropUnused(mesh);
  FinishNormals(mesh.triangles, mesh.positions, mesh.normals, findings, part);
  for (scene::MeshKey& key : mesh.keys)
    FinishNormals(mesh.triangles, key.positions, key.normals, findings, part);
  FinishTangents(mesh, findings, part);
  FinishUvs(mesh.uvs, findings, part);
  FinishUvs(mesh.uvs1, findings, part);
  FinishColors(mesh, findings, part);
  return mesh;
}

}  // namespace snell::io
