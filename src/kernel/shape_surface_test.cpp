// SPDX-License-Identifier: Apache-2.0
//
// What the shapes say of a point on them: the bound of its error, normals against the gradient of the
// distance, texture coordinates and tangents against finite differences, and no NaN at poles and apexes.
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace snell::kernel {
namespace {

using test::ReferenceShape;

// Shoot at the local point p from outside, along a direction that is not too flat.
struct Shot {
  vec3 o;
  vec3 d;
  float t;
};

Shot ShootAt(test::Random& random, const Shape& shape, const ReferenceShape& exact, glm::dvec3 p) {
  const glm::dvec3 n = exact.Normal(p);
  glm::dvec3 side = random.Direction();
  if (glm::dot(side, n) < 0) side = -side;
  const double size = shape.kind == SHAPE_PLANE ? 1 : exact.Size();
  const glm::dvec3 start = p + glm::normalize(side + n) * (size * random.LogUniform(1e-2, 10));
  Shot shot;
  shot.o = vec3(test::ExactToWorld(shape.toWorld, start));
  shot.d = vec3(glm::normalize(test::ExactToWorld(shape.toWorld, p) - glm::dvec3(shot.o)));
  shot.t = IntersectShape(shape, shot.o, shot.d);
  return shot;
}

glm::dmat3 Forward(const Transform& m) {
  return {glm::dvec3(m.x), glm::dvec3(m.y), glm::dvec3(m.z)};
}

class Surface : public testing::TestWithParam<unsigned> {};

TEST_P(Surface, LiesWithinItsErrorBoundAndKnowsItsNormal) {
  const unsigned kind = GetParam();
  test::Random random(300 + kind);
  double worstBound = 0;
  double worstNormal = 0;
  std::uint64_t hits = 0;
  for (std::uint64_t i = 0; i < test::Scaled(100000); ++i) {
    const Shape shape = test::RandomShape(random, kind, test::RandomPlacement(random));
    const ReferenceShape exact(shape);
    const Shot shot = ShootAt(random, shape, exact, test::RandomSurfacePoint(random, exact));
    if (!(shot.t > 0)) continue;
    ++hits;
    const SurfaceInteraction it = ShapeSurface(shape, shot.o, shot.d, shot.t);

    // Back to the shape's space by the exact inverse of the map to the world
    const glm::dmat3 forward = Forward(shape.toWorld);
    const glm::dmat3 inverse = glm::inverse(forward);
    const glm::dvec3 p = inverse * (glm::dvec3(it.p) - glm::dvec3(shape.toWorld.origin));
    const glm::dvec3 localNormal = exact.Normal(p);
    const glm::dvec3 n = glm::normalize(glm::transpose(inverse) * localNormal);

    // The distance from the surface along the normal is what the bound promises
    const double distance = std::abs(exact.Distance(p) / glm::dot(localNormal, inverse * n));
    const double bound = glm::dot(glm::abs(n), glm::dvec3(it.pError));
    worstBound = std::max(worstBound, distance / bound);
    ASSERT_LE(distance, bound) << i;

    ASSERT_NEAR(Length(it.n), 1, 1e-5f);
    ASSERT_EQ(it.ns, it.n);
    ASSERT_EQ(it.object, shape.object);
    ASSERT_EQ(it.t, shot.t);

    // The normal, but for edges, where rounding may give the neighbouring face's
    const double nearEdge = 1e-3 * exact.Size();
    const bool edge =
        exact.Solid() && exact.Distance(p - localNormal * nearEdge) > -0.999 * nearEdge;
    if (edge ||
        std::abs(glm::dot(localNormal, exact.Normal(p + localNormal * nearEdge)) - 1) > 1e-9)
      continue;
    // Uneven maps turn normals by as much as they stretch
    double radius = exact.Size();  // of the strongest curvature
    if (kind == SHAPE_TORUS) radius = exact.b;
    if (kind == SHAPE_FRUSTUM || kind == SHAPE_TUBE) radius = std::hypot(p.x, p.z);
    const double bent = exact.Size() / radius;
    const double off = glm::length(glm::dvec3(it.n) - n) / (test::Stretch(shape.toWorld) * bent);
    worstNormal = std::max(worstNormal, off);
    ASSERT_LE(off, 5e-4) << i;
  }
  EXPECT_GT(hits, 50000u);
  RecordProperty("share_of_error_bound_percent", int(worstBound * 100));
  RecordProperty("worst_normal_1e-6", int(worstNormal * 1e6));
}

// The surface near the local point p, seen along its normal, for a shape without a map.
SurfaceInteraction SurfaceNear(const Shape& shape, const ReferenceShape& exact, glm::dvec3 p) {
  const glm::dvec3 n = exact.Normal(p);
  const double height = 1e-3 * (shape.kind == SHAPE_PLANE ? 1 : exact.Size());
  const vec3 o(p + n * height);
  return ShapeSurface(shape, o, vec3(-n), IntersectShape(shape, o, vec3(-n)));
}

TEST_P(Surface, HasTangentsThatFollowItsCoordinates) {
  const unsigned kind = GetParam();
  test::Random random(320 + kind);
  int checked = 0;
  for (int i = 0; i < 20000; ++i) {
    Shape shape = test::RandomShape(random, kind, {});
    shape.toWorld = test::ToKernel(glm::dmat4(1.0));
    // Parameters of about one, so that steps are small against all of the shape
    if (kind == SHAPE_TORUS) shape.a = 1, shape.b = float(random.Uniform(0.2, 0.9));
    if (kind == SHAPE_FRUSTUM || kind == SHAPE_TUBE) {
      shape.a = float(random.Uniform(0.3, 1));
      shape.b = float(random.Uniform(0.3, 1));
      shape.c = float(random.Uniform(0.3, 1));
    }
    const ReferenceShape exact(shape);
    const SurfaceInteraction it =
        SurfaceNear(shape, exact, test::RandomSurfacePoint(random, exact));
    const glm::dvec3 p(it.p), n(it.n), dpdu(it.dpdu);
    if (kind != SHAPE_PLANE) {
      ASSERT_TRUE(it.uv.x >= -1e-6f && it.uv.x <= 1.000001f);
      ASSERT_TRUE(it.uv.y >= -1e-6f && it.uv.y <= 1.000001f);
    }
    // Keep away from seams, poles and edges
    if (kind != SHAPE_PLANE &&
        (it.uv.x < 0.02f || it.uv.x > 0.98f || it.uv.y < 0.05f || it.uv.y > 0.95f))
      continue;
    if (kind == SHAPE_DISK && std::hypot(p.x, p.z) - exact.a < 0.02) continue;
    if (glm::length(dpdu) < 0.1) continue;
    ASSERT_NEAR(glm::dot(glm::normalize(dpdu), n), 0, 1e-5);

    // Along dpdu, u rises by the step and v stays
    const double step = 3e-4;
    const SurfaceInteraction next = SurfaceNear(shape, exact, p + dpdu * step);
    if (Dot(next.n, it.n) < 0.99f) continue;
    ASSERT_NEAR(next.uv.x - it.uv.x, step, 1e-5) << i << " at " << it.uv.x << " " << it.uv.y;
    ASSERT_NEAR(next.uv.y, it.uv.y, 1e-5);

    // To its left, seen from outside, v rises and u stays
    const glm::dvec3 left = glm::normalize(glm::cross(n, dpdu));
    const SurfaceInteraction above = SurfaceNear(shape, exact, p + left * step);
    if (Dot(above.n, it.n) < 0.99f) continue;
    ASSERT_NEAR(above.uv.x, it.uv.x, 1e-5);
    ASSERT_GT(above.uv.y, it.uv.y + 1e-5f);
    ++checked;
  }
  EXPECT_GT(checked, 5000);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Surface, testing::ValuesIn(test::ShapeKinds),
                         [](const auto& i) { return test::NameOfShape(i.param); });

Shape Plain(uint kind, float a = 0, float b = 0, float c = 0) {
  Shape shape = {};
  shape.kind = kind;
  shape.mapped = 1;
  shape.a = a;
  shape.b = b;
  shape.c = c;
  shape.toWorld = test::ToKernel(glm::dmat4(1.0));
  return shape;
}

// The surface that a ray meets, which must be there.
SurfaceInteraction Meet(const Shape& shape, vec3 o, vec3 d) {
  const float t = IntersectShape(shape, o, d);
  EXPECT_GT(t, 0.0f);
  return ShapeSurface(shape, o, d, t);
}

void ExpectUv(vec2 uv, float u, float v) {
  EXPECT_NEAR(uv.x, u, 1e-6f);
  EXPECT_NEAR(uv.y, v, 1e-6f);
}

TEST(SurfaceCoordinates, AreWhereTheDocumentationSays) {
  const Shape sphere = Plain(SHAPE_SPHERE, 2);
  ExpectUv(Meet(sphere, vec3(0, 0, 5), vec3(0, 0, -1)).uv, 0.5f, 0.5f);
  ExpectUv(Meet(sphere, vec3(5, 0, 0), vec3(-1, 0, 0)).uv, 0.75f, 0.5f);
  ExpectUv(Meet(sphere, vec3(-5, 0, 0), vec3(1, 0, 0)).uv, 0.25f, 0.5f);
  EXPECT_NEAR(Meet(sphere, vec3(0, 5, 0), vec3(0, -1, 0)).uv.y, 1.0f, 1e-6f);
  EXPECT_NEAR(Meet(sphere, vec3(0, -5, 0), vec3(0, 1, 0)).uv.y, 0.0f, 1e-6f);
  // The seam lies at −z: u is near 0 and 1 on its sides
  EXPECT_LT(Meet(sphere, vec3(-0.01f, 0, -5), vec3(0, 0, 1)).uv.x, 0.01f);
  EXPECT_GT(Meet(sphere, vec3(0.01f, 0, -5), vec3(0, 0, 1)).uv.x, 0.99f);

  ExpectUv(Meet(Plain(SHAPE_PLANE), vec3(3, 1, -2), vec3(0, -1, 0)).uv, 3, 2);
  ExpectUv(Meet(Plain(SHAPE_RECTANGLE), vec3(0.25f, 1, -0.75f), vec3(0, -1, 0)).uv, 0.25f, 0.75f);
  ExpectUv(Meet(Plain(SHAPE_DISK), vec3(0.5f, 1, 0), vec3(0, -1, 0)).uv, 0.75f, 0.5f);

  // A box's faces carry the texture upright for a viewer outside
  const Shape box = Plain(SHAPE_BOX);
  ExpectUv(Meet(box, vec3(0.5f, 0.5f, 4), vec3(0, 0, -1)).uv, 0.75f, 0.75f);
  ExpectUv(Meet(box, vec3(0.5f, 0.5f, -4), vec3(0, 0, 1)).uv, 0.25f, 0.75f);
  ExpectUv(Meet(box, vec3(4, 0.5f, 0.5f), vec3(-1, 0, 0)).uv, 0.25f, 0.75f);
  ExpectUv(Meet(box, vec3(-4, 0.5f, 0.5f), vec3(1, 0, 0)).uv, 0.75f, 0.75f);
  ExpectUv(Meet(box, vec3(0.5f, 4, 0.5f), vec3(0, -1, 0)).uv, 0.75f, 0.25f);
  ExpectUv(Meet(box, vec3(0.5f, -4, 0.5f), vec3(0, 1, 0)).uv, 0.75f, 0.75f);

  const Shape tube = Plain(SHAPE_TUBE, 1, 1, 2);
  ExpectUv(Meet(tube, vec3(0, 0.5f, 4), vec3(0, 0, -1)).uv, 0.5f, 0.25f);
  ExpectUv(Meet(tube, vec3(4, 0.5f, 0), vec3(-1, 0, 0)).uv, 0.75f, 0.25f);
  const Shape torus = Plain(SHAPE_TORUS, 2, 0.5f);
  ExpectUv(Meet(torus, vec3(4, 0, 0), vec3(-1, 0, 0)).uv, 0.75f, 0.5f);
  ExpectUv(Meet(torus, vec3(0, 4, 2), vec3(0, -1, 0)).uv, 0.5f, 0.75f);
}

TEST(SurfaceCoordinates, AreFiniteAtPolesApexesAndAxes) {
  const Shape shapes[] = {Plain(SHAPE_SPHERE, 1),          Plain(SHAPE_ELLIPSOID),
                          Plain(SHAPE_FRUSTUM, 1, 0, 1),   Plain(SHAPE_FRUSTUM, 0, 1, 1),
                          Plain(SHAPE_FRUSTUM, 1, 1, 1),   Plain(SHAPE_TUBE, 1, 0, 1),
                          Plain(SHAPE_TUBE, 0, 1, 1),      Plain(SHAPE_TORUS, 1, 1),
                          Plain(SHAPE_TORUS, 1, 0.25f),    Plain(SHAPE_BOX),
                          Plain(SHAPE_FRUSTUM, 0.3f, 0, 7)};
  test::Random random(340);
  int hits = 0;
  for (const Shape& shape : shapes) {
    for (int i = 0; i < 3000; ++i) {
      // At a pole, the apex or the centre, exactly or almost
      const vec3 target(0, random.Chance(0.5) ? shape.c : (random.Chance(0.5) ? 1.0f : 0.0f), 0);
      const vec3 o =
          i == 0 ? vec3(0, 9, 0) : (i == 1 ? vec3(0, -9, 0) : vec3(random.Direction() * 9.0));
      vec3 d = Normalize(target - o);
      if (random.Chance(0.5))
        d = Normalize(d + vec3(random.InCube() * random.LogUniform(1e-9, 1e-3)));
      const float t = IntersectShape(shape, o, d);
      if (!(t > 0)) continue;
      ++hits;
      const SurfaceInteraction it = ShapeSurface(shape, o, d, t);
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_TRUE(std::isfinite(it.p[axis]) && std::isfinite(it.pError[axis]))
            << shape.kind << " from " << o.x << " " << o.y << " " << o.z << " t " << t;
        ASSERT_TRUE(std::isfinite(it.n[axis]) && std::isfinite(it.dpdu[axis]))
            << shape.kind << " from " << o.x << " " << o.y << " " << o.z;
      }
      ASSERT_TRUE(std::isfinite(it.uv.x) && std::isfinite(it.uv.y));
      ASSERT_TRUE(it.uv.x >= -1e-6f && it.uv.x <= 1.000001f && it.uv.y >= -1e-6f &&
                  it.uv.y <= 1.000001f);
    }
  }
  EXPECT_GT(hits, 10000);
}

}  // namespace
}  // namespace snell::kernel
