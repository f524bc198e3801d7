// SPDX-License-Identifier: Apache-2.0
//
// Small closed meshes around the origin, of size about one: what watertightness is tried on. Triangles are
// wound counter-clockwise seen from outside.
#pragma once

#include <glm/mat4x4.hpp>
#include <map>
#include <utility>
#include <vector>

#include "kernel/math.h"
#include "support/random.h"

namespace snell::test {

using kernel::uvec3;
using kernel::vec3;

struct TriangleMesh {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;
};

// An icosahedron whose faces are divided into four `levels` times, on the unit sphere.
inline TriangleMesh Icosphere(int levels) {
  TriangleMesh mesh;
  const float g = 1.618033989f;
  for (const vec3 p : {vec3(-1, g, 0), vec3(1, g, 0), vec3(-1, -g, 0), vec3(1, -g, 0),
                       vec3(0, -1, g), vec3(0, 1, g), vec3(0, -1, -g), vec3(0, 1, -g),
                       vec3(g, 0, -1), vec3(g, 0, 1), vec3(-g, 0, -1), vec3(-g, 0, 1)})
    mesh.positions.push_back(kernel::Normalize(p));
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<unsigned, unsigned>, unsigned> middles;
    const auto middle = [&](unsigned a, unsigned b) {
      const auto [entry, isNew] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, unsigned(mesh.positions.size()));
      if (isNew) mesh.positions.push_back(kernel::Normalize(mesh.positions[a] + mesh.positions[b]));
      return entry->second;
    };
    std::vector<uvec3> finer;
    for (const uvec3 t : mesh.triangles) {
      const unsigned a = middle(t.x, t.y), b = middle(t.y, t.z), c = middle(t.z, t.x);
      finer.insert(finer.end(), {{t.x, a, c}, {t.y, b, a}, {t.z, c, b}, {a, b, c}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

// The cube [−1, 1]³ of twelve triangles.
inline TriangleMesh Cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

// Two apexes over a ring of corners at uneven angles, the smallest about `least` times the largest: many
// triangles share one vertex. A small `height` makes a lens, a large one a needle; close corners make
// slivers.
inline TriangleMesh Bipyramid(Random& random, unsigned corners, double height, double least) {
  TriangleMesh mesh;
  std::vector<double> angles(corners);
  double sum = 0;
  for (double& angle : angles) sum += angle = random.LogUniform(least, 1);
  double at = 0;
  for (const double angle : angles) {
    mesh.positions.push_back(vec3(float(std::cos(at)), 0, float(-std::sin(at))));
    at += angle * 6.283185307179586 / sum;
  }
  mesh.positions.push_back(vec3(float(random.Uniform(-0.1, 0.1)), float(height), 0));
  mesh.positions.push_back(vec3(0, float(-height), float(random.Uniform(-0.1, 0.1))));
  for (unsigned i = 0; i < corners; ++i) {
    const unsigned next = (i + 1) % corners;
    mesh.triangles.push_back({i, next, corners});
    mesh.triangles.push_back({next, i, corners + 1});
  }
  return mesh;
}

// The square [−1, 1]² at y = 0 as a grid of 2·cells² triangles.
inline TriangleMesh Grid(unsigned cells) {
  TriangleMesh mesh;
  for (unsigned z = 0; z <= cells; ++z) {
    for (unsigned x = 0; x <= cells; ++x) {
      mesh.positions.push_back(
          vec3(2 * float(x) / float(cells) - 1, 0, 2 * float(z) / float(cells) - 1));
      if (x == cells || z == cells) continue;
      const unsigned corner = z * (cells + 1) + x, below = corner + cells + 1;
      mesh.triangles.push_back({corner, below, corner + 1});
      mesh.triangles.push_back({corner + 1, below, below + 1});
    }
  }
  return mesh;
}

// A point of a triangle: a corner, on an edge, or inside.
inline glm::dvec3 PointOn(Random& random, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  switch (random.Index(4)) {
    case 0: return a;
    case 1: return a + (b - a) * random.Uniform();
    case 2: return a + (b - a) * 0.5;
  }
  const double u = random.Uniform(), v = random.Uniform();
  return u + v < 1 ? a + (b - a) * u + (c - a) * v : a + (b - a) * (1 - u) + (c - a) * (1 - v);
}

// A point on the surface of the rounded mesh.
inline glm::dvec3 PointOn(Random& random, const TriangleMesh& mesh) {
  const uvec3 t = mesh.triangles[random.Index(unsigned(mesh.triangles.size()))];
  return PointOn(random, glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
                 glm::dvec3(mesh.positions[t.z]));
}

// The mesh scaled, turned and moved; the corners are rounded, so neighbours still share them.
inline TriangleMesh Placed(TriangleMesh mesh, const glm::dmat4& map) {
  for (vec3& p : mesh.positions) p = vec3(glm::dvec3(map * glm::dvec4(glm::dvec3(p), 1)));
  return mesh;
}

}  // namespace snell::test
