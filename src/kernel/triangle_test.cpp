// SPDX-License-Identifier: Apache-2.0
//
// Triangles: hits against double precision, closed meshes that let no ray out through edges and vertices,
// and rays that start on a triangle's surface.
#include "kernel/triangle.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "support/surface_kernel.h"
#include "support/transforms.h"

namespace snell::kernel {
namespace {

using glm::dvec3;
using test::MeshScene;
using test::PointOn;
using test::TriangleMesh;

// The ray's crossing of the triangle's plane and its barycentric coordinates there, by Cramer's rule.
struct ExactHit {
  double t, b0, b1, b2;
};
ExactHit Exact(vec3 o, vec3 d, vec3 v0, vec3 v1, vec3 v2) {
  const dvec3 e1 = dvec3(v1) - dvec3(v0), e2 = dvec3(v2) - dvec3(v0), s = dvec3(o) - dvec3(v0);
  const dvec3 p = glm::cross(dvec3(d), e2), q = glm::cross(s, e1);
  const double det = glm::dot(e1, p);
  const double b1 = glm::dot(s, p) / det, b2 = glm::dot(dvec3(d), q) / det;
  return {glm::dot(e2, q) / det, 1 - b1 - b2, b1, b2};
}

TEST(IntersectTriangle, AgreesWithDoublePrecision) {
  test::Random random(500);
  int hits = 0;
  int misses = 0;
  double worstT = 0;
  for (std::uint64_t i = 0; i < test::Scaled(500000); ++i) {
    const double scale = random.LogUniform(1e-6, 1e7);
    const dvec3 centre = random.InCube() * (scale * random.LogUniform(0.01, 100));
    vec3 v[3];
    for (vec3& p : v) p = vec3(centre + random.InCube() * scale);
    const vec3 o(centre + random.Direction() * (scale * random.LogUniform(0.1, 100)));
    const double b1 = random.Uniform(-0.5, 1.5), b2 = random.Uniform(-0.5, 1.5);
    const dvec3 target =
        dvec3(v[0]) + (dvec3(v[1]) - dvec3(v[0])) * b1 + (dvec3(v[2]) - dvec3(v[0])) * b2;
    vec3 d(target - dvec3(o));
    if (random.Chance(0.5)) d = Normalize(d);
    const ExactHit exact = Exact(o, d, v[0], v[1], v[2]);
    const TriangleHit hit = IntersectTriangle(Shear(o, d), v[0], v[1], v[2]);

    // How far rounding may move the ray at the triangle, in barycentric coordinates
    const dvec3 n = glm::cross(dvec3(v[1]) - dvec3(v[0]), dvec3(v[2]) - dvec3(v[0]));
    const double area = glm::length(n);
    const double longest =
        std::max({Length(v[1] - v[0]), Length(v[2] - v[0]), Length(v[2] - v[1])});
    const double cosine = std::abs(glm::dot(glm::normalize(n), glm::normalize(dvec3(d))));
    const double reach = glm::length(dvec3(v[0]) - dvec3(o)) + longest;
    const double slack = 16 * 0x1p-24 * reach * longest / (area * cosine);
    if (slack > 0.1) continue;
    const double inside = std::min({exact.b0, exact.b1, exact.b2});
    if (hit.t > 0) {
      ++hits;
      ASSERT_GE(inside, -slack) << i;
      ASSERT_NEAR(double(hit.b0), exact.b0, slack);
      ASSERT_NEAR(double(hit.b1), exact.b1, slack);
      ASSERT_NEAR(double(hit.b2), exact.b2, slack);
      ASSERT_NEAR(hit.b0 + hit.b1 + hit.b2, 1.0f, 1e-6f);
      const double tSlack = 16 * 0x1p-24 * reach / (cosine * glm::length(dvec3(d)));
      worstT = std::max(worstT, std::abs(double(hit.t) - exact.t) / tSlack);
      ASSERT_NEAR(double(hit.t), exact.t, tSlack);
    } else {
      ++misses;
      ASSERT_FALSE(inside > slack && exact.t * glm::length(dvec3(d)) > 1e-5 * reach) << i;
    }
  }
  EXPECT_GT(hits, 50000);
  EXPECT_GT(misses, 50000);
  RecordProperty("share_of_tolerance_percent", int(worstT * 100));
}

TEST(IntersectTriangle, IgnoresDegenerateTriangles) {
  test::Random random(501);
  for (int i = 0; i < 100000; ++i) {
    const vec3 a(random.InCube()), b(random.InCube());
    const vec3 o(random.InCube() * 3.0);
    for (const vec3 target : {a, b, (a + b) * 0.5f}) {
      const ShearedRay ray = Shear(o, target - o);
      EXPECT_LE(IntersectTriangle(ray, a, a, a).t, 0.0f);
      EXPECT_LE(IntersectTriangle(ray, a, a, b).t, 0.0f);
      EXPECT_LE(IntersectTriangle(ray, a, b, b).t, 0.0f);
      EXPECT_LE(IntersectTriangle(ray, b, a, b).t, 0.0f);
    }
  }
}

TEST(IntersectTriangle, HitsFromBothSidesAtTheSameDistance) {
  test::Random random(502);
  for (int i = 0; i < 100000; ++i) {
    const vec3 a(random.InCube()), b(random.InCube()), c(random.InCube());
    const vec3 o(random.InCube() * 3.0);
    const ShearedRay ray = Shear(o, (a + b + c) * (1.0f / 3.0f) - o);
    const float t = IntersectTriangle(ray, a, b, c).t;
    // Whatever the winding is and the first vertex, whether there is a hit does not change
    for (const float other :
         {IntersectTriangle(ray, a, c, b).t, IntersectTriangle(ray, b, c, a).t}) {
      ASSERT_EQ(other > 0, t > 0);
      if (t > 0) {
        ASSERT_NEAR(other, t, 1e-4f);
      }
    }
  }
}

std::vector<TriangleMesh> ClosedMeshes(test::Random& random) {
  return {test::Icosphere(1), test::Cube(), test::Bipyramid(random, 40, 1, 1e-4),
          test::Bipyramid(random, 40, 1e-3, 1e-4), test::Bipyramid(random, 40, 1e3, 1e-4)};
}

// A map that keeps the mesh's proportions.
glm::dmat4 Placement(test::Random& random) {
  const double scale = random.LogUniform(1e-6, 1e7);
  return test::RandomMap(random, test::MapKind::Rigid, scale, random.Chance(0.5) ? 0 : 30);
}

TEST(ClosedMeshes, LetNoRayOutThroughEdgesAndVertices) {
  test::Random random(503);
  std::uint64_t escaped = 0;
  std::uint64_t rays = 0;
  for (std::uint64_t i = 0; i < test::Scaled(200); ++i) {
    for (const TriangleMesh& plain : ClosedMeshes(random)) {
      const TriangleMesh mesh = test::Placed(plain, Placement(random));
      const MeshScene scene(mesh);
      // Well inside: half way from the middle to a point on the surface
      dvec3 middle(0.0);
      for (const vec3 p : mesh.positions) middle += dvec3(p);
      middle /= double(mesh.positions.size());
      for (int ray = 0; ray < 60; ++ray) {
        const dvec3 start = middle + (PointOn(random, mesh) - middle) * random.Uniform(0, 0.5);
        const vec3 o(start);
        const vec3 target(PointOn(random, mesh));
        ++rays;
        if (scene.Closest(o, target - o).primitive == None) ++escaped;
      }
    }
  }
  EXPECT_EQ(escaped, 0u) << "of " << rays;
}

TEST(ClosedMeshes, LetNoAxisParallelRayOut) {
  // Rays exactly along edges' planes and through vertices of the cube
  const MeshScene scene(test::Cube());
  for (int x = -8; x <= 8; ++x) {
    for (int y = -8; y <= 8; ++y) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {1.0f, -1.0f}) {
          vec3 o(0.0f), d(0.0f);
          o[(axis + 1) % 3] = float(x) / 8;
          o[(axis + 2) % 3] = float(y) / 8;
          d[axis] = side;
          EXPECT_NE(scene.Closest(o, d).primitive, None) << x << " " << y;
          if (x == 8) continue;  // on a face, and about to leave it
          d[(axis + 1) % 3] = 1e-40f;
          EXPECT_NE(scene.Closest(o, d).primitive, None) << x << " " << y;
        }
      }
    }
  }
}

TEST(SpawnedRays, NeverHitTheirOwnTriangle) {
  test::Random random(504);
  std::uint64_t selfHits = 0;
  std::uint64_t trials = 0;
  for (std::uint64_t i = 0; i < test::Scaled(300000); ++i) {
    // From fair to needle, from tiny to huge, near and far
    const double scale = random.LogUniform(1e-6, 1e7);
    const dvec3 centre =
        random.Chance(0.3) ? dvec3(0.0) : random.InCube() * (scale * random.LogUniform(0.1, 100));
    TriangleMesh mesh;
    mesh.triangles = {{0, 1, 2}};
    const dvec3 a = centre + random.InCube() * scale, edge = random.Direction() * scale;
    const dvec3 side =
        random.Direction() * (scale * (random.Chance(0.5) ? 1 : random.LogUniform(1e-6, 1)));
    mesh.positions = {vec3(a), vec3(a + edge), vec3(a + edge * random.Uniform() + side)};
    const MeshScene scene(mesh);
    const dvec3 target = PointOn(random, mesh);
    const vec3 o(target + random.Direction() * (scale * random.LogUniform(1e-2, 10)));
    const vec3 d = Normalize(vec3(target) - o);
    const Hit hit = scene.Closest(o, d);
    if (hit.primitive == None) continue;
    ++trials;
    const SurfaceInteraction it = scene.kernel.SurfaceAt(hit, {o, d, 0});
    for (const double side2 : {1.0, -1.0}) {
      const vec3 w(random.DirectionAbove(dvec3(it.n)) * side2);
      const vec3 start = OffsetRayOrigin(it.p, it.pError, it.n, w);
      if (scene.Closest(start, w).primitive != None) ++selfHits;
    }
  }
  EXPECT_GT(trials, 50000u);
  EXPECT_EQ(selfHits, 0u) << "of " << 2 * trials;
}

TEST(SpawnedRays, DoNotHitAFlatMeshThatTheyLeave) {
  test::Random random(506);
  std::uint64_t trials = 0, selfHits = 0;
  for (std::uint64_t i = 0; i < test::Scaled(40); ++i) {
    const MeshScene scene(test::Placed(test::Grid(10), Placement(random)));
    for (int ray = 0; ray < 200; ++ray) {
      // Anywhere, on edges and vertices, and near the middle, where coordinates may be tiny
      const Triangle& t = scene.triangles[random.Index(uint(scene.triangles.size()))];
      const dvec3 a(scene.positions[t.v0]), b(scene.positions[t.v1]), c(scene.positions[t.v2]);
      const double u = random.Chance(0.3) ? 0 : random.Uniform(), v = random.Uniform() * (1 - u);
      const dvec3 target = a + (b - a) * u + (c - a) * v;
      const dvec3 n = glm::normalize(glm::cross(b - a, c - a));
      const double size = glm::length(b - a);
      const vec3 o(target + (n + random.Direction() * 0.8) * size);
      const vec3 d = Normalize(vec3(target - dvec3(o)));
      const Hit hit = scene.Closest(o, d);
      if (hit.primitive == None) continue;
      const SurfaceInteraction it = scene.kernel.SurfaceAt(hit, {o, d, 0});
      const double side = random.Chance(0.5) ? 1 : -1;
      const dvec3 flat = glm::normalize(glm::cross(random.Direction(), n));
      const double rise = random.Chance(0.5) ? random.LogUniform(1e-4, 1) : random.Uniform(0.1, 10);
      const vec3 w(glm::normalize(flat + n * rise) * side);
      ++trials;
      if (scene.Closest(OffsetRayOrigin(it.p, it.pError, it.n, w), w).primitive != None) ++selfHits;
    }
  }
  EXPECT_GT(trials, 4000u);
  EXPECT_EQ(selfHits, 0u) << "of " << trials;
}

TEST(SpawnedRays, LeaveConvexMeshesOrFindTheirExit) {
  test::Random random(505);
  for (const int kind : {0, 1, 2}) {
    std::uint64_t trials = 0, selfHits = 0, escaped = 0;
    for (std::uint64_t i = 0; i < test::Scaled(600); ++i) {
      const TriangleMesh plain = kind == 0   ? test::Icosphere(1)
                                 : kind == 1 ? test::Cube()
                                             : test::Bipyramid(random, 24, 1, 0.1);
      const TriangleMesh mesh = test::Placed(plain, Placement(random));
      const MeshScene scene(mesh);
      dvec3 middle(0.0);
      for (const vec3 p : mesh.positions) middle += dvec3(p);
      const vec3 o(middle / double(mesh.positions.size()));
      for (int ray = 0; ray < 40; ++ray) {
        const vec3 d = Normalize(vec3(PointOn(random, mesh)) - o);
        const Hit hit = scene.Closest(o, d);
        ASSERT_NE(hit.primitive, None);
        const SurfaceInteraction it = scene.kernel.SurfaceAt(hit, {o, d, 0});
        ++trials;
        const vec3 out(random.DirectionAbove(dvec3(it.n)));
        vec3 start = OffsetRayOrigin(it.p, it.pError, it.n, out);
        if (scene.Closest(start, out).primitive != None) ++selfHits;
        const vec3 in(-random.DirectionAbove(dvec3(it.n)));
        start = OffsetRayOrigin(it.p, it.pError, it.n, in);
        if (scene.Closest(start, in).primitive == None) ++escaped;
      }
    }
    EXPECT_EQ(selfHits, 0u) << "of " << trials << ", mesh " << kind;
    EXPECT_EQ(escaped, 0u) << "of " << trials << ", mesh " << kind;
  }
}

}  // namespace
}  // namespace snell::kernel
