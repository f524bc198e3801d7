// SPDX-License-Identifier: Apache-2.0
//
// Spheres around the origin of their space; ellipsoids are unit spheres under an affine map. The axis of
// the texture coordinates is +y, their seam lies at −z. Discriminant: Haines et al. 2019, "Precision
// improvements for ray/sphere intersection" (Ray Tracing Gems, chapter 7).
#ifndef SNELL_KERNEL_SHAPE_SPHERE_H
#define SNELL_KERNEL_SHAPE_SPHERE_H

#include "kernel/math.h"
#include "kernel/shape_surface.h"

KERNEL_BEGIN

// The nearest hit at t > 0, or −1. A ray that starts inside always finds its exit: whether the start is
// inside is decided by the sign of one exact-to-rounding quantity, not by comparing t with an epsilon.
FN float IntersectSphere(vec3 o, vec3 d, float radius) {
  float a = Dot(d, d);
  float tClosest = -Dot(o, d) / a;
  float c = Dot(o, o) - radius * radius;
  bool outside = c > 0.0f;
  if (outside && tClosest <= 0.0f) return -1.0f;

  // Half the chord, from the distance of the ray's line to the centre
  vec3 closest = o + tClosest * d;
  float h = radius * radius - Dot(closest, closest);
  if (outside && h < 0.0f) return -1.0f;
  float halfChord = sqrt(Max(h, 0.0f) / a);

  // Take the root that loses no digits, and the other one from the product of the roots
  if (outside) return c / (a * (tClosest + halfChord));
  return tClosest >= 0.0f ? tClosest + halfChord : c / (a * (tClosest - halfChord));
}

// Texture coordinates at the point n of the unit sphere, and the change of the point with u.
FN vec2 SphereUv(vec3 n) { return vec2(0.5f + Atan2(n.x, n.z) * Inv2Pi, 0.5f + Asin(n.y) * InvPi); }
FN vec3 SphereDpdu(vec3 n) { return vec3(n.z, 0.0f, -n.x) * (2.0f * Pi); }

// The surface of the unit sphere.
FN LocalSurface UnitSphereSurface(vec3 o, vec3 d, float t, bool mapped) {
  LocalSurface s;
  s.p = Normalize(o + t * d);
  s.error = Abs(s.p) * Gamma(8.0f);
  s.n = s.p;
  s.uv = vec2(0.0f, 0.0f);
  if (mapped) s.uv = SphereUv(s.n);
  s.dpdu = SphereDpdu(s.n);
  return s;
}

KERNEL_END

#endif
