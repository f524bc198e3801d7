// SPDX-License-Identifier: Apache-2.0
#include "tessellate/displace.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/places.h"

namespace snell::tessellate {
namespace {

using glm::dvec3;
using scene::Mesh;
using scene::uvec3;
using scene::vec2;
using scene::vec3;

constexpr std::uint32_t None = 0xffffffffu;
// Normals at one place that are told apart; cosine between those that are one.
constexpr int MostGroups = 16;
constexpr float SameNormal = 0.999f;

// What a corner adds to the normal at its vertex: exact for spheres (Max 1999, "Weights for computing vertex
// normals from facet normals").
dvec3 CornerNormal(const Mesh& mesh, const uvec3& t, int k) {
  const dvec3 p(mesh.positions[t[k]]);
  const dvec3 a = dvec3(mesh.positions[t[(k + 1) % 3]]) - p;
  const dvec3 b = dvec3(mesh.positions[t[(k + 2) % 3]]) - p;
  const double size = glm::dot(a, a) * glm::dot(b, b);
  return size > 0 ? glm::cross(a, b) / size : dvec3(0.0);
}

bool Normalize(dvec3& v) {
  const double length = glm::length(v);
  if (!(length > 0) || !std::isfinite(length)) return false;
  v /= length;
  return true;
}

class Displacer {
 public:
  Displacer(Mesh& mesh, const Measure& measure)
      : mesh_(mesh), measure_(measure), places_(scene::FindPlaces(mesh.positions)) {}

  void Displace(int uvSet, const Height& height) {
    FindBaseNormals();
    FindSides();
    GroupVertices();
    Move(FindHeights(uvSet, height));
    SumNormals();
    for (std::size_t i = 0; i < mesh_.normals.size(); ++i) {
      dvec3 n = sums_[groups_[i]];
      if (Normalize(n)) mesh_.normals[i] = vec3(n);
    }
  }

 private:
  // Sum the corners' normals over groups of vertices.
  void SumNormals() {
    sums_.assign(mesh_.positions.size(), dvec3(0.0));
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const dvec3 n = CornerNormal(mesh_, mesh_.triangles[i], k);
        sums_[groups_[mesh_.triangles[i][k]]] += isTurned_[i] ? -n : n;
      }
    }
  }

  // Flat meshes move along the normals that they would have if they were smooth.
  void FindBaseNormals() {
    if (!mesh_.normals.empty()) return;
    groups_ = places_;
    isTurned_.assign(mesh_.triangles.size(), false);
    SumNormals();
    mesh_.normals.resize(mesh_.positions.size());
    for (std::size_t i = 0; i < mesh_.normals.size(); ++i) {
      dvec3 n = sums_[places_[i]];
      mesh_.normals[i] = Normalize(n) ? vec3(n) : vec3(0.0f);
    }
  }

  // Where normals point the other way than the winding does, they keep doing so.
  void FindSides() {
    isTurned_.assign(mesh_.triangles.size(), false);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const uvec3 t = mesh_.triangles[i];
      const vec3 mean = mesh_.normals[t.x] + mesh_.normals[t.y] + mesh_.normals[t.z];
      isTurned_[i] = glm::dot(CornerNormal(mesh_, t, 0), dvec3(mean)) < 0;
    }
  }

  // Vertices of one place and normal are a group, named after its first one.
  void GroupVertices() {
    const std::size_t count = mesh_.positions.size();
    groups_.resize(count);
    std::vector<std::uint32_t> next(count, None);
    for (std::uint32_t i = 0; i < count; ++i) {
      std::uint32_t group = places_[i];
      for (int tried = 1; glm::dot(mesh_.normals[group], mesh_.normals[i]) < SameNormal; ++tried) {
        if (group == i || tried == MostGroups) break;
        if (next[group] == None) next[group] = i;
        group = next[group];
      }
      groups_[i] = group;
    }
  }

  std::vector<float> FindHeights(int uvSet, const Height& height) {
    // Average each vertex's height over the mean length of its edges
    const std::vector<vec2>& uvs = uvSet == 1 && !mesh_.uvs1.empty() ? mesh_.uvs1 : mesh_.uvs;
    std::vector<float> widths(mesh_.positions.size(), 0.0f);
    std::vector<std::uint32_t> counts(widths.size(), 0);
    for (const uvec3& t : mesh_.triangles) {
      for (int k = 0; k < 3 && !uvs.empty(); ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        const float length = glm::length(uvs[a] - uvs[b]);
        for (const std::uint32_t v : {a, b}) {
          widths[v] += length;
          ++counts[v];
        }
      }
    }
    std::vector<float> heights(widths.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, heights.size(), 1024),
                      [&](const auto& part) {
                        for (std::size_t i = part.begin(); i < part.end(); ++i) {
                          const float h = height(i, widths[i] / float(std::max(counts[i], 1u)));
                          heights[i] = std::isfinite(h) ? h : 0;
                        }
                      });
    return heights;
  }

  void Move(const std::vector<float>& heights) {
    struct Sum {
      dvec3 normal{0.0};
      double height = 0;
      int count = 0;
    };
    std::vector<Sum> sums(mesh_.positions.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
      Sum& sum = sums[places_[i]];
      if (groups_[i] == i) sum.normal += dvec3(mesh_.normals[i]);
      sum.height += double(heights[i]);
      ++sum.count;
    }
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const Sum& sum = sums[places_[i]];
      dvec3 normal = sum.normal;
      double height = sum.height / sum.count;
      // Sheets that lie back to back part
      if (glm::length(normal) < 1e-3) {
        normal = dvec3(mesh_.normals[i]);
        height = double(heights[i]);
      }
      const dvec3 moved = dvec3(mesh_.positions[i]) + measure_.AlongNormal(normal) * height;
      mesh_.positions[i] = vec3(moved);
    }
  }

  Mesh& mesh_;
  const Measure& measure_;
  std::vector<std::uint32_t> places_;
  std::vector<std::uint32_t> groups_;  // of each vertex
  std::vector<bool> isTurned_;         // of each triangle
  std::vector<dvec3> sums_;            // of normals, for groups
};

}  // namespace

void Displace(Mesh& mesh, const Measure& measure, int uvSet, const Height& height) {
  Displacer(mesh, measure).Displace(uvSet, height);
  mesh.tangents.clear();
}

}  // namespace snell::tessellate
