// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/vertices.h"

#include <tbb/parallel_for.h>

#include <cstddef>

namespace snell::io {
namespace {

using scene::Mesh;
using scene::uvec3;

constexpr std::uint32_t None = 0xffffffffu;

template <class T>
std::vector<T> Copy(const std::vector<T>& values, std::span<const std::uint32_t> vertices) {
  if (values.empty()) return {};
  std::vector<T> copies(vertices.size());
  constexpr std::size_t Block = 16384;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, copies.size(), Block),
                    [&](const auto& block) {
                      for (std::size_t i = block.begin(); i < block.end(); ++i)
                        copies[i] = values[vertices[i]];
                    });
  return copies;
}

template <class T>
void Append(std::vector<T>& values, const std::vector<T>& others) {
  values.insert(values.end(), others.begin(), others.end());
}

}  // namespace

Mesh CopyVertices(const Mesh& mesh, std::span<const std::uint32_t> vertices) {
  Mesh copy;
  copy.positions = Copy(mesh.positions, vertices);
  copy.normals = Copy(mesh.normals, vertices);
  copy.uvs = Copy(mesh.uvs, vertices);
  copy.uvs1 = Copy(mesh.uvs1, vertices);
  copy.tangents = Copy(mesh.tangents, vertices);
  copy.colors = Copy(mesh.colors, vertices);
  for (const scene::MeshKey& key : mesh.keys)
    copy.keys.push_back({key.time, Copy(key.positions, vertices), Copy(key.normals, vertices),
                         Copy(key.tangents, vertices)});
  return copy;
}

void AppendVertices(Mesh& mesh, const Mesh& other) {
  Append(mesh.positions, other.positions);
  Append(mesh.normals, other.normals);
  Append(mesh.uvs, other.uvs);
  Append(mesh.uvs1, other.uvs1);
  Append(mesh.tangents, other.tangents);
  Append(mesh.colors, other.colors);
  for (std::size_t i = 0; i < mesh.keys.size(); ++i) {
    Append(mesh.keys[i].positions, other.keys[i].positions);
    Append(mesh.keys[i].normals, other.keys[i].normals);
    Append(mesh.keys[i].tangents, other.keys[i].tangents);
  }
}

TriangleExtractor::TriangleExtractor(const Mesh& mesh)
    : mesh_(mesh), vertexOf_(mesh.positions.size(), None) {}

Mesh TriangleExtractor::Extract(std::span<const std::uint32_t> triangles) {
  std::vector<uvec3> renamed;
  renamed.reserve(triangles.size());
  std::vector<bool> joins;
  std::vector<std::uint32_t> sources;
  for (const std::uint32_t i : triangles) {
    uvec3 triangle = mesh_.triangles[i];
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& vertex = vertexOf_[triangle[k]];
      if (vertex == None) {
        vertex = std::uint32_t(sources.size());
        sources.push_back(triangle[k]);
      }
      triangle[k] = vertex;
    }
    renamed.push_back(triangle);
    if (!mesh_.joins.empty()) joins.push_back(mesh_.joins[i]);
  }
  for (const std::uint32_t source : sources) vertexOf_[source] = None;

  Mesh part = CopyVertices(mesh_, sources);
  part.triangles = std::move(renamed);
  part.joins = std::move(joins);
  return part;
}

}  // namespace snell::io
