// SPDX-License-Identifier: Apache-2.0
//
// Meshes of which a part has normals: the other part is smoothed alone, and the two are put together.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/mesh_normals.h"

namespace snell::io {
namespace {

using scene::Mesh;
using scene::uvec3;
using scene::vec3;

using Index = std::uint32_t;
constexpr Index None = 0xffffffffu;

// Some of the triangles with the vertices that they use.
Mesh Extract(const Mesh& mesh, const std::vector<uvec3>& triangles) {
  Mesh part;
  part.triangles = triangles;
  std::vector<Index> vertexOf(mesh.positions.size(), None);
  for (uvec3& triangle : part.triangles) {
    for (int k = 0; k < 3; ++k) {
      Index& vertex = vertexOf[triangle[k]];
      if (vertex == None) {
        vertex = Index(part.positions.size());
        part.positions.push_back(mesh.positions[triangle[k]]);
        part.normals.push_back(mesh.normals[triangle[k]]);
        if (!mesh.uvs.empty()) part.uvs.push_back(mesh.uvs[triangle[k]]);
      }
      triangle[k] = vertex;
    }
  }
  return part;
}

void Append(Mesh& mesh, const Mesh& other) {
  const Index offset = Index(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const uvec3& triangle : other.triangles) mesh.triangles.push_back(triangle + offset);
}

}  // namespace

void CompleteNormals(Mesh& mesh, float creaseDegrees) {
  const auto isComplete = [&](const uvec3& t) {
    const vec3 zero(0.0f);
    return mesh.normals[t.x] != zero && mesh.normals[t.y] != zero && mesh.normals[t.z] != zero;
  };
  std::vector<uvec3> complete, lacking;
  if (std::all_of(mesh.triangles.begin(), mesh.triangles.end(), isComplete)) return;
  for (const uvec3& triangle : mesh.triangles)
    (isComplete(triangle) ? complete : lacking).push_back(triangle);
  if (complete.empty()) {
    mesh.normals.clear();
    return;
  }

  // Flat triangles beside smooth ones are smooth within a small fraction of a degree
  Mesh completed = Extract(mesh, lacking);
  SmoothNormals(completed, std::max(creaseDegrees, 0.01f));
  Mesh result = Extract(mesh, complete);
  Append(result, completed);
  result.name = std::move(mesh.name);
  mesh = std::move(result);
}

}  // namespace snell::io
