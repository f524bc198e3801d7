// SPDX-License-Identifier: Apache-2.0
#include "scene/bounds.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace snell::scene {

void Box3::Extend(glm::dvec3 p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return;
  lower = glm::min(lower, p);
  upper = glm::max(upper, p);
}

void Box3::Extend(const Box3& other) {
  lower = glm::min(lower, other.lower);
  upper = glm::max(upper, other.upper);
}

namespace {

// Collects the box of a geometry after the object's transform.
struct Collector {
  const Scene& scene;
  Affine toWorld;
  Box3 box = {};

  void AddPoint(glm::dvec3 p) { box.Extend(glm::dvec3(toWorld * glm::dvec4(p, 1))); }

  // A disk around `center` spanned by any two orthogonal half-axes a and b.
  void AddEllipse(glm::dvec3 center, glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 c(toWorld * glm::dvec4(center, 1));
    const glm::dvec3 wa(toWorld * glm::dvec4(a, 0)), wb(toWorld * glm::dvec4(b, 0));
    const glm::dvec3 half = glm::sqrt(wa * wa + wb * wb);
    box.Extend(c - half);
    box.Extend(c + half);
  }
  void AddCircle(glm::dvec3 center, glm::dvec3 normal, double radius) {
    const glm::dvec3 n = glm::normalize(normal);
    const glm::dvec3 helper = std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 a = glm::normalize(glm::cross(n, helper));
    AddEllipse(center, a * radius, glm::cross(n, a) * radius);
  }
  void AddBox(glm::dvec3 lower, glm::dvec3 upper) {
    for (int corner = 0; corner < 8; ++corner) {
      AddPoint({corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y,
                corner & 4 ? upper.z : lower.z});
    }
  }

  void operator()(const Sphere& s) {
    const glm::dvec3 c(toWorld * glm::dvec4(glm::dvec3(s.center), 1));
    const glm::dvec3 x(toWorld[0]), y(toWorld[1]), z(toWorld[2]);
    const glm::dvec3 half = glm::sqrt(x * x + y * y + z * z) * double(s.radius);
    box.Extend(c - half);
    box.Extend(c + half);
  }
  void operator()(const Plane&) {}
  void operator()(const Disk& s) {
    AddCircle(glm::dvec3(s.center), glm::dvec3(s.normal), double(s.radius));
  }
  void operator()(const Rectangle& s) {
    const glm::dvec3 corner(s.corner), u(s.edgeU), v(s.edgeV);
    for (const glm::dvec3 p : {corner, corner + u, corner + v, corner + u + v}) AddPoint(p);
  }
  void operator()(const Box& s) { AddBox(glm::dvec3(s.lower), glm::dvec3(s.upper)); }
  void operator()(const Cone& s) {
    const glm::dvec3 axis = glm::dvec3(s.top) - glm::dvec3(s.base);
    AddCircle(glm::dvec3(s.base), axis, double(s.radius));
    AddCircle(glm::dvec3(s.top), axis, double(s.topRadius));
  }
  void operator()(const Torus& s) {
    // A box around the whole would do; the two extreme circles and the tube's thickness are tighter
    const glm::dvec3 axis = glm::normalize(glm::dvec3(s.axis)) * double(s.minorRadius);
    AddCircle(glm::dvec3(s.center) + axis, axis, double(s.majorRadius + s.minorRadius));
    AddCircle(glm::dvec3(s.center) - axis, axis, double(s.majorRadius + s.minorRadius));
  }
  void operator()(const MeshGeometry& g) {
    for (const vec3 p : scene.meshes[std::size_t(g.mesh)].positions) AddPoint(glm::dvec3(p));
  }
};

}  // namespace

static Box3 BoundsOf(const Scene& scene, const Object& object, const Affine& map) {
  Collector collector{scene, map * object.toWorld};
  std::visit(collector, object.geometry);
  return collector.box;
}

Box3 BoundsOf(const Scene& scene, const Object& object) {
  return BoundsOf(scene, object, Affine(1.0));
}

Box3 BoundsOf(const Scene& scene, const Affine& map) {
  Box3 box;
  for (const Object& object : scene.objects) box.Extend(BoundsOf(scene, object, map));
  return box;
}

}  // namespace snell::scene
