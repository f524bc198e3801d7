// SPDX-License-Identifier: Apache-2.0
#include "tessellate/displace.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tessellate/dice.h"
#include "tessellate/test_meshes.h"

namespace snell::tessellate {
namespace {

using scene::Affine;

const Measure Unscaled{Affine(1.0)};
constexpr std::uint64_t Plenty = 1u << 24;

TEST(Dice, LeavesNoLongEdgeAndNoCrack) {
  for (Mesh mesh : {Cube(), UvSphere(6)}) {
    EXPECT_TRUE(Dice(mesh, Unscaled, {0, 0.11f}, Plenty));
    EXPECT_LE(LongestSide(mesh), 0.11f);
    EXPECT_EQ(OpenSides(mesh), 0);
    EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
    for (const vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1, 1e-5f);
  }
}

TEST(Dice, FollowsTheCamera) {
  scene::Camera camera;
  camera.position = {2, 0, 0};
  Measure measure(Affine(1.0));
  measure.AddEye(View(camera, 100, 100), Affine(1.0));
  Mesh mesh = Cube();
  EXPECT_TRUE(Dice(mesh, measure, {4, 0}, Plenty));
  EXPECT_EQ(OpenSides(mesh), 0);
  int near = 0, far = 0;
  for (const vec3& p : mesh.positions) {
    if (p.x == 1) ++near;
    if (p.x == -1) ++far;
  }
  EXPECT_GT(near, 4 * far);
}

TEST(Dice, StopsBeforeThereAreTooMany) {
  Mesh mesh = Cube();
  EXPECT_FALSE(Dice(mesh, Unscaled, {0, 0.01f}, 1000));
  EXPECT_LE(mesh.triangles.size(), 1000u);
  EXPECT_GT(mesh.triangles.size(), 250u);
  EXPECT_EQ(OpenSides(mesh), 0);
}

TEST(Dice, EndsForCoordinatesThatAreNotFinite) {
  Mesh mesh = Cube();
  mesh.positions[0].x = std::numeric_limits<float>::quiet_NaN();
  mesh.positions[1].x = std::numeric_limits<float>::infinity();
  mesh.positions[2].x = 1e30f;
  EXPECT_FALSE(Dice(mesh, Unscaled, {0, 0.1f}, 100000));
}

TEST(Displace, MakesALargerSphere) {
  Mesh mesh = UvSphere(24);
  Displace(mesh, Unscaled, 0, [](std::size_t, float) { return 0.25f; });
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(glm::length(mesh.positions[i]), 1.25f, 1e-6f);
    EXPECT_GT(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), 0.9999f);
  }
  EXPECT_EQ(OpenSides(mesh), 0);
}

TEST(Displace, MeasuresInTheWorld) {
  const Affine toWorld = glm::scale(Affine(1.0), glm::dvec3(2, 0.5, -3));
  Mesh mesh = UvSphere(24);
  const Mesh before = mesh;
  Displace(mesh, Measure(toWorld), 0, [](std::size_t, float) { return 0.1f; });
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 moved =
        glm::dmat3(toWorld) * glm::dvec3(mesh.positions[i] - before.positions[i]);
    EXPECT_NEAR(glm::length(moved), 0.1, 1e-6);
    EXPECT_GT(glm::dot(mesh.positions[i] - before.positions[i], before.normals[i]), 0);
  }
}

TEST(Displace, KeepsSeamsAndEdgesClosed) {
  for (Mesh mesh : {Cube(), UvSphere(8)}) {
    for (const bool flat : {false, true}) {
      if (flat) mesh.normals.clear();
      Dice(mesh, Unscaled, {0, 0.1f}, Plenty);
      // Heights that differ on the two sides of every seam
      const std::vector<vec2> uvs = mesh.uvs;
      Displace(mesh, Unscaled, 0, [&](std::size_t i, float width) {
        EXPECT_LT(width, 0.2f);
        return 0.2f * (uvs[i].x + 0.3f * std::sin(20 * uvs[i].y));
      });
      EXPECT_EQ(OpenSides(mesh), 0) << flat;
      EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    }
  }
}

TEST(Displace, NormalsFollowTheHeights) {
  // A plane becomes a slope of 45°; its normals point away from the winding's side, and still do then
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, vec3(0, 0, -1));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Mesh before = mesh;
  Displace(mesh, Unscaled, 0, [&](std::size_t i, float) { return before.positions[i].x; });
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(mesh.positions[i].z, -before.positions[i].x);
    EXPECT_LT(glm::length(mesh.normals[i] - glm::normalize(vec3(-1, 0, -1))), 1e-6f);
  }
}

}  // namespace
}  // namespace snell::tessellate
