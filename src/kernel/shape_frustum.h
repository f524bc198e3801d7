// SPDX-License-Identifier: Apache-2.0
//
// Cylinders and cones: the frustum around +y with radius r0 at y = 0 and r1 at y = height, closed by disks
// (a solid) or open (a tube). A solid is hit where the ray's interval within the cone and its interval
// between the disks overlap, so that no ray can slip through the rim.
#ifndef SNELL_KERNEL_SHAPE_FRUSTUM_H
#define SNELL_KERNEL_SHAPE_FRUSTUM_H

#include "kernel/math.h"
#include "kernel/shape_box.h"
#include "kernel/shape_surface.h"

KERNEL_BEGIN

// The roots of F(t) = x² + z² − (r0 + k·y)² along the ray, F < 0 inside: `tSmall` is the one of smaller
// magnitude, whose sign is exact given F(0)'s.
struct ConeRoots {
  float a;  // F's coefficient of t²
  float b;  // half its coefficient of t
  float tSmall;
  float tLarge;
  bool exist;
};

FN ConeRoots IntersectCone(vec3 o, vec3 d, float r0, float k) {
  ConeRoots roots;
  float radius = r0 + k * o.y;
  float slope = k * d.y;
  float flat2 = d.x * d.x + d.z * d.z;
  float approach = o.x * d.x + o.z * d.z;
  roots.a = flat2 - slope * slope;
  roots.b = approach - radius * slope;
  float c = (o.x * o.x + o.z * o.z) - radius * radius;

  // The discriminant is the same from every point of the ray: take the one nearest to the axis
  float tClosest = flat2 > 0.0f ? -approach / flat2 : 0.0f;
  vec3 q = o + tClosest * d;
  float closestRadius = r0 + k * q.y;
  float closestB = (q.x * d.x + q.z * d.z) - closestRadius * slope;
  float closestC = (q.x * q.x + q.z * q.z) - closestRadius * closestRadius;
  float discriminant = closestB * closestB - roots.a * closestC;

  // A ray steeper than the cone always meets both of its halves
  roots.exist = discriminant >= 0.0f || roots.a < 0.0f;
  float s = -(roots.b + CopySign(SafeSqrt(discriminant), roots.b));
  roots.tSmall = s == 0.0f ? 0.0f : c / s;
  roots.tLarge = roots.a == 0.0f ? -CopySign(Infinite, roots.b) : s / roots.a;
  return roots;
}

FN float IntersectFrustum(vec3 o, vec3 d, float r0, float r1, float height) {
  float k = (r1 - r0) / height;
  ConeRoots roots = IntersectCone(o, d, r0, k);
  if (!roots.exist) return -1.0f;
  vec2 slab = SlabInterval(o.y, d.y, 0.0f, height);
  float first = Min(roots.tSmall, roots.tLarge);
  float last = Max(roots.tSmall, roots.tLarge);
  if (roots.a < 0.0f) {
    // Inside the cone beyond its roots: after the last if the cone widens along the ray, else before the
    // first
    if (k * d.y > 0.0f) {
      first = last;
      last = Infinite;
    } else {
      last = first;
      first = -Infinite;
    }
  } else if (roots.a == 0.0f && roots.b == 0.0f) {
    // Parallel to the axis of a cylinder: inside all along or never
    bool inside = o.x * o.x + o.z * o.z <= r0 * r0;
    if (!inside) return -1.0f;
    first = -Infinite;
    last = Infinite;
  }
  return FirstOfInterval(Max(first, slab.x), Min(last, slab.y));
}

FN float IntersectTube(vec3 o, vec3 d, float r0, float r1, float height) {
  ConeRoots roots = IntersectCone(o, d, r0, (r1 - r0) / height);
  if (!roots.exist) return -1.0f;
  float first = Min(roots.tSmall, roots.tLarge);
  float last = Max(roots.tSmall, roots.tLarge);
  float y = o.y + first * d.y;
  if (first > 0.0f && y >= 0.0f && y <= height) return first;
  y = o.y + last * d.y;
  return last > 0.0f && last < Infinite && y >= 0.0f && y <= height ? last : -1.0f;
}

FN LocalSurface FrustumSurface(vec3 o, vec3 d, float r0, float r1, float height, bool closed,
                               float t) {
  LocalSurface s;
  s.p = o + t * d;
  float k = (r1 - r0) / height;
  float fromAxis = sqrt(s.p.x * s.p.x + s.p.z * s.p.z);
  float sideDistance = abs(fromAxis - (r0 + k * s.p.y)) / sqrt(1.0f + k * k);
  float bottomDistance = abs(s.p.y);
  float topDistance = abs(s.p.y - height);
  if (closed && Min(bottomDistance, topDistance) < sideDistance) {
    bool top = topDistance < bottomDistance;
    float side = top ? 1.0f : -1.0f;
    float radius = top ? r1 : r0;
    s.p.y = top ? height : 0.0f;
    s.error = vec3(0.0f, 0.0f, 0.0f);
    s.n = vec3(0.0f, side, 0.0f);
    s.dpdu = vec3(2.0f * radius, 0.0f, 0.0f);
    s.uv = vec2(0.5f + 0.5f * s.p.x / radius, 0.5f - 0.5f * side * s.p.z / radius);
    return s;
  }

  // Put the point back onto the side, at its height
  float radius = Max(r0 + k * s.p.y, 0.0f);
  float scale = fromAxis > 0.0f ? radius / fromAxis : 0.0f;
  s.p = vec3(s.p.x * scale, s.p.y, s.p.z * scale);
  s.error = Abs(s.p) * Gamma(8.0f) + vec3(1.0f, 0.0f, 1.0f) * ((r0 + abs(k * s.p.y)) * Gamma(4.0f));
  vec3 outward = fromAxis > 0.0f ? vec3(o.x + t * d.x, 0.0f, o.z + t * d.z) / fromAxis
                                 : vec3(0.0f, 0.0f, 1.0f);
  s.n = vec3(outward.x, -k, outward.z);
  s.dpdu = vec3(s.p.z, 0.0f, -s.p.x) * (2.0f * Pi);
  s.uv = vec2(0.5f + Atan2(outward.x, outward.z) * Inv2Pi, s.p.y / height);
  return s;
}

KERNEL_END

#endif
