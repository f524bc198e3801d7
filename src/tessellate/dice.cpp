// SPDX-License-Identifier: Apache-2.0
#include "tessellate/dice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <vector>

#include "util/index_table.h"

namespace snell::tessellate {
namespace {

using scene::Mesh;
using scene::uvec3;
using scene::vec3;

// Halvings of an edge: beyond, floats cannot tell its parts apart.
constexpr int MostRounds = 20;

// Which sides of the triangles are too long: bit k for the one from corner k to the next.
std::vector<std::uint8_t> FindLongSides(const Mesh& mesh, const Measure& measure,
                                        const scene::EdgeTarget& target) {
  std::vector<std::uint8_t> isLong(mesh.triangles.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, isLong.size(), 1024), [&](const auto& part) {
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      const uvec3 t = mesh.triangles[i];
      for (int k = 0; k < 3; ++k) {
        const vec3 &a = mesh.positions[t[k]], &b = mesh.positions[t[(k + 1) % 3]];
        const vec3 middle = (a + b) * 0.5f;
        // What is not finite, or as short as rounding, stays whole
        if (measure.Excess(a, b, target) > 1 && middle != a && middle != b)
          isLong[i] = std::uint8_t(isLong[i] | 1 << k);
      }
    }
  });
  return isLong;
}

// Halves sides; vertices in the middle are made once for each pair of ends.
class Halver {
 public:
  Halver(Mesh& mesh, std::size_t expected)
      : mesh_(mesh), first_(mesh.positions.size()), table_(expected) {}

  std::uint32_t Middle(std::uint32_t a, std::uint32_t b) {
    const std::array<std::uint32_t, 2> ends = {std::min(a, b), std::max(a, b)};
    const auto next = std::uint32_t(ends_.size());
    const std::uint32_t found =
        table_.FindOrAdd(HashOf(ends[0], ends[1], 0), next,
                         [&](std::uint32_t other) { return ends_[other] == ends; });
    if (found == next) ends_.push_back(ends);
    return std::uint32_t(first_ + found);
  }

  // Give the new vertices all that they have.
  void AddVertices() {
    const auto add = [&](auto& values) {
      if (values.empty()) return;
      values.reserve(first_ + ends_.size());
      for (const auto& [a, b] : ends_) values.push_back((values[a] + values[b]) * 0.5f);
    };
    add(mesh_.positions);
    add(mesh_.normals);
    add(mesh_.uvs);
    add(mesh_.uvs1);
    add(mesh_.colors);
    if (mesh_.normals.empty()) return;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      vec3& n = mesh_.normals[first_ + i];
      const float length = glm::length(n);
      n = length > 0 ? n / length : mesh_.normals[ends_[i][0]];
    }
  }

 private:
  Mesh& mesh_;
  std::size_t first_;
  IndexTable table_;
  std::vector<std::array<std::uint32_t, 2>> ends_;
};

// Cut one triangle at its long sides.
void Cut(const Mesh& mesh, const uvec3& t, unsigned isLong, Halver& halver,
         std::vector<uvec3>& triangles) {
  // Turn it so that its first side is long, and of two long ones the last is not
  const int first = isLong == 7                  ? 0
                    : isLong == 1 || isLong == 3 ? 0
                    : isLong == 2 || isLong == 6 ? 1
                                                 : 2;
  const std::uint32_t a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3];
  const std::uint32_t ab = halver.Middle(a, b);
  if (std::popcount(isLong) == 1) {
    triangles.insert(triangles.end(), {uvec3(a, ab, c), uvec3(ab, b, c)});
    return;
  }
  const std::uint32_t bc = halver.Middle(b, c);
  triangles.emplace_back(ab, b, bc);
  if (std::popcount(isLong) == 3) {
    const std::uint32_t ca = halver.Middle(c, a);
    triangles.insert(triangles.end(), {uvec3(a, ab, ca), uvec3(ca, bc, c), uvec3(ab, bc, ca)});
    return;
  }
  // The quadrilateral that is left, along its shorter diagonal
  const vec3 &pa = mesh.positions[a], &pb = mesh.positions[b], &pc = mesh.positions[c];
  if (glm::length((pa + pb) * 0.5f - pc) < glm::length((pb + pc) * 0.5f - pa)) {
    triangles.insert(triangles.end(), {uvec3(a, ab, c), uvec3(ab, bc, c)});
  } else {
    triangles.insert(triangles.end(), {uvec3(a, ab, bc), uvec3(a, bc, c)});
  }
}

}  // namespace

bool Dice(Mesh& mesh, const Measure& measure, const scene::EdgeTarget& target,
          std::uint64_t mostTriangles) {
  mesh.tangents.clear();
  mesh.joins.clear();
  for (int round = 0; round < MostRounds; ++round) {
    const std::vector<std::uint8_t> isLong = FindLongSides(mesh, measure, target);
    std::uint64_t more = 0;
    for (const std::uint8_t sides : isLong) more += std::uint64_t(std::popcount(sides));
    if (more == 0) return true;
    if (mesh.triangles.size() + more > mostTriangles) return false;

    Halver halver(mesh, more * 3 / 4);
    std::vector<uvec3> triangles;
    triangles.reserve(mesh.triangles.size() + more);
    for (std::size_t i = 0; i < isLong.size(); ++i) {
      if (isLong[i] == 0)
        triangles.push_back(mesh.triangles[i]);
      else
        Cut(mesh, mesh.triangles[i], isLong[i], halver, triangles);
    }
    halver.AddVertices();
    mesh.triangles = std::move(triangles);
  }
  return true;
}

}  // namespace snell::tessellate
