// SPDX-License-Identifier: Apache-2.0
//
// Affine maps: there and back, normals under mirroring and uneven scales, and that the error bound really
// bounds the error.
#include "kernel/transform.h"

#include <gtest/gtest.h>

#include "support/transforms.h"

namespace snell::kernel {
namespace {

using test::MapKind;

constexpr MapKind Kinds[] = {MapKind::Rigid, MapKind::Mirrored, MapKind::NonUniform,
                             MapKind::Sheared};

TEST(Transform, MapsThereAndBack) {
  test::Random random(101);
  for (int i = 0; i < 200000; ++i) {
    const double scale = random.LogUniform(1e-4, 1e5);
    const Transform m = test::ToKernel(test::RandomMap(random, Kinds[i % 4], scale, 10));
    const vec3 p(random.InCube());
    const vec3 back = ToLocalPoint(m, ToWorldPoint(m, p));
    // Relative to the distance from the origin in units of the smallest axis
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(back[axis], p[axis], 2e-3f);
    const Ray ray = ToLocalRay(m, ToWorldPoint(m, p), ToWorldVector(m, vec3(1, 2, 3)));
    ASSERT_EQ(ray.o, back);
    ASSERT_NEAR(ray.d.y, 2.0f, 1e-3f);
  }
}

TEST(Transform, KeepsNormalsOutwardAndPerpendicular) {
  test::Random random(102);
  for (int i = 0; i < 200000; ++i) {
    const glm::dmat4 matrix =
        test::RandomMap(random, Kinds[i % 4], random.LogUniform(1e-4, 1e5), 1);
    const Transform m = test::ToKernel(matrix);
    const glm::dvec3 n = random.Direction();
    const glm::dvec3 tangent = glm::normalize(glm::cross(n, random.Direction()));
    const glm::dvec3 outside = random.DirectionAbove(n);
    const glm::dvec3 mapped = glm::normalize(glm::dvec3(ToWorldNormal(m, vec3(n))));
    const glm::dvec3 mappedTangent = glm::dmat3(matrix) * tangent;
    ASSERT_NEAR(glm::dot(mapped, glm::normalize(mappedTangent)), 0, 2e-5);
    // What was outside stays outside
    if (glm::dot(outside, n) > 1e-2) {
      ASSERT_GT(glm::dot(mapped, glm::dmat3(matrix) * outside), 0);
    }
  }
}

TEST(ToWorldPointError, BoundsTheError) {
  test::Random random(103);
  double worst = 0;
  for (std::uint64_t i = 0; i < test::Scaled(500000); ++i) {
    const double distance = random.Chance(0.3) ? 1e4 : random.LogUniform(1e-2, 1e3);
    const double scale = random.LogUniform(1e-4, 1e5);
    const Transform m = test::ToKernel(test::RandomMap(random, Kinds[i % 4], scale, distance));
    const vec3 p(random.InCube() * random.LogUniform(1e-3, 1e3));
    const vec3 error = Abs(vec3(random.InCube())) * 1e-5f;
    const glm::dvec3 off = glm::dvec3(p) + glm::dvec3(error) * random.InCube();
    const vec3 world = ToWorldPoint(m, p);
    const vec3 bound = ToWorldPointError(m, p, error, world);
    const glm::dvec3 exact = test::ExactToWorld(m, off);
    for (int axis = 0; axis < 3; ++axis) {
      const double miss = std::abs(double(world[axis]) - exact[axis]);
      worst = std::max(worst, miss / double(bound[axis]));
      ASSERT_LE(miss, double(bound[axis]));
    }
  }
  RecordProperty("share_of_bound_used_percent", int(worst * 100));
}

}  // namespace
}  // namespace snell::kernel
