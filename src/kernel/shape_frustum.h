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
  bool inside;  // F(0) < 0: o is inside the cone or its mirror image beyond the apex
};

FN ConeRoots IntersectCone(vec3 o, vec3 d, float r0, float k) {
  ConeRoots roots;
  float radius = r0 + k * o.y;
  float slope = k * d.y;
  roots.a = (d.x * d.x + d.z * d.z) - slope * slope;
  roots.b = (o.x * d.x + o.z * d.z) - radius * slope;
  float c = (o.x * o.x + o.z * o.z) - radius * radius;
  roots.inside = c < 0.0f;

  // Of two equal forms of the discriminant take that with the smaller terms: b² − a·c, or by Lagrange's
  // identity a difference of two squares that are the same at every point of the ray
  float mx = radius * d.x - slope * o.x;
  float mz = radius * d.z - slope * o.z;
  float m2 = mx * mx + mz * mz;
  float b2 = roots.b * roots.b;
  float cross = o.x * d.z - o.z * d.x;
  float discriminant = m2 < b2 ? m2 - cross * cross : b2 - roots.a * c;

  // A ray steeper than the cone always meets both of its halves
  roots.exist = discriminant >= 0.0f || roots.a < 0.0f;
  float s = -(roots.b + CopySign(SafeSqrt(discriminant), roots.b));
  roots.tSmall = s == 0.0f ? 0.0f : c / s;
  roots.tLarge = roots.a == 0.0f ? -CopySign(Infinite, roots.b) : s / roots.a;
  return roots;
}

// Where to begin on a ray: at its origin, or, if that is far away, at the point nearest to the middle of the
// frustum, so that distance costs no digits.
FN float FrustumStart(vec3 o, vec3 d, float r0, float r1, float height) {
  vec3 toMiddle = vec3(-o.x, 0.5f * height - o.y, -o.z);
  float reach = 4.0f * (r0 + r1 + height);
  return LengthSquared(toMiddle) <= reach * reach ? 0.0f : Dot(toMiddle, d) / Dot(d, d);
}

// Where a ray meets a closed frustum, and on which of its faces.
CONST uint FRUSTUM_SIDE = 0u;
CONST uint FRUSTUM_BOTTOM = 1u;
CONST uint FRUSTUM_TOP = 2u;
struct FrustumHit {
  float t;  // ≤ 0: no hit
  uint face;
};

FN FrustumHit FindFrustumHit(vec3 origin, vec3 d, float r0, float r1, float height) {
  FrustumHit hit;
  hit.t = -1.0f;
  hit.face = FRUSTUM_SIDE;
  float start = FrustumStart(origin, d, r0, r1, height);
  if (start < 0.0f) return hit;
  vec3 o = origin + start * d;
  float k = (r1 - r0) / height;
  ConeRoots roots = IntersectCone(o, d, r0, k);
  vec2 slab = SlabInterval(o.y, d.y, 0.0f, height);
  float first = Min(roots.tSmall, roots.tLarge);
  float last = Max(roots.tSmall, roots.tLarge);
  if (start == 0.0f && roots.inside && o.y >= 0.0f && o.y <= height) {
    // From inside the way out is the first root ahead, whatever rounding says of the others
    float steep = roots.a > 0.0f ? 0.0f : Infinite;
    last = first > 0.0f ? first : (last > 0.0f ? last : steep);
    first = -Infinite;
  } else if (!roots.exist) {
    return hit;
  } else if (roots.a < 0.0f) {
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
    if (!roots.inside) return hit;
    first = -Infinite;
    last = Infinite;
  }

  // The ray enters by the later and leaves by the earlier of side and disks
  float enter = Max(first, slab.x);
  float leave = Min(last, slab.y);
  if (enter > leave) return hit;
  if (start + enter > 0.0f) {
    hit.t = start + enter;
    if (slab.x >= first) hit.face = d.y > 0.0f ? FRUSTUM_BOTTOM : FRUSTUM_TOP;
  } else if (start + leave > 0.0f) {
    hit.t = start + leave;
    if (slab.y <= last) hit.face = d.y > 0.0f ? FRUSTUM_TOP : FRUSTUM_BOTTOM;
  }
  return hit;
}

FN float IntersectFrustum(vec3 o, vec3 d, float r0, float r1, float height) {
  return FindFrustumHit(o, d, r0, r1, height).t;
}

FN float IntersectTube(vec3 origin, vec3 d, float r0, float r1, float height) {
  float start = FrustumStart(origin, d, r0, r1, height);
  if (start < 0.0f) return -1.0f;
  vec3 o = origin + start * d;
  float k = (r1 - r0) / height;
  ConeRoots roots = IntersectCone(o, d, r0, k);
  bool parallel = roots.a == 0.0f && roots.b == 0.0f;
  if (!roots.exist || parallel) return -1.0f;
  float first = Min(roots.tSmall, roots.tLarge);
  float last = Max(roots.tSmall, roots.tLarge);
  if (roots.a < 0.0f) {
    // One of the roots is on the mirror image beyond the apex
    if (k * d.y > 0.0f) {
      first = last;
    } else {
      last = first;
    }
  }
  float y = o.y + first * d.y;
  if (start + first > 0.0f && y >= 0.0f && y <= height) return start + first;
  y = o.y + last * d.y;
  if (start + last > 0.0f && last < Infinite && y >= 0.0f && y <= height) return start + last;
  return -1.0f;
}

// The surface of a disk that closes a frustum; `side` is 1 at the top and −1 at the bottom.
FN LocalSurface FrustumDiskSurface(vec3 p, float y, float radius, float side) {
  LocalSurface s;
  s.p = vec3(p.x, y, p.z);
  s.error = vec3(0.0f, 0.0f, 0.0f);
  s.n = vec3(0.0f, side, 0.0f);
  s.dpdu = vec3(2.0f * radius, 0.0f, 0.0f);
  s.uv = vec2(0.5f + 0.5f * p.x / radius, 0.5f - 0.5f * side * p.z / radius);
  return s;
}

// The side of a frustum or a tube.
FN LocalSurface FrustumSideSurface(vec3 p, float r0, float r1, float height, bool mapped) {
  LocalSurface s;
  float k = (r1 - r0) / height;
  float fromAxis = sqrt(p.x * p.x + p.z * p.z);
  vec3 outward = fromAxis > 0.0f ? vec3(p.x, 0.0f, p.z) / fromAxis : vec3(0.0f, 0.0f, 1.0f);

  // Put the point back onto the side, at its height
  float y = Clamp(p.y, 0.0f, height);
  float radius = Max(r0 + k * y, 0.0f);
  s.p = vec3(outward.x * radius, y, outward.z * radius);
  s.error = Abs(s.p) * Gamma(8.0f) + vec3(1.0f, 0.0f, 1.0f) * (Max(r0, r1) * Gamma(4.0f));
  s.n = vec3(outward.x, -k, outward.z);
  s.dpdu = vec3(s.p.z, 0.0f, -s.p.x) * (2.0f * Pi);
  s.uv = vec2(0.0f, 0.0f);
  if (mapped) s.uv = vec2(0.5f + Atan2(outward.x, outward.z) * Inv2Pi, y / height);
  return s;
}

FN LocalSurface FrustumSurface(vec3 o, vec3 d, float r0, float r1, float height, float t,
                               bool mapped) {
  vec3 p = o + t * d;
  uint face = FindFrustumHit(o, d, r0, r1, height).face;
  if (face == FRUSTUM_BOTTOM && r0 > 0.0f) return FrustumDiskSurface(p, 0.0f, r0, -1.0f);
  if (face == FRUSTUM_TOP && r1 > 0.0f) return FrustumDiskSurface(p, height, r1, 1.0f);
  return FrustumSideSurface(p, r0, r1, height, mapped);
}

FN LocalSurface TubeSurface(vec3 o, vec3 d, float r0, float r1, float height, float t,
                            bool mapped) {
  return FrustumSideSurface(o + t * d, r0, r1, height, mapped);
}

// The point p of a closed frustum, with its normal n, moved away from rims and apex by `margin` per
// coordinate, so that a ray that starts there and goes in starts inside.
FN vec3 InsetFrustumPoint(vec3 p, vec3 n, float r0, float r1, float height, vec3 margin) {
  float k = (r1 - r0) / height;
  float sideways = Max(margin.x, margin.z) + abs(k) * margin.y;
  if (n.x == 0.0f && n.z == 0.0f) {
    // On a disk: towards the axis
    float fromAxis = sqrt(p.x * p.x + p.z * p.z);
    float limit = Max((n.y > 0.0f ? r1 : r0) - sideways, 0.0f);
    float scale = fromAxis > limit ? limit / fromAxis : 1.0f;
    return vec3(p.x * scale, p.y, p.z * scale);
  }
  // On the side: along it, between the disks and to where the cone is thick enough, also for starts that
  // move sideways along its curve
  float lower = margin.y;
  float upper = height - margin.y;
  if (k > 0.0f) lower = Max(lower, (4.0f * sideways - r0) / k);
  if (k < 0.0f) upper = Min(upper, (4.0f * sideways - r0) / k);
  float y = lower < upper ? Clamp(p.y, lower, upper) : 0.5f * height;
  float radius = r0 + k * y;
  return vec3(n.x * radius, y, n.z * radius);
}

KERNEL_END

#endif
