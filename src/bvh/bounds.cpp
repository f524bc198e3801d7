// SPDX-License-Identifier: Apache-2.0
#include "bvh/bounds.h"

#include <cmath>
#include <glm/common.hpp>

#include "kernel/motion.h"

namespace snell::bvh {

using kernel::Abs;
using kernel::Transform;

Bounds TriangleBounds(const Geometry& geometry, std::uint32_t index) {
  const kernel::Triangle& triangle = geometry.triangles[index];
  const bool deforms = geometry.IsDeforming(index);
  const std::uint32_t steps = deforms ? geometry.meshes[triangle.mesh].steps : 0;
  const std::uint32_t stride = deforms ? geometry.meshes[triangle.mesh].stride : 0;
  Bounds bounds;
  for (std::uint32_t key = 0; key <= steps; ++key) {
    for (const std::uint32_t v : {triangle.v0, triangle.v1, triangle.v2}) {
      const vec3 p = geometry.positions[v + key * stride];
      // A NaN would be passed over by min and max
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        return {vec3(-std::numeric_limits<float>::infinity()),
                vec3(std::numeric_limits<float>::infinity())};
      bounds.Extend(p);
    }
  }
  if (!deforms) return bounds;
  // By what positions between keys are rounded
  const vec3 margin = (Abs(bounds.lower) + Abs(bounds.upper)) * kernel::Gamma(4.0f);
  return {bounds.lower - margin, bounds.upper + margin};
}

// Widen by what transforming a point may lose.
static Bounds Widened(Bounds bounds) {
  const vec3 margin = (Abs(bounds.lower) + Abs(bounds.upper)) * kernel::Gamma(16.0f);
  return {bounds.lower - margin, bounds.upper + margin};
}

Bounds TransformedBounds(const Transform& m, const Bounds& local) {
  return TransformedBounds(m, {&local, 1});
}

Bounds TransformedBounds(const Transform& m, std::span<const Bounds> parts) {
  const auto vector = [](vec3 v) { return Vec4{v.x, v.y, v.z, 0}; };
  const Vec4 x = vector(m.x), y = vector(m.y), z = vector(m.z), origin = vector(m.origin);
  const Vec4 sizeX = vector(Abs(m.x)), sizeY = vector(Abs(m.y)), sizeZ = vector(Abs(m.z));
  Box whole, world;
  for (const Bounds& part : parts) {
    const vec3 center = part.Center(), half = part.Size() * 0.5f;
    const Vec4 worldCenter = x * center.x + y * center.y + z * center.z + origin;
    const Vec4 worldHalf = sizeX * half.x + sizeY * half.y + sizeZ * half.z;
    world.Extend(worldCenter - worldHalf);
    world.Extend(worldCenter + worldHalf);
    whole.Extend(BoxOf(part));
  }
  const Bounds local = BoundsOf(whole), bounds = BoundsOf(world);
  if (local.Empty()) return bounds;
  const vec3 reach = Abs(local.Center()) + local.Size() * 0.5f;
  const vec3 margin = kernel::ToWorldPointError(m, reach, vec3(0.0f), bounds.Center());
  return Widened({bounds.lower - margin, bounds.upper + margin});
}

// The box of the ellipse with the half-axes a and b around the origin.
static vec3 EllipseHalf(vec3 a, vec3 b) {
  return {std::hypot(a.x, b.x), std::hypot(a.y, b.y), std::hypot(a.z, b.z)};
}

Bounds ShapeBounds(const kernel::Shape& shape) {
  const Transform& m = shape.toWorld;
  const vec3 origin = m.origin;
  switch (shape.kind) {
    case kernel::SHAPE_SPHERE: return Widened({origin - shape.a, origin + shape.a});
    case kernel::SHAPE_ELLIPSOID: {
      const vec3 ring = EllipseHalf(m.x, m.y);
      const vec3 half(std::hypot(ring.x, m.z.x), std::hypot(ring.y, m.z.y),
                      std::hypot(ring.z, m.z.z));
      return Widened({origin - half, origin + half});
    }
    case kernel::SHAPE_PLANE:
      return {vec3(-std::numeric_limits<float>::infinity()),
              vec3(std::numeric_limits<float>::infinity())};
    case kernel::SHAPE_DISK: {
      const vec3 half = EllipseHalf(m.x, m.z);
      return Widened({origin - half, origin + half});
    }
    case kernel::SHAPE_RECTANGLE: return TransformedBounds(m, {vec3(0, 0, -1), vec3(1, 0, 0)});
    case kernel::SHAPE_BOX: return TransformedBounds(m, {vec3(-1.0f), vec3(1.0f)});
    case kernel::SHAPE_FRUSTUM:
    case kernel::SHAPE_TUBE: {
      // The convex hull of its two circles
      const vec3 ring = EllipseHalf(m.x, m.z);
      const vec3 top = origin + m.y * shape.c;
      Bounds bounds{origin - ring * shape.a, origin + ring * shape.a};
      bounds.Extend(Bounds{top - ring * shape.b, top + ring * shape.b});
      return Widened(bounds);
    }
    case kernel::SHAPE_TORUS: {
      const float outer = shape.a + shape.b;
      return TransformedBounds(m, {vec3(-outer, -shape.b, -outer), vec3(outer, shape.b, outer)});
    }
  }
  return {};
}

// The box of a box on its way: points move straight from key to key. Wider than for what stands still by what the
// inverse of a map between two keys may lose (kernel::InverseError).
static Bounds MovingBounds(const Geometry& geometry, std::uint32_t object,
                           std::span<const Bounds> parts) {
  const kernel::Object& mover = geometry.objects[object];
  vec3 reach(0.0f);
  for (const Bounds& part : parts)
    reach = glm::max(reach, glm::max(Abs(part.lower), Abs(part.upper)));
  Bounds bounds;
  float margin = 0;
  for (std::uint32_t i = 0; i <= mover.motionSteps; ++i) {
    const kernel::MotionKey& key = geometry.motions[mover.motion + i];
    const kernel::Transform place = kernel::PlaceBetween(key, key, 0.0f);
    bounds.Extend(TransformedBounds(place, parts));
    const vec3 far = Abs(place.x) * reach.x + Abs(place.y) * reach.y + Abs(place.z) * reach.z;
    const vec3 error = kernel::InverseError(place, place.origin + far);
    margin = std::max(margin, 2 * error.x);
  }
  return {bounds.lower - margin, bounds.upper + margin};
}

Bounds PlacedBounds(const Geometry& geometry, const kernel::Shape& shape) {
  const Bounds own = ShapeBounds(shape);
  return geometry.IsMoving(shape.object) && own.Finite()
             ? MovingBounds(geometry, shape.object, {&own, 1})
             : own;
}

Bounds PlacedBounds(const Geometry& geometry, const kernel::Instance& instance,
                    std::span<const Bounds> parts) {
  return geometry.IsMoving(instance.object) ? MovingBounds(geometry, instance.object, parts)
                                            : TransformedBounds(instance.toWorld, parts);
}

}  // namespace snell::bvh
