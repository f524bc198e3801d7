// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>

#include "io/mesh/test_files.h"
#include "util/threads.h"

namespace snell::io {
namespace {

using scene::Mesh;
using scene::uvec3;
using scene::vec2;
using scene::vec3;

Mesh Cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back(vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  const std::uint32_t quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& q : quads) {
    mesh.triangles.push_back(uvec3(q[0], q[1], q[2]));
    mesh.triangles.push_back(uvec3(q[0], q[2], q[3]));
  }
  return mesh;
}

// A unit sphere with poles on the y axis, `n` faces from pole to pole and twice as many around it; with
// a seam where uvs begin and end if they are wanted.
Mesh SphereMesh(int n, bool uvs) {
  Mesh mesh;
  const int columns = 2 * n, stride = uvs ? columns + 1 : columns;
  const double pi = std::numbers::pi;
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column < stride; ++column) {
      const double theta = pi * row / n, phi = 2 * pi * (column % columns) / columns;
      const bool pole = row == 0 || row == n;
      const double radius = pole ? 0 : std::sin(theta);
      mesh.positions.push_back(
          vec3(radius * std::cos(phi), std::cos(theta), -radius * std::sin(phi)));
      if (uvs) mesh.uvs.push_back(vec2(float(column) / float(columns), float(row) / float(n)));
    }
  }
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int next = uvs ? column + 1 : (column + 1) % columns;
      const std::uint32_t a = std::uint32_t(row * stride + column);
      const std::uint32_t b = std::uint32_t((row + 1) * stride + column);
      const std::uint32_t c = std::uint32_t((row + 1) * stride + next);
      const std::uint32_t d = std::uint32_t(row * stride + next);
      if (row + 1 < n) mesh.triangles.push_back(uvec3(a, b, c));
      if (row > 0) mesh.triangles.push_back(uvec3(a, c, d));
    }
  }
  return mesh;
}

// The largest angle between a vertex's normal and its position, degrees.
double LargestDeviation(const Mesh& mesh) {
  double largest = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double cosine = double(glm::dot(glm::normalize(mesh.positions[i]), mesh.normals[i]));
    largest = std::max(largest, std::acos(std::min(cosine, 1.0)));
  }
  return largest * 180 / std::numbers::pi;
}

TEST(MeshNormals, CubeHasEdgesOrNot) {
  Mesh sharp = Cube();
  SmoothNormals(sharp, 30);
  EXPECT_TRUE(IsSound(sharp));
  ASSERT_EQ(sharp.normals.size(), 24u);
  for (const uvec3& t : sharp.triangles) {
    const vec3 n = glm::cross(sharp.positions[t.y] - sharp.positions[t.x],
                              sharp.positions[t.z] - sharp.positions[t.x]);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(sharp.normals[t[k]], glm::normalize(n));
  }

  // Each corner's three faces weigh the same, whether they are one triangle there or two
  for (const float crease : {90.0f, 100.0f, 180.0f, 1e9f}) {
    Mesh round = Cube();
    SmoothNormals(round, crease);
    ASSERT_EQ(round.normals.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
      const vec3 diagonal = glm::normalize(round.positions[i] - vec3(0.5f));
      EXPECT_LT(glm::length(round.normals[i] - diagonal), 1e-6f);
    }
  }
}

TEST(MeshNormals, ZeroIsFlat) {
  for (const float crease : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    Mesh mesh = Cube();
    mesh.normals.assign(8, vec3(0, 1, 0));
    SmoothNormals(mesh, crease);
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_EQ(mesh.positions.size(), 8u);
  }
}

TEST(MeshNormals, SphereIsRound) {
  for (const bool uvs : {false, true}) {
    Mesh mesh = SphereMesh(64, uvs);
    SmoothNormals(mesh, 20);
    EXPECT_TRUE(IsSound(mesh));
    EXPECT_EQ(mesh.uvs.size(), uvs ? mesh.positions.size() : 0);
    EXPECT_LT(LargestDeviation(mesh), 0.1);
  }
}

TEST(MeshNormals, SeamsDoNotShow) {
  Mesh mesh = SphereMesh(16, true);
  const std::size_t before = mesh.positions.size();
  SmoothNormals(mesh, 60);

  // Vertices stay split by their uvs only; the two unused ones at the poles' ends are gone
  EXPECT_EQ(mesh.positions.size(), before - 2);
  std::set<std::tuple<float, float, float>> places, normals;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const vec3 p = mesh.positions[i] + 0.0f, n = mesh.normals[i];
    places.insert({p.x, p.y, p.z});
    normals.insert({n.x, n.y, n.z});
  }
  EXPECT_EQ(normals.size(), places.size());
}

TEST(MeshNormals, ExactlyTheFacesWithinTheAngleCount) {
  // Three walls like an open book, turned by 30° each around the z axis
  Mesh mesh;
  mesh.positions = {vec3(0, 0, 0), vec3(0, 0, 1)};
  for (int i = 0; i < 3; ++i) {
    const double angle = i * std::numbers::pi / 6;
    mesh.positions.push_back(vec3(std::cos(angle), std::sin(angle), 0));
    mesh.triangles.push_back(uvec3(0, std::uint32_t(2 + i), 1));
  }
  Mesh narrow = mesh;
  SmoothNormals(narrow, 29);
  EXPECT_EQ(narrow.positions.size(), 9u);

  // The middle one sees both others, each of these only the middle
  SmoothNormals(mesh, 31);
  ASSERT_EQ(mesh.positions.size(), 9u);
  const double pi = std::numbers::pi;
  for (int i = 0; i < 3; ++i) {
    const double angle = (i == 0 ? 15 : i == 1 ? 30 : 45) * pi / 180;
    const vec3 expected(std::sin(angle), -std::cos(angle), 0);
    EXPECT_LT(glm::length(mesh.normals[mesh.triangles[std::size_t(i)].x] - expected), 1e-6f);
  }
}

TEST(MeshNormals, DegenerateTrianglesAreHarmless) {
  Mesh mesh = Cube();
  mesh.positions.push_back(vec3(0.5f, 0, 0));
  mesh.positions.push_back(vec3(5, 5, 5));  // used by a triangle without area alone
  for (const uvec3 t : {uvec3(0, 8, 1), uvec3(0, 0, 1), uvec3(3, 3, 3), uvec3(9, 9, 9)})
    mesh.triangles.push_back(t);
  SmoothNormals(mesh, 100);
  EXPECT_TRUE(IsSound(mesh));
  EXPECT_EQ(mesh.positions.size(), 10u);
}

TEST(MeshNormals, BackToBackFacesDoNotCancel) {
  Mesh mesh;
  mesh.positions = {vec3(0), vec3(1, 0, 0), vec3(0, 1, 0)};
  mesh.triangles = {uvec3(0, 1, 2), uvec3(0, 2, 1)};
  SmoothNormals(mesh, 180);
  EXPECT_TRUE(IsSound(mesh));
}

TEST(MeshNormals, ThreadsDoNotMatter) {
  Mesh one = SphereMesh(200, true), many = one;
  {
    const ThreadLimit limit(1);
    SmoothNormals(one, 1.3f);
  }
  SmoothNormals(many, 1.3f);
  EXPECT_EQ(one.positions, many.positions);
  EXPECT_EQ(one.normals, many.normals);
  EXPECT_EQ(one.triangles, many.triangles);
}

TEST(MeshNormals, LargeFansTakeLinearTime) {
  // A cone of 300,000 faces: comparing all with all would take minutes
  constexpr std::uint32_t Faces = 300000;
  for (const bool soup : {false, true}) {
    Mesh mesh;
    const auto rim = [](std::uint32_t i) {
      const double angle = 2 * std::numbers::pi * (i % Faces) / Faces;
      return vec3(std::cos(angle), 0, -std::sin(angle));
    };
    mesh.positions.push_back(vec3(0, 1, 0));
    for (std::uint32_t i = 0; i < Faces; ++i) {
      if (soup) {
        const std::uint32_t first = std::uint32_t(mesh.positions.size());
        for (const vec3& p : {vec3(0, 1, 0), rim(i), rim(i + 1)}) mesh.positions.push_back(p);
        mesh.triangles.push_back(uvec3(first, first + 1, first + 2));
      } else {
        mesh.positions.push_back(rim(i));
        mesh.triangles.push_back(uvec3(0, i + 1, (i + 1) % Faces + 1));
      }
    }
    SmoothNormals(mesh, 40);
    EXPECT_TRUE(IsSound(mesh));

    // At the rim normals are the cone's own; at the tip they lean out by no more than those
    for (const uvec3& t : mesh.triangles) {
      const vec3 p = mesh.positions[t.y];
      const vec3 expected = glm::normalize(vec3(p.x, 1, p.z));
      ASSERT_LT(glm::length(mesh.normals[t.y] - expected), 1e-2f);  // edges of 2e-5
      ASSERT_GT(glm::dot(mesh.normals[t.x], expected), 0.9f);
      ASSERT_GT(mesh.normals[t.x].y, expected.y);
    }
  }
}

TEST(MeshNormals, CompletesOnlyWhatIsMissing) {
  Mesh mesh = Cube();
  mesh.normals.assign(8, vec3(0, 0, 1));
  CompleteNormals(mesh, 40);
  EXPECT_EQ(mesh.normals.size(), 8u);

  mesh.normals[0] = vec3(0.0f);
  CompleteNormals(mesh, 0);
  EXPECT_TRUE(IsSound(mesh));
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_NEAR(Volume(mesh), 1, 1e-12);
  for (const uvec3& t : mesh.triangles) {
    const bool given = mesh.positions[t.x] != vec3(0.0f) && mesh.positions[t.y] != vec3(0.0f) &&
                       mesh.positions[t.z] != vec3(0.0f);
    const vec3 flat = glm::normalize(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                                mesh.positions[t.z] - mesh.positions[t.x]));
    EXPECT_EQ(mesh.normals[t.x], given ? vec3(0, 0, 1) : flat);
  }

  mesh.normals.assign(mesh.positions.size(), vec3(0.0f));
  CompleteNormals(mesh, 40);
  EXPECT_TRUE(mesh.normals.empty());
}

}  // namespace
}  // namespace snell::io
