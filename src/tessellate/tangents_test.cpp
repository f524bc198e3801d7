// SPDX-License-Identifier: Apache-2.0
#include "tessellate/tangents.h"

#include <gtest/gtest.h>

#include "tessellate/test_meshes.h"

namespace snell::tessellate {
namespace {

using scene::vec4;

Mesh Quad() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  mesh.normals.assign(4, vec3(0, 0, 1));
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Tangents, PointToRisingU) {
  Mesh mesh = Quad();
  MakeTangents(mesh, 0);
  EXPECT_EQ(mesh.tangents, std::vector<vec4>(4, vec4(1, 0, 0, 1)));

  mesh = Quad();
  for (vec2& uv : mesh.uvs) uv = {1 - uv.x, uv.y};
  MakeTangents(mesh, 0);
  EXPECT_EQ(mesh.tangents, std::vector<vec4>(4, vec4(-1, 0, 0, -1)));

  // By the second set: turned by a quarter
  mesh = Quad();
  for (const vec2& uv : mesh.uvs) mesh.uvs1.emplace_back(uv.y, -uv.x);
  MakeTangents(mesh, 1);
  EXPECT_EQ(mesh.tangents, std::vector<vec4>(4, vec4(0, 1, 0, 1)));
}

TEST(Tangents, PartWhereUvsAreMirrored) {
  // A second quad to the right, whose u falls again
  Mesh mesh = Quad();
  mesh.positions.insert(mesh.positions.end(), {{4, 0, 0}, {4, 2, 0}});
  mesh.normals.assign(6, vec3(0, 0, 1));
  mesh.uvs.insert(mesh.uvs.end(), {{0, 0}, {0, 1}});
  mesh.triangles.insert(mesh.triangles.end(), {{1, 4, 5}, {1, 5, 2}});
  MakeTangents(mesh, 0);
  ASSERT_EQ(mesh.positions.size(), 8u);
  ASSERT_EQ(mesh.normals.size(), 8u);
  ASSERT_EQ(mesh.uvs.size(), 8u);
  for (std::size_t i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(mesh.tangents[mesh.triangles[i][k]], i < 2 ? vec4(1, 0, 0, 1) : vec4(-1, 0, 0, -1));
}

TEST(Tangents, AreSmoothOnASphere) {
  Mesh mesh = UvSphere(32);
  MakeTangents(mesh, 0);
  for (std::size_t i = 1; i + 1 < mesh.positions.size(); ++i) {
    const vec3 p = mesh.positions[i], tangent(mesh.tangents[i]);
    if (std::abs(p.y) > 0.95f) continue;
    EXPECT_NEAR(glm::length(tangent), 1, 1e-5f);
    EXPECT_NEAR(glm::dot(tangent, mesh.normals[i]), 0, 1e-5f);
    EXPECT_EQ(mesh.tangents[i].w, 1);
    EXPECT_GT(glm::dot(tangent, glm::normalize(vec3(p.z, 0, -p.x))), 0.99f);
  }
}

TEST(Tangents, NeedNoArea) {
  Mesh mesh = Quad();
  for (vec2& uv : mesh.uvs) uv = {0.5f, 0.5f};
  mesh.positions[2] = mesh.positions[1];
  MakeTangents(mesh, 0);
  ASSERT_EQ(mesh.tangents.size(), 4u);
  for (const vec4& t : mesh.tangents) EXPECT_NEAR(glm::length(vec3(t)), 1, 1e-5f);
}

}  // namespace
}  // namespace snell::tessellate
