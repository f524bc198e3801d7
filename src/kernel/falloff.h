// SPDX-License-Identifier: Apache-2.0
//
// How a light's effect fades: with distance, towards its range, and towards the rim of a spot's cone.
#ifndef SNELL_KERNEL_FALLOFF_H
#define SNELL_KERNEL_FALLOFF_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// What an intensity is multiplied by to get irradiance on a facing surface. Physical light falls off with
// the inverse square; the linear law and none at all are the classic teaching models.
FN float DistanceFalloff(uint kind, float distance, float factor) {
  switch (kind) {
    case FALLOFF_NONE: return 1.0f;
    case FALLOFF_LINEAR: return 1.0f / (distance * factor);
  }
  return 1.0f / (distance * distance);
}

// 1 near the light, 0 beyond its range, with a smooth end: (1 − (d/range)⁴)² (Karis 2013, "Real shading in
// Unreal Engine 4"). A range of 0 is none.
FN float RangeWindow(float distance, float range) {
  if (range <= 0.0f) return 1.0f;
  float x = distance / range;
  return Sqr(Max(1.0f - Sqr(x * x), 0.0f));
}

// 1 inside a spot's inner cone, 0 outside its outer cone, a smooth step of the cosine between.
FN float SpotFalloff(float cosAngle, float cosInner, float cosOuter) {
  if (cosAngle >= cosInner) return 1.0f;
  if (cosAngle <= cosOuter) return 0.0f;
  return SmoothStep(cosOuter, cosInner, cosAngle);
}

KERNEL_END

#endif
