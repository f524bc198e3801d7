// SPDX-License-Identifier: Apache-2.0
#include "tessellate/subdivide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tessellate/cage.h"
#include "tessellate/test_meshes.h"

namespace snell::tessellate {
namespace {

using scene::Subdivision;
using scene::SubdivisionScheme;

constexpr Subdivision CatmullClark{SubdivisionScheme::CatmullClark};
constexpr Subdivision Loop{SubdivisionScheme::Loop};

// The normal at the vertex that lies at p; zero if none does.
vec3 NormalAt(const Mesh& mesh, const vec3& p) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (glm::length(mesh.positions[i] - p) < 1e-5f) return mesh.normals[i];
  return vec3(0.0f);
}

TEST(Cage, JoinsTrianglesAndSeams) {
  const Cage cage = MakeCage(Cube(), false);
  EXPECT_EQ(cage.positions.size(), 8u);
  EXPECT_EQ(cage.sizes, std::vector<int>(6, 4));
  EXPECT_EQ(MakeCage(Cube(), true).sizes, std::vector<int>(12, 3));
}

TEST(Cage, LeavesOutFacesThatMeetAPlaceTwice) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {1, 4, 2}};
  EXPECT_EQ(MakeCage(mesh, false).sizes.size(), 2u);
  // Three triangles that are said to be one polygon and overlap
  mesh.triangles = {{0, 1, 2}, {0, 1, 4}, {0, 1, 2}};
  mesh.joins = {false, true, true};
  EXPECT_EQ(MakeCage(mesh, false).sizes, std::vector<int>(3, 3));
}

TEST(Subdivide, CubeHasTheKnownLimit) {
  // Halstead, Kass and DeRose 1993: (n² v + 4 Σ e + Σ f) / (n (n + 5))
  const float face = (16 + 4 * 3.0f + 4 * 5 / 9.0f) / 36;
  for (const int levels : {0, 1, 3}) {
    Mesh mesh = Cube();
    ASSERT_TRUE(Subdivide(mesh, CatmullClark, levels));
    EXPECT_EQ(mesh.triangles.size(), SubdividedTriangles(Cube(), CatmullClark, levels));
    EXPECT_EQ(OpenSides(mesh), 0);
    const vec3 corner = NormalAt(mesh, vec3(0.5f));
    EXPECT_LT(glm::length(corner - glm::normalize(vec3(1.0f))), 1e-5f) << levels;
    if (levels == 0) continue;
    EXPECT_LT(glm::length(NormalAt(mesh, vec3(0, 0, face)) - vec3(0, 0, 1)), 1e-5f);
    EXPECT_LT(glm::length(NormalAt(mesh, vec3(0, -face, 0)) - vec3(0, -1, 0)), 1e-5f);
  }
}

TEST(Subdivide, LoopHasTheKnownLimit) {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const unsigned x : {0u, 1u})
    for (const unsigned y : {2u, 3u})
      for (const unsigned z : {4u, 5u})
        mesh.triangles.push_back((x + y + z) % 2 == 0 ? uvec3(x, y, z) : uvec3(x, z, y));
  ASSERT_TRUE(Subdivide(mesh, Loop, 3));
  EXPECT_EQ(mesh.triangles.size(), 8u * 64);
  EXPECT_EQ(OpenSides(mesh), 0);
  EXPECT_LT(glm::length(NormalAt(mesh, vec3(24 / 55.0f, 0, 0)) - vec3(1, 0, 0)), 1e-5f);
}

TEST(Subdivide, CreasesStaySharp) {
  Mesh mesh = Cube();
  for (const vec3& p : Cube().positions)
    for (int axis = 0; axis < 3; ++axis) {
      vec3 q = p;
      q[axis] = -q[axis];
      mesh.creases.push_back({p, q, 10});
    }
  ASSERT_TRUE(Subdivide(mesh, CatmullClark, 2));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const vec3 n = glm::abs(mesh.normals[i]), p = glm::abs(mesh.positions[i]);
    EXPECT_NEAR(glm::max(glm::max(n.x, n.y), n.z), 1, 1e-5f);
    EXPECT_NEAR(glm::dot(mesh.positions[i], mesh.normals[i]), 1, 1e-5f);
    EXPECT_LE(glm::max(glm::max(p.x, p.y), p.z), 1 + 1e-5f);
  }
  EXPECT_EQ(OpenSides(mesh), 0);
}

TEST(Subdivide, SeamsOfUvsStay) {
  Mesh mesh = Cube();
  ASSERT_TRUE(Subdivide(mesh, CatmullClark, 2));
  ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
  // No triangle stretches from one side of the picture to the other, and each face keeps all of it
  double area = 0;
  for (const uvec3& t : mesh.triangles) {
    const vec2 a = mesh.uvs[t.y] - mesh.uvs[t.x], b = mesh.uvs[t.z] - mesh.uvs[t.x];
    EXPECT_LT(glm::length(a), 0.5f);
    EXPECT_GT(a.x * b.y - a.y * b.x, 0);
    area += double(a.x * b.y - a.y * b.x) / 2;
  }
  EXPECT_NEAR(area, 6, 1e-4);
}

TEST(Subdivide, BoundariesAreInterpolatedAsAsked) {
  Mesh quad;
  quad.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  quad.triangles = {{0, 1, 2}, {0, 2, 3}};
  quad.joins = {false, true};
  const auto reach = [&](scene::SubdivisionBoundary boundary) {
    Mesh mesh = quad;
    Subdivide(mesh, {SubdivisionScheme::CatmullClark, boundary}, 3);
    float most = 0;
    for (const vec3& p : mesh.positions) most = std::max(most, p.x + p.y);
    return most;
  };
  EXPECT_FLOAT_EQ(reach(scene::SubdivisionBoundary::EdgeAndCorner), 2);
  EXPECT_LT(reach(scene::SubdivisionBoundary::EdgeOnly), 1.5f);
  EXPECT_EQ(reach(scene::SubdivisionBoundary::None), 0);
}

TEST(Subdivide, OddMeshesDoNoHarm) {
  // Three triangles on one edge, and one that touches another in a vertex
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {5, 0, 0}, {5, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 5, 6}};
  for (const Subdivision& scheme : {CatmullClark, Loop}) {
    Mesh finer = mesh;
    ASSERT_TRUE(Subdivide(finer, scheme, 2));
    for (const vec3& n : finer.normals) EXPECT_NEAR(glm::length(n), 1, 1e-5f);
  }
  Mesh nothing;
  nothing.positions = {{0, 0, 0}};
  nothing.triangles = {{0, 0, 0}};
  EXPECT_FALSE(Subdivide(nothing, CatmullClark, 2));
}

TEST(Subdivide, AnyFacesDoNoHarm) {
  // Edges of many faces, faces over each other, vertices of many fans, polygons that are none
  std::minstd_rand random(1);
  const auto below = [&](unsigned n) { return unsigned(random()) / 16 % n; };
  for (int round = 0; round < 400; ++round) {
    Mesh mesh;
    const unsigned vertices = 3 + below(8);
    for (unsigned i = 0; i < vertices; ++i) {
      mesh.positions.emplace_back(float(below(4)), float(below(4)), float(below(4)));
      mesh.uvs.emplace_back(float(below(2)), float(below(2)));
    }
    for (unsigned i = 1 + below(12); i > 0; --i) {
      mesh.triangles.emplace_back(below(vertices), below(vertices), below(vertices));
      mesh.joins.push_back(below(2) == 0 && mesh.triangles.size() > 1);
    }
    for (unsigned i = below(4); i > 0; --i)
      mesh.creases.push_back(
          {mesh.positions[below(vertices)], mesh.positions[below(vertices)], float(below(11))});
    for (const Subdivision& scheme : {CatmullClark, Loop}) {
      Mesh finer = mesh;
      if (!Subdivide(finer, scheme, int(below(3)))) continue;
      for (const uvec3& t : finer.triangles)
        ASSERT_LT(std::max({t.x, t.y, t.z}), finer.positions.size()) << round;
      EXPECT_EQ(finer.uvs.size(), finer.positions.size());
    }
  }
}

}  // namespace
}  // namespace snell::tessellate
