// SPDX-License-Identifier: Apache-2.0
#include "tessellate/keys.h"

#include <algorithm>
#include <set>
#include <utility>

namespace snell::tessellate {

using scene::Mesh;
using scene::MeshKey;
using scene::vec3;

namespace {

// The creases of a mesh whose vertices go from `from` to `to`.
std::vector<scene::Crease> MovedCreases(const std::vector<scene::Crease>& creases,
                                        const std::vector<vec3>& from,
                                        const std::vector<vec3>& to) {
  std::vector<scene::Crease> moved = creases;
  const auto move = [&](vec3& place) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i] != place) continue;
      place = to[i];
      return;
    }
  };
  for (scene::Crease& crease : moved) move(crease.from), move(crease.to);
  return moved;
}

// The vertices of a triangle and the next one.
std::set<std::uint32_t> VerticesFrom(const std::vector<scene::uvec3>& triangles, std::size_t i) {
  std::set<std::uint32_t> vertices;
  for (std::size_t end = std::min(i + 2, triangles.size()); i < end; ++i)
    for (int k = 0; k < 3; ++k) vertices.insert(triangles[i][k]);
  return vertices;
}

// Whether triangles cover the same faces: those of a quadrilateral may be cut along its other diagonal.
bool CoverTheSame(const std::vector<scene::uvec3>& a, const std::vector<scene::uvec3>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (VerticesFrom(a, i) != VerticesFrom(b, i)) return false;
    ++i;
  }
  return true;
}

}  // namespace

bool ChangeAllKeys(Mesh& mesh, const std::function<bool(Mesh& mesh)>& change) {
  if (mesh.keys.empty()) return change(mesh);
  Mesh still = mesh;
  still.keys.clear();
  Mesh first = still;
  if (!change(first)) return false;
  for (const MeshKey& key : mesh.keys) {
    Mesh later = still;
    later.positions = key.positions;
    later.normals = key.normals;
    later.tangents = key.tangents;
    later.creases = MovedCreases(still.creases, still.positions, key.positions);
    if (!change(later) || !CoverTheSame(later.triangles, first.triangles) ||
        later.positions.size() != first.positions.size() ||
        later.normals.size() != first.normals.size())
      return false;
    first.keys.push_back({key.time, std::move(later.positions), std::move(later.normals),
                          std::move(later.tangents)});
  }
  mesh = std::move(first);
  return true;
}

}  // namespace snell::tessellate
