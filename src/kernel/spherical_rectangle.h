// SPDX-License-Identifier: Apache-2.0
//
// Directions to a rectangle, uniform over the solid angle that it fills (Ureña, Fajardo and King 2013, "An area-preserving
// parametrization for spherical rectangles"). Samples of its area alone crowd where it is far or seen edge on.
#ifndef SNELL_KERNEL_SPHERICAL_RECTANGLE_H
#define SNELL_KERNEL_SPHERICAL_RECTANGLE_H

#include "kernel/math.h"

KERNEL_BEGIN

// A rectangle as seen from a point, in a frame whose x and y run along its edges and where it lies at z < 0.
struct SphericalRectangle {
  float solidAngle;  // steradians; 0: too small for its own formula, or no rectangle
  vec3 x;
  vec3 y;
  vec3 z;
  vec2 lower;  // of its corners in the frame
  vec2 upper;
  float depth;  // its z
  float b0;     // of the normals of the planes through the point and an edge
  float b1;
  float k;
};

// Below this many steradians a rectangle's area will do, which costs half as much and hardly more noise; below 0.02
// single precision would spoil the formula.
CONST float LeastSphericalRectangle = 0.1f;

FN SphericalRectangle SphericalRectangleAt(vec3 p, vec3 corner, vec3 edgeU, vec3 edgeV) {
  SphericalRectangle r;
  r.solidAngle = 0.0f;
  float lengthU = Length(edgeU);
  float lengthV = Length(edgeV);
  r.x = edgeU / lengthU;
  r.y = edgeV / lengthV;
  r.z = Cross(r.x, r.y);
  vec3 d = corner - p;
  r.depth = Dot(d, r.z);
  r.lower = vec2(Dot(d, r.x), Dot(d, r.y));
  r.upper = r.lower + vec2(lengthU, lengthV);
  r.b0 = 0.0f;
  r.b1 = 0.0f;
  r.k = 0.0f;
  if (abs(Dot(r.x, r.y)) > 1e-4f) return r;
  if (r.depth > 0.0f) {
    r.z = -r.z;
    r.depth = -r.depth;
  }

  // Bound the solid angle by the nearest point
  float besideX = Max(Max(r.lower.x, -r.upper.x), 0.0f);
  float besideY = Max(Max(r.lower.y, -r.upper.y), 0.0f);
  float nearest2 = besideX * besideX + besideY * besideY + r.depth * r.depth;
  float bound = lengthU * lengthV * -r.depth;
  if (bound <= LeastSphericalRectangle * nearest2 * sqrt(nearest2)) return r;

  // Normals of the four planes, of which two components are not 0
  float zz = r.depth * r.depth;
  float scale0 = 1.0f / sqrt(zz + Sqr(r.lower.y));
  float scale1 = 1.0f / sqrt(zz + Sqr(r.upper.x));
  float scale2 = 1.0f / sqrt(zz + Sqr(r.upper.y));
  float scale3 = 1.0f / sqrt(zz + Sqr(r.lower.x));
  float z0 = -r.lower.y * scale0;
  float z1 = r.upper.x * scale1;
  float z2 = r.upper.y * scale2;
  float z3 = -r.lower.x * scale3;
  float g0 = Acos(-z0 * z1);
  float g1 = Acos(-z1 * z2);
  float g2 = Acos(-z2 * z3);
  float g3 = Acos(-z3 * z0);
  r.b0 = z0;
  r.b1 = z2;
  r.k = 2.0f * Pi - g2 - g3;
  float solidAngle = g0 + g1 - r.k;
  if (solidAngle > LeastSphericalRectangle) r.solidAngle = solidAngle;
  return r;
}

// A point of the rectangle, relative to the point that sees it; uniform in solid angle, whose density is
// 1 / solidAngle.
FN vec3 SampleSphericalRectangle(IN(SphericalRectangle) r, vec2 u) {
  float angle = u.x * r.solidAngle + r.k;
  float sine;
  float cosine;
  SinCos(angle, sine, cosine);
  float f = (cosine * r.b0 - r.b1) / (abs(sine) > 1e-7f ? sine : 1e-7f);
  float cu = Clamp(CopySign(1.0f, f) / sqrt(f * f + r.b0 * r.b0), -1.0f, 1.0f);
  float x = Clamp(-(cu * r.depth) / Max(SafeSqrt(1.0f - cu * cu), 1e-7f), r.lower.x, r.upper.x);
  float d2 = x * x + r.depth * r.depth;
  float low = r.lower.y / sqrt(d2 + Sqr(r.lower.y));
  float high = r.upper.y / sqrt(d2 + Sqr(r.upper.y));
  float h = Lerp(u.y, low, high);
  float y = h * h < 0.999999f ? h * sqrt(d2) / sqrt(1.0f - h * h) : r.upper.y;
  return r.x * x + r.y * Clamp(y, r.lower.y, r.upper.y) + r.z * r.depth;
}

KERNEL_END

#endif
