// SPDX-License-Identifier: Apache-2.0
//
// Applying affine maps (types.h) to points, directions and normals, with bounds of the rounding error.
#ifndef SNELL_KERNEL_TRANSFORM_H
#define SNELL_KERNEL_TRANSFORM_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

FN vec3 ToWorldVector(IN(Transform) m, vec3 v) { return m.x * v.x + m.y * v.y + m.z * v.z; }
FN vec3 ToWorldPoint(IN(Transform) m, vec3 p) { return ToWorldVector(m, p) + m.origin; }

FN vec3 ToLocalVector(IN(Transform) m, vec3 v) {
  return vec3(Dot(m.rowX, v), Dot(m.rowY, v), Dot(m.rowZ, v));
}
FN vec3 ToLocalPoint(IN(Transform) m, vec3 p) { return ToLocalVector(m, p - m.origin); }

// Normals map by the inverse's transpose, which keeps them outward under mirroring. Not normalized.
FN vec3 ToWorldNormal(IN(Transform) m, vec3 n) {
  return m.rowX * n.x + m.rowY * n.y + m.rowZ * n.z;
}

FN Ray ToLocalRay(IN(Transform) m, vec3 o, vec3 d) {
  Ray ray;
  ray.o = ToLocalPoint(m, o);
  ray.d = ToLocalVector(m, d);
  ray.time = 0.0f;
  return ray;
}

// Bound, per coordinate, of the error of ToWorldPoint(m, p) when p is itself off by at most `error`.
// `world` is the result.
FN vec3 ToWorldPointError(IN(Transform) m, vec3 p, vec3 error, vec3 world) {
  vec3 local = Abs(m.x) * (abs(p.x) * Gamma(8.0f) + error.x) +
               Abs(m.y) * (abs(p.y) * Gamma(8.0f) + error.y) +
               Abs(m.z) * (abs(p.z) * Gamma(8.0f) + error.z);
  return local + Abs(world) * Gamma(4.0f);
}

// How far a point near `world` seems to move, along the world's normal of a surface, when it is mapped back
// into the local space with rounding. `n` is the surface's local normal and `nLength` the length of
// ToWorldNormal(m, n).
FN float ToLocalError(IN(Transform) m, vec3 world, vec3 n, float nLength) {
  vec3 q = Abs(world - m.origin);
  vec3 local = vec3(Dot(Abs(m.rowX), q), Dot(Abs(m.rowY), q), Dot(Abs(m.rowZ), q)) * Gamma(6.0f);
  return Dot(Abs(n), local) / nLength;
}

KERNEL_END

#endif
