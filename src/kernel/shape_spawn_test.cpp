// SPDX-License-Identifier: Apache-2.0
//
// Rays that start on a shape's surface: one that leaves must not hit the surface that it comes from, one that
// goes in must find its way out, at every scale and far from the world's origin. No failure is accepted.
#include <gtest/gtest.h>

#include <sstream>

#include "support/shapes.h"

namespace snell::kernel {
namespace {

using test::RayKind;
using test::ReferenceShape;

struct Failures {
  std::uint64_t trials = 0;
  std::uint64_t selfHits = 0;    // a ray that left hit again
  std::uint64_t noExits = 0;     // a ray that went in did not come out
  std::uint64_t falseExits = 0;  // … or came out through a surface that clearly faces it
  std::string first;
};

bool IsFlat(uint kind) {
  return kind == SHAPE_PLANE || kind == SHAPE_DISK || kind == SHAPE_RECTANGLE;
}

// Whether the exact ray crosses the surface ahead, about where the kernel says.
bool Confirmed(const Shape& shape, vec3 o, vec3 d, float t) {
  const ReferenceShape exact(shape);
  const glm::dvec3 localO = test::ExactToLocal(shape.toWorld, glm::dvec3(o));
  const glm::dvec3 localD = test::ExactToLocalVector(shape.toWorld, glm::dvec3(d));
  const double slack = test::Uncertainty(shape, exact, o, d, double(t));
  for (const test::Crossing& c : exact.Crossings(localO, localD)) {
    const double off = std::abs(c.t - double(t)) * glm::length(localD);
    const double mayBeOff = std::max(slack / c.cosine, std::sqrt(slack * c.radius));
    if (c.t > 0 && c.margin > -mayBeOff && off <= mayBeOff) return true;
  }
  return false;
}

void Spawn(const Shape& shape, const SurfaceInteraction& it, test::Random& random, Failures& f) {
  const bool convex = shape.kind != SHAPE_TORUS && shape.kind != SHAPE_TUBE;
  const bool solid = ReferenceShape(shape).Solid();
  ++f.trials;
  const auto note = [&](const char* what, vec3 o, vec3 d, float t) {
    if (!f.first.empty()) return;
    const glm::dvec3 p = test::ExactToLocal(shape.toWorld, glm::dvec3(it.p));
    const glm::dvec3 lo = test::ExactToLocal(shape.toWorld, glm::dvec3(o));
    std::ostringstream text;
    text << what << ": t " << t << ", cosine " << Dot(it.n, d) << ", a " << shape.a << ", b "
         << shape.b << ", c " << shape.c << ", scales " << Length(shape.toWorld.x) << " "
         << Length(shape.toWorld.y) << " " << Length(shape.toWorld.z) << ", local point " << p.x
         << " " << p.y << " " << p.z << ", start off by " << lo.x - p.x << " " << lo.y - p.y << " "
         << lo.z - p.z;
    f.first = text.str();
  };

  // Outwards; a direction within rounding of the surface is on neither side
  const vec3 out(random.DirectionAbove(glm::dvec3(it.n)));
  const vec3 in(-random.DirectionAbove(glm::dvec3(it.n)));
  if (Dot(out, it.n) < 5e-7f || Dot(in, it.n) > -5e-7f) return;
  vec3 o = OffsetRayOrigin(it.p, it.pError, it.n, out);
  float t = IntersectShape(shape, o, out);
  if (t > 0 && (convex || !Confirmed(shape, o, out, t))) {
    ++f.selfHits;
    note("self-hit outside", o, out, t);
  }

  // Inwards
  o = OffsetRayOrigin(it.p, it.pError, it.n, in);
  t = IntersectShape(shape, o, in);
  if (solid) {
    if (!(t > 0)) {
      ++f.noExits;
      note("no exit", o, in, t);
    } else if (Dot(ShapeSurface(shape, o, in, t).n, in) < -1e-3f) {
      ++f.falseExits;
      note("false exit", o, in, t);
    }
  } else if (t > 0 && (IsFlat(shape.kind) || !Confirmed(shape, o, in, t))) {
    ++f.selfHits;
    note("self-hit inside", o, in, t);
  }
}

class SpawnedRays : public testing::TestWithParam<unsigned> {};

TEST_P(SpawnedRays, LeaveTheirSurfaceAndFindTheirExit) {
  const unsigned kind = GetParam();
  test::Random random(400 + kind);
  Failures failures;
  const std::uint64_t rays = test::Scaled(kind == SHAPE_TORUS ? 40000 : 200000);
  for (std::uint64_t i = 0; i < rays; ++i) {
    Shape shape = test::RandomShape(random, kind, test::RandomPlacement(random));
    // Up to 10⁴ times its smallest extent from the world's origin
    if (random.Chance(0.5)) {
      const double distance = test::SmallestExtent(shape) * random.LogUniform(1e-2, 1e4);
      shape.toWorld.origin = vec3(random.Direction() * distance);
    }
    const ReferenceShape exact(shape);
    // Leave out what is so thin and so uneven that the error bound bends with the surface
    const double thin = kind == SHAPE_TORUS ? exact.Size() / exact.b : 1;
    const double stretch = test::Stretch(shape.toWorld);
    if (stretch * stretch * thin > 1e4) continue;
    const test::LocalRay ray =
        test::RandomRay(random, exact, RayKind(i % std::uint64_t(RayKind::Count)));
    vec3 o(test::ExactToWorld(shape.toWorld, ray.o));
    vec3 d(glm::normalize(test::ExactToWorld(shape.toWorld, ray.o + ray.d) -
                          test::ExactToWorld(shape.toWorld, ray.o)));
    // Now and then follow the ray through several surfaces
    for (int step = 0; step < 3; ++step) {
      const float t = IntersectShape(shape, o, d);
      if (!(t > 0)) break;
      const SurfaceInteraction it = ShapeSurface(shape, o, d, t);
      Spawn(shape, it, random, failures);
      d = vec3(random.Direction());
      o = OffsetRayOrigin(it.p, it.pError, it.n, d);
    }
  }
  EXPECT_GT(failures.trials, rays / 4);
  EXPECT_EQ(failures.selfHits, 0u) << "of " << failures.trials << ", first: " << failures.first;
  EXPECT_EQ(failures.noExits, 0u) << "of " << failures.trials << ", first: " << failures.first;
  EXPECT_EQ(failures.falseExits, 0u) << "of " << failures.trials << ", first: " << failures.first;
}

INSTANTIATE_TEST_SUITE_P(Shapes, SpawnedRays, testing::ValuesIn(test::ShapeKinds),
                         [](const auto& i) { return test::NameOfShape(i.param); });

}  // namespace
}  // namespace snell::kernel
