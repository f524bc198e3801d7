// SPDX-License-Identifier: Apache-2.0
//
// Random shapes of every kind at every scale, random points on them, and rays of the kinds that give ray
// tracers trouble.
#pragma once

#include <string>

#include "kernel/shape.h"
#include "support/shape_reference.h"
#include "support/transforms.h"

namespace snell::test {

inline constexpr unsigned ShapeKinds[] = {
    kernel::SHAPE_SPHERE,  kernel::SHAPE_ELLIPSOID, kernel::SHAPE_PLANE,
    kernel::SHAPE_DISK,    kernel::SHAPE_RECTANGLE, kernel::SHAPE_BOX,
    kernel::SHAPE_FRUSTUM, kernel::SHAPE_TUBE,      kernel::SHAPE_TORUS};

inline std::string NameOfShape(unsigned kind) {
  static const char* const Names[] = {"Sphere", "Ellipsoid", "Plane", "Disk", "Rectangle",
                                      "Box",    "Frustum",   "Tube",  "Torus"};
  return Names[kind];
}

// What a shape looks like and where it is.
struct Placement {
  MapKind map = MapKind::Rigid;
  double scale = 1;
  double distance = 0;  // of its origin from the world's, in scales
};

inline Placement RandomPlacement(Random& random) {
  constexpr double Scales[] = {1e-4, 1, 1e5};
  Placement p;
  p.map = MapKinds[random.Index(4)];
  p.scale = random.Chance(0.5) ? Scales[random.Index(3)] : random.LogUniform(1e-4, 1e5);
  p.distance = random.Chance(0.3) ? 0 : random.LogUniform(1e-2, 10);
  return p;
}

inline kernel::Shape RandomShape(Random& random, unsigned kind, const Placement& placement) {
  kernel::Shape shape = {};
  shape.kind = kind;
  shape.mapped = 1;
  MapKind map = placement.map;
  double mapScale = placement.scale;
  switch (kind) {
    case kernel::SHAPE_SPHERE:
      // Spheres keep their size in the radius and their map a rotation, mirrored or not
      shape.a = float(placement.scale);
      if (map != MapKind::Mirrored) map = MapKind::Rigid;
      mapScale = 1;
      break;
    case kernel::SHAPE_DISK:
      shape.a = random.Chance(0.5) ? 0.0f : float(random.Uniform(0.05, 0.95));
      break;
    case kernel::SHAPE_FRUSTUM:
    case kernel::SHAPE_TUBE: {
      // Cylinders, cones of both ways up, frusta; needles and plates
      const unsigned form = random.Index(5);
      const double own = random.Chance(0.5) ? 1 : random.LogUniform(1e-3, 1e3);
      shape.a = form == 1 ? 0.0f : float(own * random.LogUniform(0.05, 5));
      shape.b = form == 0 ? shape.a : (form == 2 ? 0.0f : float(own * random.LogUniform(0.05, 5)));
      shape.c = float(own * random.LogUniform(0.05, 5));
      mapScale /= own;
      break;
    }
    case kernel::SHAPE_TORUS: {
      const double own = random.Chance(0.5) ? 1 : random.LogUniform(1e-3, 1e3);
      shape.a = float(own);
      shape.b = float(own * (random.Chance(0.1) ? 1.0 : random.LogUniform(0.005, 1)));
      mapScale /= own;
      break;
    }
  }
  glm::dmat4 m = RandomMap(random, map, mapScale, placement.distance * placement.scale / mapScale);
  shape.toWorld = ToKernel(m);
  return shape;
}

// A lower bound of the shape's extent in any direction, in the world.
inline double SmallestExtent(const kernel::Shape& s) {
  double local = 1;
  if (s.kind == kernel::SHAPE_SPHERE) local = double(s.a);
  if (s.kind == kernel::SHAPE_TORUS) local = double(s.b);
  if (s.kind == kernel::SHAPE_FRUSTUM || s.kind == kernel::SHAPE_TUBE)
    local = std::min(double(std::max(s.a, s.b)), double(s.c));
  // The largest stretch of the inverse is at most the root of the sum of its squares
  const dvec3 x(s.toWorld.rowX), y(s.toWorld.rowY), z(s.toWorld.rowZ);
  return local / std::sqrt(glm::dot(x, x) + glm::dot(y, y) + glm::dot(z, z));
}

// A point on the surface, in the shape's own space; on the infinite plane within 10 units.
inline dvec3 RandomSurfacePoint(Random& random, const ReferenceShape& s) {
  const double angle = random.Uniform(0, 6.283185307179586);
  const dvec3 round(std::cos(angle), 0, std::sin(angle));
  switch (s.kind) {
    case kernel::SHAPE_SPHERE: return random.Direction() * s.a;
    case kernel::SHAPE_ELLIPSOID: return random.Direction();
    case kernel::SHAPE_PLANE: return dvec3(random.Uniform(-10, 10), 0, random.Uniform(-10, 10));
    case kernel::SHAPE_DISK: return round * std::sqrt(random.Uniform(s.a * s.a, 1));
    case kernel::SHAPE_RECTANGLE: return dvec3(random.Uniform(0, 1), 0, -random.Uniform());
    case kernel::SHAPE_BOX: {
      dvec3 p = random.InCube();
      p[int(random.Index(3))] = random.Chance(0.5) ? 1 : -1;
      return p;
    }
    case kernel::SHAPE_FRUSTUM:
      if (random.Chance(0.4)) {
        const bool top = s.a == 0 || (s.b > 0 && random.Chance(0.5));
        return round * ((top ? s.b : s.a) * std::sqrt(random.Uniform())) +
               dvec3(0, top ? s.c : 0, 0);
      }
      [[fallthrough]];
    case kernel::SHAPE_TUBE: {
      const double y = random.Uniform();
      return round * (s.a + (s.b - s.a) * y) + dvec3(0, s.c * y, 0);
    }
  }
  const double tube = random.Uniform(0, 6.283185307179586);
  return round * (s.a + s.b * std::cos(tube)) + dvec3(0, s.b * std::sin(tube), 0);
}

// A ray in the shape's own space, in double precision.
struct LocalRay {
  dvec3 o;
  dvec3 d;
};

enum class RayKind { Outside, Inside, Grazing, AxisParallel, Far, Count };

inline LocalRay RandomRay(Random& random, const ReferenceShape& s, RayKind kind) {
  const double size = s.kind == kernel::SHAPE_PLANE ? 5 : s.Size();
  const dvec3 middle(
      0, s.kind == kernel::SHAPE_FRUSTUM || s.kind == kernel::SHAPE_TUBE ? s.c / 2 : 0, 0);
  const dvec3 target =
      random.Chance(0.5) ? RandomSurfacePoint(random, s) : middle + random.InCube() * size;
  switch (kind) {
    case RayKind::Outside: {
      const dvec3 o = middle + random.Direction() * (size * random.Uniform(1, 5));
      return {o, glm::normalize(target - o)};
    }
    case RayKind::Inside: {
      // In the bounding box; often inside
      return {middle + random.InCube() * (size * 0.6), random.Direction()};
    }
    case RayKind::Grazing: {
      const dvec3 p = RandomSurfacePoint(random, s);
      const dvec3 n = s.Normal(p);
      dvec3 d = random.Direction();
      d = glm::normalize(d - n * glm::dot(d, n));
      d = glm::normalize(d + n * (random.LogUniform(1e-6, 0.1) * (random.Chance(0.5) ? 1 : -1)));
      return {p - d * (size * random.Uniform(0.5, 3)), d};
    }
    case RayKind::AxisParallel: {
      dvec3 d(0.0);
      d[int(random.Index(3))] = random.Chance(0.5) ? 1 : -1;
      return {target - d * (size * random.Uniform(0, 4)), d};
    }
    default: {
      const dvec3 o = middle + random.Direction() * (size * 1e4);
      return {o, glm::normalize(target - o)};
    }
  }
}

// How far rounding may move the point at `t` of a ray in the shape's own space: the errors of mapping origin
// and direction, and some of the formulas. Cones are found by a quadratic that is accurate relative to the
// whole; near the apex, hits are put back onto the surface by FrustumSurface.
inline double Uncertainty(const kernel::Shape& shape, const ReferenceShape& exact, kernel::vec3 o,
                          kernel::vec3 d, double t) {
  const dvec3 q =
      glm::abs(dvec3(o) - dvec3(shape.toWorld.origin)) + glm::abs(dvec3(d)) * std::abs(t);
  double mapped = 0;
  for (const kernel::vec3 row : {shape.toWorld.rowX, shape.toWorld.rowY, shape.toWorld.rowZ})
    mapped = std::max(mapped, glm::dot(glm::abs(dvec3(row)), q));
  double slack = 16 * 0x1p-24 * (mapped + exact.Size());
  if (exact.kind == kernel::SHAPE_FRUSTUM || exact.kind == kernel::SHAPE_TUBE) {
    const double y = ExactToLocal(shape.toWorld, dvec3(o) + dvec3(d) * t).y;
    const double radius = std::abs(exact.a + (exact.b - exact.a) * y / exact.c);
    slack *= std::clamp(exact.Size() / radius, 1.0, 4096.0);
  }
  return slack;
}

}  // namespace snell::test
