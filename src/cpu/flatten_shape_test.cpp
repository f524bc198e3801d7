// SPDX-License-Identifier: Apache-2.0
//
// Flattening of transforms and shapes: they are where the scene says, whichever way they point, and face where
// it says.
#include "cpu/flatten_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "kernel/math.h"
#include "support/shapes.h"

namespace snell::cpu {
namespace {

using namespace kernel;
using glm::dvec3;
using scene::Affine;
using test::Random;

// The distance of a world point from the flattened shape's surface, in its own units.
double DistanceFrom(const Shape& shape, dvec3 world) {
  return std::abs(test::ReferenceShape(shape).Distance(test::ExactToLocal(shape.toWorld, world)));
}

TEST(ToTransform, IsTheMapAndItsInverse) {
  Random random(740);
  for (int i = 0; i < 1000; ++i) {
    const double scale = random.LogUniform(1e-4, 1e5);
    const Affine m = test::RandomMap(random, test::MapKinds[i % 4], scale, 5);
    const Transform t = ToTransform(m);
    const dvec3 p = random.InCube();
    const dvec3 world(m * glm::dvec4(p, 1));
    const double stretch = test::Stretch(t);
    EXPECT_LT(glm::length(test::ExactToWorld(t, p) - world),
              1e-6 * (glm::length(world) + 20 * scale));
    EXPECT_LT(glm::length(test::ExactToLocal(t, test::ExactToWorld(t, p)) - p), 1e-5 * stretch);
  }
}

// Points on the surface of a shape of the scene, before its object's transform.
std::vector<dvec3> PointsOn(Random& random, const scene::Geometry& geometry) {
  std::vector<dvec3> points;
  const auto circle = [&](dvec3 center, dvec3 axis, double radius) {
    const dvec3 n = glm::normalize(axis);
    const dvec3 a =
        glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const double angle = random.Uniform(0, 6.283185307179586);
    return center + (a * std::cos(angle) + glm::cross(n, a) * std::sin(angle)) * radius;
  };
  for (int i = 0; i < 40; ++i) {
    const double u = random.Uniform(), v = random.Uniform();
    if (const auto* s = std::get_if<scene::Sphere>(&geometry))
      points.push_back(dvec3(s->center) + random.Direction() * double(s->radius));
    if (const auto* s = std::get_if<scene::Plane>(&geometry))
      points.push_back(circle(dvec3(s->point), dvec3(s->normal), 10 * u));
    if (const auto* s = std::get_if<scene::Disk>(&geometry))
      points.push_back(circle(dvec3(s->center), dvec3(s->normal),
                              double(s->innerRadius) + u * double(s->radius - s->innerRadius)));
    if (const auto* s = std::get_if<scene::Rectangle>(&geometry))
      points.push_back(dvec3(s->corner) + dvec3(s->edgeU) * u + dvec3(s->edgeV) * v);
    if (const auto* s = std::get_if<scene::Box>(&geometry)) {
      dvec3 p =
          dvec3(s->lower) + (dvec3(s->upper) - dvec3(s->lower)) * dvec3(u, v, random.Uniform());
      const int axis = i % 3;
      p[axis] = double(i % 2 ? s->lower[axis] : s->upper[axis]);
      points.push_back(p);
    }
    if (const auto* s = std::get_if<scene::Cone>(&geometry)) {
      const dvec3 base(s->base), top(s->top);
      const double r = double(s->radius), tr = double(s->topRadius);
      points.push_back(circle(base + (top - base) * u, top - base, r + (tr - r) * u));
    }
    if (const auto* s = std::get_if<scene::Torus>(&geometry)) {
      const dvec3 axis = glm::normalize(dvec3(s->axis));
      const dvec3 ring = circle(dvec3(0), axis, 1);
      const double angle = 6.283185307179586 * u, minor = double(s->minorRadius);
      points.push_back(dvec3(s->center) +
                       ring * (double(s->majorRadius) + minor * std::cos(angle)) +
                       axis * (minor * std::sin(angle)));
    }
  }
  return points;
}

TEST(FlattenShape, PutsEveryShapeWhereItIs) {
  Random random(741);
  for (int i = 0; i < 2000; ++i) {
    // Axes in all directions, also just beside those of the coordinates
    vec3 axis(random.Direction() * random.LogUniform(0.1, 10));
    if (random.Chance(0.5)) {
      dvec3 a = random.Direction() * random.LogUniform(1e-9, 1e-2);
      a[int(random.Index(3))] += random.Chance(0.5) ? 1 : -1;
      axis = vec3(a);
    }
    const vec3 at(random.InCube() * 2.0);
    const float r = float(random.LogUniform(0.3, 3));
    const scene::Geometry geometries[] = {
        scene::Sphere{at, r},
        scene::Plane{at, axis},
        scene::Disk{at, axis, r, 0.3f * r},
        scene::Rectangle{at, axis, vec3(random.Direction() * 2.0)},
        scene::Box{at - kernel::Abs(axis) - 0.1f, at + kernel::Abs(axis) + 0.1f},
        scene::Cone{at, at + axis, r, 0.4f * r, true},
        scene::Cone{at, at + axis, 0.0f, r, false},
        scene::Torus{at, axis, r, 0.3f * r}};
    const scene::Geometry& geometry = geometries[i % std::size(geometries)];
    const Affine map =
        test::RandomMap(random, test::MapKinds[random.Index(4)], random.LogUniform(0.1, 10), 2);
    const Shape shape = FlattenShape(geometry, map, 7);
    EXPECT_EQ(shape.object, 7u);
    const double size = std::max(1.0, test::ReferenceShape(shape).Size());
    const double tolerance = 1e-5 * size * test::Stretch(shape.toWorld) * 10;
    for (const dvec3 p : PointsOn(random, geometry)) {
      ASSERT_LT(DistanceFrom(shape, dvec3(map * glm::dvec4(p, 1))), tolerance)
          << "shape " << i % std::size(geometries) << ", axis " << axis.x << " " << axis.y << " "
          << axis.z;
    }
  }
}

TEST(FlattenShape, KeepsTheDirectionOfNormals) {
  Random random(742);
  for (int i = 0; i < 2000; ++i) {
    dvec3 axis = random.Direction();
    if (i % 2 == 0)
      axis = glm::normalize(dvec3(0, i % 4 == 0 ? 1 : -1, 0) + axis * random.LogUniform(1e-8, 0.1));
    for (const scene::Geometry& geometry : {scene::Geometry(scene::Plane{vec3(0), vec3(axis)}),
                                            scene::Geometry(scene::Disk{vec3(0), vec3(axis)})}) {
      const Shape shape = FlattenShape(geometry, Affine(1.0), 0);
      const dvec3 n(Normalize(ToWorldNormal(shape.toWorld, vec3(0, 1, 0))));
      EXPECT_LT(glm::length(n - glm::normalize(dvec3(vec3(axis)))), 1e-6);
      // No shear: the axes stay orthogonal
      EXPECT_NEAR(double(Dot(shape.toWorld.x, shape.toWorld.y)), 0, 1e-6);
      EXPECT_NEAR(double(Dot(shape.toWorld.z, shape.toWorld.y)), 0, 1e-6);
      EXPECT_NEAR(double(Dot(shape.toWorld.x, shape.toWorld.z)), 0, 1e-6);
    }
  }
}

TEST(FlattenShape, KeepsSpheresUnderSimilaritiesOnly) {
  Random random(743);
  for (int i = 0; i < 400; ++i) {
    const test::MapKind kind = test::MapKinds[i % 4];
    const double scale = random.LogUniform(1e-3, 1e3);
    const Affine map = test::RandomMap(random, kind, scale, 2);
    const Shape shape = FlattenShape(scene::Sphere{vec3(1, 2, 3), 2}, map, 0);
    if (kind == test::MapKind::Rigid || kind == test::MapKind::Mirrored) {
      ASSERT_EQ(shape.kind, SHAPE_SPHERE);
      EXPECT_NEAR(double(shape.a), 2 * scale, 1e-6 * scale);
      EXPECT_NEAR(double(Length(shape.toWorld.x)), 1, 1e-6);
    } else {
      EXPECT_EQ(shape.kind, SHAPE_ELLIPSOID);
    }
  }
}

}  // namespace
}  // namespace snell::cpu
