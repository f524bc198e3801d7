// SPDX-License-Identifier: Apache-2.0
//
// Uniform points on simple domains from points of the unit square. Each keeps the strata of its input
// (continuous, area-preserving maps).
#ifndef SNELL_KERNEL_SAMPLING_H
#define SNELL_KERNEL_SAMPLING_H

#include "kernel/math.h"

KERNEL_BEGIN

// Uniform on the unit disk. Shirley and Chiu 1997, the concentric map.
FN vec2 SampleUniformDisk(vec2 u) {
  float x = 2.0f * u.x - 1.0f;
  float y = 2.0f * u.y - 1.0f;
  if (x == 0.0f && y == 0.0f) return vec2(0.0f, 0.0f);
  float r;
  float angle;
  if (abs(x) > abs(y)) {
    r = x;
    angle = PiOver4 * (y / x);
  } else {
    r = y;
    angle = PiOver2 - PiOver4 * (x / y);
  }
  float s;
  float c;
  SinCos(angle, s, c);
  return vec2(r * c, r * s);
}

// Barycentric coordinates of v1 and v2, uniform on a triangle. Heitz 2019, "A low-distortion map between
// triangle and square".
FN vec2 SampleUniformTriangle(vec2 u) {
  if (u.y > u.x) {
    float b = 0.5f * u.x;
    return vec2(b, u.y - b);
  }
  float b = 0.5f * u.y;
  return vec2(u.x - b, b);
}

// Uniform on the regular polygon with its corners on the unit circle, the first one at `angle`.
FN vec2 SampleUniformPolygon(uint corners, float angle, vec2 u) {
  // Choose a sector and stretch the number to be uniform again
  float count = float(corners);
  float sector = Min(floor(u.x * count), count - 1.0f);
  vec2 b = SampleUniformTriangle(vec2(u.x * count - sector, u.y));
  float s0;
  float c0;
  SinCos(angle + sector * (2.0f * Pi) / count, s0, c0);
  float s1;
  float c1;
  SinCos(angle + (sector + 1.0f) * (2.0f * Pi) / count, s1, c1);
  return vec2(b.x * c0 + b.y * c1, b.x * s0 + b.y * s1);
}

// Uniform directions in the cone around +z whose half angle has the given 1 − cosine, which keeps the
// digits of narrow cones. Density per solid angle: 1 / (2π · oneMinusCos).
FN vec3 SampleUniformCone(vec2 u, float oneMinusCos) {
  vec2 disk = SampleUniformDisk(u);
  float r2 = disk.x * disk.x + disk.y * disk.y;
  float height = r2 * oneMinusCos;  // 1 − cosine of the sample
  float scale = sqrt(Max(oneMinusCos * (2.0f - height), 0.0f));
  return vec3(disk.x * scale, disk.y * scale, 1.0f - height);
}

KERNEL_END

#endif
