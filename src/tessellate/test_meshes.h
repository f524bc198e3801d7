// SPDX-License-Identifier: Apache-2.0
//
// Meshes for the tests of this room, and whether meshes are closed.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "scene/places.h"
#include "scene/scene.h"

namespace snell::tessellate {

using scene::Mesh;
using scene::uvec3;
using scene::vec2;
using scene::vec3;

// [−1, 1]³ of six quadrilaterals, each with vertices, a normal and uvs from 0 to 1 of its own.
inline Mesh Cube() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      vec3 n(0.0f), u(0.0f), v(0.0f);
      n[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1;
      const auto first = unsigned(mesh.positions.size());
      for (const vec2 at : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)}) {
        mesh.positions.push_back(n + u * (2 * at.x - 1) + v * (2 * at.y - 1));
        mesh.normals.push_back(n);
        mesh.uvs.push_back(at);
      }
      mesh.triangles.insert(mesh.triangles.end(), {uvec3(0, 1, 2) + first, uvec3(0, 2, 3) + first});
      mesh.joins.insert(mesh.joins.end(), {false, true});
    }
  }
  return mesh;
}

// The unit sphere of `rows` bands, smooth, with a seam where u falls from 1 to 0.
inline Mesh UvSphere(int rows) {
  Mesh mesh;
  const int columns = 2 * rows;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double theta = std::numbers::pi * row / rows;
      const double phi = 2 * std::numbers::pi * (column % columns) / columns;
      const double ring = row == 0 || row == rows ? 0 : std::sin(theta);
      const vec3 p(float(ring * std::cos(phi)), float(std::cos(theta)),
                   float(-ring * std::sin(phi)));
      mesh.positions.push_back(p);
      mesh.normals.push_back(p);
      mesh.uvs.emplace_back(float(column) / float(columns), 1 - float(row) / float(rows));
      if (row == rows || column == columns) continue;
      const auto a = unsigned(row * (columns + 1) + column), b = a + unsigned(columns) + 1;
      if (row > 0) mesh.triangles.emplace_back(a, b, a + 1);
      if (row + 1 < rows) mesh.triangles.emplace_back(a + 1, b, b + 1);
    }
  }
  return mesh;
}

// Sides of triangles that no other one runs along in the other direction, by position.
inline int OpenSides(const Mesh& mesh) {
  const auto places = scene::FindPlaces(mesh.positions);
  std::map<std::pair<unsigned, unsigned>, int> sides;
  for (const uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++sides[{places[t[k]], places[t[(k + 1) % 3]]}];
  int open = 0;
  for (const auto& [side, count] : sides) {
    const auto back = sides.find({side.second, side.first});
    if (count != 1 || back == sides.end() || back->second != 1) ++open;
  }
  return open;
}

inline float LongestSide(const Mesh& mesh) {
  float longest = 0;
  for (const uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      longest =
          std::max(longest, glm::length(mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]));
  return longest;
}

}  // namespace snell::tessellate
