// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <utility>

#include "scene/places.h"
#include "util/index_table.h"
#include "util/text.h"

namespace snell::io {

using glm::dvec3;
using scene::Mesh;
using scene::MeshKey;
using scene::uvec3;
using scene::vec3;

namespace {

// The vertices that share a normal, by number, for they lie at one place with the same normal.
struct NormalGroups {
  std::vector<std::uint32_t> groupOf;
  std::uint32_t count = 0;
};

NormalGroups GroupNormals(const Mesh& mesh) {
  NormalGroups groups;
  std::vector<std::uint32_t> first;  // a vertex of each
  IndexTable table(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const uvec3 p = scene::PositionBits(mesh.positions[v]),
                n = scene::PositionBits(mesh.normals[v]);
    const std::uint64_t hash = MixBits(HashOf(p.x, p.y, p.z) + HashOf(n.x, n.y, n.z) * 3);
    groups.groupOf.push_back(table.FindOrAdd(hash, groups.count, [&](std::uint32_t g) {
      return mesh.positions[first[g]] == mesh.positions[v] &&
             mesh.normals[first[g]] == mesh.normals[v];
    }));
    if (groups.groupOf.back() != groups.count) continue;
    first.push_back(v);
    ++groups.count;
  }
  return groups;
}

// For each group, the normals of the faces around, weighted by their corners' angles (normals.h).
std::vector<dvec3> SumNormals(const Mesh& mesh, const std::vector<vec3>& positions,
                              const NormalGroups& groups) {
  std::vector<dvec3> sums(groups.count, dvec3(0.0));
  for (const uvec3& t : mesh.triangles) {
    const dvec3 p[3] = {dvec3(positions[t.x]), dvec3(positions[t.y]), dvec3(positions[t.z])};
    const dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double size = glm::length(normal);
    if (!(size > 0)) continue;
    for (int k = 0; k < 3; ++k) {
      const dvec3 a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
      sums[groups.groupOf[t[k]]] += normal / size * std::atan2(size, glm::dot(a, b));
    }
  }
  return sums;
}

}  // namespace

void AddShape(FaceSet& faces, const MeshFile& file, const FaceSet& shape,
              const MeshFile& shapeFile) {
  const auto fail = [&](const std::string& what) {
    const std::string other = std::filesystem::path(file.name).filename().string();
    throw Error(fmt::format("its shape is no other one of '{}': {}", other, what),
                shapeFile.AtLine(0), "files of one mesh have the same faces in the same order");
  };
  if (shape.positions.size() != faces.positions.size() || shape.faceCount != faces.faceCount)
    fail(fmt::format("it has {} vertices and {}, that one {} and {}",
                     WithCommas(shape.positions.size()), Plural(shape.faceCount, "face"),
                     WithCommas(faces.positions.size()), WithCommas(faces.faceCount)));
  if (shape.sizes != faces.sizes || shape.positionOf != faces.positionOf)
    fail("its faces connect other vertices");
  for (const std::uint32_t vertex : shape.positionOf) {
    const vec3 p = shape.positions[vertex];
    if (!(glm::length(dvec3(p)) < 1e18))
      fail(fmt::format("its vertex {} is infinite, huge or undefined", vertex + 1));
  }
  faces.shapes.push_back(shape.positions);
}

void CompleteKeys(Mesh& mesh) {
  if (mesh.keys.empty()) return;
  if (!mesh.normals.empty()) {
    const NormalGroups groups = GroupNormals(mesh);
    const std::vector<dvec3> own = SumNormals(mesh, mesh.positions, groups);
    for (MeshKey& key : mesh.keys) {
      if (key.positions == mesh.positions) {
        key.normals = mesh.normals;
        continue;
      }
      const std::vector<dvec3> sums = SumNormals(mesh, key.positions, groups);
      key.normals = mesh.normals;
      for (std::size_t v = 0; v < key.normals.size(); ++v) {
        // Normals that a file has may point to the other side than its faces
        const dvec3& sum = sums[groups.groupOf[v]];
        const bool isTurned = glm::dot(own[groups.groupOf[v]], dvec3(mesh.normals[v])) < 0;
        const double length = glm::length(sum);
        if (length > 1e-9) key.normals[v] = vec3(sum / (isTurned ? -length : length));
      }
    }
  }
  mesh.time = mesh.keys.front().time;
  mesh.positions = std::move(mesh.keys.front().positions);
  mesh.normals = std::move(mesh.keys.front().normals);
  mesh.keys.erase(mesh.keys.begin());
}

}  // namespace snell::io
