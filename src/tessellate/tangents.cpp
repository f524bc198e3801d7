// SPDX-License-Identifier: Apache-2.0
#include "tessellate/tangents.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "scene/places.h"
#include "util/index_table.h"

namespace snell::tessellate {
namespace {

using glm::dvec2;
using glm::dvec3;
using scene::Mesh;
using scene::uvec3;
using scene::vec2;
using scene::vec3;
using scene::vec4;

using Index = std::uint32_t;
constexpr Index None = 0xffffffffu;

// A triangle's direction of rising u in unit length, and whether its uvs are mirrored: 1, −1, or 0 if it
// has no such direction.
struct Direction {
  vec3 along{0.0f};
  int sign = 0;
};

// What lies across v, without the part along n; in unit length, or zero.
dvec3 InPlane(const dvec3& v, const dvec3& n) {
  const dvec3 flat = v - n * glm::dot(n, v);
  const double length = glm::length(flat);
  return length > 0 ? flat / length : dvec3(0.0);
}

class TangentMaker {
 public:
  TangentMaker(Mesh& mesh, const std::vector<vec2>& uvs) : mesh_(mesh), uvs_(uvs) {}

  void Make() {
    FindDirections();
    JoinVertices();
    JoinCorners();
    const std::vector<dvec3> sums = SumDirections();
    SplitVertices(sums);
  }

 private:
  Index VertexOf(Index corner) const { return mesh_.triangles[corner / 3][int(corner % 3)]; }

  void FindDirections() {
    directions_.resize(mesh_.triangles.size());
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const uvec3 t = mesh_.triangles[i];
      const dvec3 e1 = dvec3(mesh_.positions[t.y]) - dvec3(mesh_.positions[t.x]);
      const dvec3 e2 = dvec3(mesh_.positions[t.z]) - dvec3(mesh_.positions[t.x]);
      const dvec2 d1 = dvec2(uvs_[t.y]) - dvec2(uvs_[t.x]);
      const dvec2 d2 = dvec2(uvs_[t.z]) - dvec2(uvs_[t.x]);
      const double area = d1.x * d2.y - d1.y * d2.x;
      const dvec3 along = (e1 * d2.y - e2 * d1.y) * (area < 0 ? -1.0 : 1.0);
      const dvec3 across = (e2 * d1.x - e1 * d2.x) * (area < 0 ? -1.0 : 1.0);
      const double length = glm::length(along);
      if (area == 0 || !(length > 0) || !std::isfinite(length)) continue;
      const dvec3 normal =
          dvec3(mesh_.normals[t.x]) + dvec3(mesh_.normals[t.y]) + dvec3(mesh_.normals[t.z]);
      directions_[i].along = vec3(along / length);
      directions_[i].sign = glm::dot(glm::cross(normal, along), across) < 0 ? -1 : 1;
    }
  }

  // Vertices that agree in position, normal and uv count as one.
  void JoinVertices() {
    joined_.resize(mesh_.positions.size());
    IndexTable table(joined_.size());
    for (Index i = 0; i < joined_.size(); ++i) {
      const uvec3 p = scene::PositionBits(mesh_.positions[i]);
      const uvec3 n = scene::PositionBits(mesh_.normals[i]);
      const uvec3 uv = scene::PositionBits(vec3(uvs_[i], 0));
      const std::uint64_t hash =
          MixBits(HashOf(p.x, p.y, p.z) + HashOf(n.x, n.y, n.z)) + HashOf(uv.x, uv.y, 1);
      joined_[i] = table.FindOrAdd(MixBits(hash), i, [&](Index other) {
        return scene::PositionBits(mesh_.positions[other]) == p &&
               scene::PositionBits(mesh_.normals[other]) == n &&
               scene::PositionBits(vec3(uvs_[other], 0)) == uv;
      });
    }
  }

  Index Root(Index corner) {
    while (rootOf_[corner] != corner) corner = rootOf_[corner] = rootOf_[rootOf_[corner]];
    return corner;
  }

  // Corners at a vertex are one if edges lead from triangle to triangle between them, none of which mirrors
  // the uvs.
  void JoinCorners() {
    rootOf_.resize(mesh_.triangles.size() * 3);
    std::iota(rootOf_.begin(), rootOf_.end(), Index(0));
    const auto from = [&](Index side) { return joined_[VertexOf(side)]; };
    const auto next = [](Index side) { return side % 3 == 2 ? side - 2 : side + 1; };
    IndexTable table(rootOf_.size());
    const auto unite = [&](Index a, Index b) {
      a = Root(a);
      b = Root(b);
      rootOf_[std::max(a, b)] = std::min(a, b);
    };
    // A side is known by its first corner
    for (Index side = 0; side < rootOf_.size(); ++side) {
      const Index a = from(side), b = from(next(side));
      table.FindOrAdd(HashOf(a, b, 0), side,
                      [&](Index other) { return from(other) == a && from(next(other)) == b; });
    }
    for (Index side = 0; side < rootOf_.size(); ++side) {
      const Index a = from(side), b = from(next(side));
      const Index other = table.FindOrAdd(HashOf(b, a, 0), None, [&](Index candidate) {
        return from(candidate) == b && from(next(candidate)) == a;
      });
      if (other == None || directions_[side / 3].sign == 0 ||
          directions_[side / 3].sign != directions_[other / 3].sign)
        continue;
      unite(side, next(other));
      unite(next(side), other);
    }
  }

  // The tangents, not of unit length yet, at the roots of corners.
  std::vector<dvec3> SumDirections() {
    std::vector<dvec3> sums(rootOf_.size(), dvec3(0.0));
    for (Index corner = 0; corner < rootOf_.size(); ++corner) {
      const Direction& direction = directions_[corner / 3];
      if (direction.sign == 0) continue;
      const uvec3 t = mesh_.triangles[corner / 3];
      const int k = int(corner % 3);
      const dvec3 n(mesh_.normals[t[k]]), p(mesh_.positions[t[k]]);
      const dvec3 a = InPlane(dvec3(mesh_.positions[t[(k + 1) % 3]]) - p, n);
      const dvec3 b = InPlane(dvec3(mesh_.positions[t[(k + 2) % 3]]) - p, n);
      const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
      sums[Root(corner)] += InPlane(dvec3(direction.along), n) * angle;
    }
    return sums;
  }

  // One vertex for each group of corners. Triangles without a direction take any that is there.
  void SplitVertices(const std::vector<dvec3>& sums) {
    std::vector<Index> groupOf(mesh_.positions.size(), None);
    std::vector<std::pair<Index, Index>> extra;  // further groups of a vertex, and their vertices
    const Index first = Index(mesh_.positions.size());
    IndexTable table(16);
    mesh_.tangents.assign(first, vec4(0.0f));
    for (const bool directed : {true, false}) {
      for (Index corner = 0; corner < rootOf_.size(); ++corner) {
        if ((directions_[corner / 3].sign != 0) != directed) continue;
        Index& vertex = mesh_.triangles[corner / 3][int(corner % 3)];
        const Index root = Root(corner), source = vertex;
        if (groupOf[source] == None) {
          groupOf[source] = root;
          mesh_.tangents[source] = TangentOf(source, sums[root], directions_[root / 3].sign);
        }
        if (groupOf[source] == root || !directed) continue;
        const Index next = Index(extra.size());
        const std::pair key(source, root);
        const Index found = table.FindOrAdd(HashOf(source, root, 0), next,
                                            [&](Index other) { return extra[other] == key; });
        if (found == next) {
          extra.push_back(key);
          mesh_.tangents.push_back(TangentOf(source, sums[root], directions_[root / 3].sign));
        }
        vertex = first + found;
      }
    }
    const auto copy = [&](auto& values) {
      if (values.empty()) return;
      values.reserve(first + extra.size());
      for (const auto& [source, root] : extra) values.push_back(values[source]);
    };
    copy(mesh_.positions);
    copy(mesh_.normals);
    copy(mesh_.uvs);
    copy(mesh_.uvs1);
    copy(mesh_.colors);
  }

  vec4 TangentOf(Index vertex, const dvec3& sum, int sign) const {
    const dvec3 n(mesh_.normals[vertex]);
    dvec3 tangent = InPlane(sum, n);
    if (tangent == dvec3(0.0))
      tangent = InPlane(std::abs(n.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), n);
    return vec4(vec3(tangent), sign < 0 ? -1.0f : 1.0f);
  }

  Mesh& mesh_;
  const std::vector<vec2>& uvs_;
  std::vector<Direction> directions_;  // of triangles
  std::vector<Index> joined_;          // the first vertex that agrees with each
  std::vector<Index> rootOf_;          // of corners: sets of those that share a tangent
};

}  // namespace

void MakeTangents(Mesh& mesh, int uvSet) {
  // A copy, for vertices are added meanwhile
  const std::vector<vec2> uvs = uvSet == 1 && !mesh.uvs1.empty() ? mesh.uvs1 : mesh.uvs;
  if (!uvs.empty() && !mesh.normals.empty()) TangentMaker(mesh, uvs).Make();
}

}  // namespace snell::tessellate
