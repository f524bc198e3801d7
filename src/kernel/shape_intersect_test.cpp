// SPDX-License-Identifier: Apache-2.0
//
// The shapes' intersections against double precision: a hit must lie on the surface, no crossing may be
// passed over that is more than rounding away from being missed, and rays from inside a solid always find
// their way out.
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace snell::kernel {
namespace {

using test::RayKind;
using test::ReferenceShape;

struct Tally {
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;
  double worst = 0;  // distance from the surface, relative to the uncertainty
};

void CheckRay(const Shape& shape, vec3 o, vec3 d, Tally& tally) {
  const ReferenceShape exact(shape);
  const float t = IntersectShape(shape, o, d);
  const glm::dvec3 localO = test::ExactToLocal(shape.toWorld, glm::dvec3(o));
  const glm::dvec3 localD = test::ExactToLocalVector(shape.toWorld, glm::dvec3(d));
  const double speed = glm::length(localD);
  ++tally.rays;
  ASSERT_FALSE(std::isnan(t));

  // A hit lies on the surface
  if (t > 0) {
    ++tally.hits;
    const double off = std::abs(exact.Distance(localO + localD * double(t)));
    const double slack = test::Uncertainty(shape, exact, o, d, double(t));
    tally.worst = std::max(tally.worst, off / slack);
    ASSERT_LE(off, slack) << "t = " << t;
  }

  // No certain crossing lies before it: one that rounding can neither remove nor join with its neighbour
  const std::vector<test::Crossing> crossings = exact.Crossings(localO, localD);
  for (const test::Crossing& c : crossings) {
    const double slack = test::Uncertainty(shape, exact, o, d, c.t);
    const double along = slack / c.cosine;
    bool certain = c.cosine > 4 * std::sqrt(slack / c.radius) && c.margin > 4 * along &&
                   c.t * speed > 2 * along;
    for (const test::Crossing& other : crossings) {
      const double gap = std::abs(other.t - c.t) * speed;
      if (&other != &c && other.margin > -4 * along && gap < 8 * along) certain = false;
    }
    if (!certain) continue;
    ASSERT_GT(t, 0) << "missed at " << c.t << ", cosine " << c.cosine << ", margin " << c.margin;
    ASSERT_LE((double(t) - c.t) * speed, 2 * along) << "passed over " << c.t;
  }

  // From inside there is a way out
  if (exact.Solid() && exact.Distance(localO) < -test::Uncertainty(shape, exact, o, d, 0)) {
    ASSERT_GT(t, 0) << "no exit";
  }
}

class Intersect : public testing::TestWithParam<unsigned> {};

TEST_P(Intersect, AgreesWithDoublePrecision) {
  const unsigned kind = GetParam();
  test::Random random(200 + kind);
  Tally tally;
  for (std::uint64_t i = 0; i < test::Scaled(kind == SHAPE_TORUS ? 40000 : 200000); ++i) {
    const Shape shape = test::RandomShape(random, kind, test::RandomPlacement(random));
    const ReferenceShape exact(shape);
    const RayKind rayKind = RayKind(i % std::uint64_t(RayKind::Count));
    const test::LocalRay ray = test::RandomRay(random, exact, rayKind);
    const vec3 o(test::ExactToWorld(shape.toWorld, ray.o));
    glm::dvec3 d = glm::dmat3(glm::dvec3(shape.toWorld.x), glm::dvec3(shape.toWorld.y),
                              glm::dvec3(shape.toWorld.z)) *
                   ray.d;
    if (random.Chance(0.8)) d = glm::normalize(d);
    CheckRay(shape, o, vec3(d), tally);
    if (HasFatalFailure()) {
      FAIL() << test::NameOfShape(kind) << " " << i << ", ray kind " << int(rayKind) << ", a "
             << shape.a << ", b " << shape.b << ", c " << shape.c << ", |x| "
             << Length(shape.toWorld.x) << ", |y| " << Length(shape.toWorld.y) << ", |z| "
             << Length(shape.toWorld.z);
    }
  }
  EXPECT_GT(tally.hits, tally.rays / 5);
  RecordProperty("share_of_uncertainty_percent", int(tally.worst * 100));
}

TEST_P(Intersect, TakesAxisParallelRaysInItsOwnAxes) {
  // No rotation: zeros of the direction stay zeros, also negative and denormal ones
  const unsigned kind = GetParam();
  test::Random random(220 + kind);
  Tally tally;
  for (std::uint64_t i = 0; i < test::Scaled(kind == SHAPE_TORUS ? 10000 : 50000); ++i) {
    Shape shape = test::RandomShape(random, kind, {});
    shape.toWorld = test::ToKernel(glm::dmat4(1.0));
    const ReferenceShape exact(shape);
    const double size = kind == SHAPE_PLANE ? 3 : exact.Size();
    // Starts on a coarse lattice: on faces, edges, axes and centres
    vec3 o(float(int(random.Index(9)) - 4), float(int(random.Index(9)) - 4),
           float(int(random.Index(9)) - 4));
    o *= float(size / 4);
    if (random.Chance(0.5)) o += vec3(random.InCube() * 0.2 * size);
    vec3 d(0.0f);
    const int axis = int(random.Index(3));
    d[axis] = random.Chance(0.5) ? 1.0f : -1.0f;
    constexpr float Small[] = {0.0f, -0.0f, 1e-42f, -1e-30f};
    d[(axis + 1) % 3] = Small[random.Index(4)];
    d[(axis + 2) % 3] = Small[random.Index(4)];
    CheckRay(shape, o, d, tally);
    if (HasFatalFailure()) {
      FAIL() << i << ": " << o.x << " " << o.y << " " << o.z << " to " << d.x << " " << d.y << " "
             << d.z << ", a " << shape.a << ", b " << shape.b << ", c " << shape.c;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Intersect, testing::ValuesIn(test::ShapeKinds),
                         [](const auto& i) { return test::NameOfShape(i.param); });

}  // namespace
}  // namespace snell::kernel
