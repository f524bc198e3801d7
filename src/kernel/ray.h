// SPDX-License-Identifier: Apache-2.0
//
// Where surfaces are met and how rays leave them. No epsilon is tuned by hand: every surface point carries
// a bound of its rounding error, and a new ray starts just outside that bound (pbrt-v4, section 6.8).
#ifndef SNELL_KERNEL_RAY_H
#define SNELL_KERNEL_RAY_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// A point on a surface, in world space.
struct SurfaceInteraction {
  float t;  // along the ray, in units of its direction's length
  vec3 p;
  vec3 pError;  // bound of p's error per coordinate
  vec3 n;       // geometric unit normal, to the outside of the surface
  vec3 ns;      // shading normal, unit, on the same side
  vec3 dpdu;    // change of p with u; not normalized, may be zero
  vec3 dpdv;
  vec3 tangent;      // along which normal maps' x points; need not have unit length
  float handedness;  // 1 or −1: their y points along it times cross(ns, tangent)
  vec2 uv;
  vec2 uv1;         // the second coordinates
  float uvDensity;  // how far uv changes in a metre, about
  float time;       // as the ray's
  float footprint;  // diameter of what the ray sees of the surface, in metres
  Spectrum color;   // of the vertices
  float alpha;
  uint object;
};

// A start for rays that leave p in the direction w: outside the error box, on w's side of the surface.
FN vec3 OffsetRayOrigin(vec3 p, vec3 pError, vec3 n, vec3 w) {
  float distance = Dot(Abs(n), pError);
  vec3 offset = Dot(w, n) < 0.0f ? -distance * n : distance * n;
  vec3 o = p + offset;
  if (offset.x > 0.0f) o.x = NextFloatUp(o.x);
  if (offset.x < 0.0f) o.x = NextFloatDown(o.x);
  if (offset.y > 0.0f) o.y = NextFloatUp(o.y);
  if (offset.y < 0.0f) o.y = NextFloatDown(o.y);
  if (offset.z > 0.0f) o.z = NextFloatUp(o.z);
  if (offset.z < 0.0f) o.z = NextFloatDown(o.z);
  return o;
}

KERNEL_END

#endif
