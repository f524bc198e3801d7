// SPDX-License-Identifier: Apache-2.0
//
// The watertight ray–triangle test of Woop, Benthin and Wald 2013 (JCGT 2:1): space is sheared so that the
// ray runs along an axis; edge functions that round to zero get their exact sign. The SIMD traversals do
// the same operations in the same order, so all of them find the same t to the bit.
#ifndef SNELL_KERNEL_TRIANGLE_H
#define SNELL_KERNEL_TRIANGLE_H

#include "kernel/math.h"
#include "kernel/ray.h"

KERNEL_BEGIN

// A ray prepared for many triangles: kz is the axis where |d| is largest.
struct ShearedRay {
  vec3 o;
  vec3 d;
  uint kx;
  uint ky;
  uint kz;
  float sx;
  float sy;
  float sz;
};

FN ShearedRay Shear(vec3 o, vec3 d) {
  ShearedRay ray;
  ray.o = o;
  ray.d = d;
  vec3 a = Abs(d);
  ray.kz = a.x > a.y ? (a.x > a.z ? 0u : 2u) : (a.y > a.z ? 1u : 2u);
  uint next = ray.kz == 2u ? 0u : ray.kz + 1u;
  uint last = next == 2u ? 0u : next + 1u;
  bool swapped = d[ray.kz] < 0.0f;  // keeps the winding
  ray.kx = swapped ? last : next;
  ray.ky = swapped ? next : last;
  ray.sx = d[ray.kx] / d[ray.kz];
  ray.sy = d[ray.ky] / d[ray.kz];
  ray.sz = 1.0f / d[ray.kz];
  return ray;
}

struct TriangleHit {
  float t;  // ≤ 0: no hit
  float b0;
  float b1;
  float b2;
};

// Whether a hit at a distance below the triangle's size is only the rounding error of a ray that starts on
// the triangle's plane. The side of the plane on which the ray starts decides, where it is certain.
FN bool StartsOnPlane(vec3 o, vec3 d, vec3 v0, vec3 v1, vec3 v2, float t) {
  vec3 e1 = v1 - v0;
  vec3 e2 = v2 - v0;
  vec3 size = Abs(e1) + Abs(e2);
  vec3 step = Abs(d) * t;
  if (Max(step.x, Max(step.y, step.z)) > size.x + size.y + size.z) return false;
  vec3 n = Cross(e1, e2);
  vec3 toPlane = v0 - o;
  float distance = Dot(n, toPlane);
  float slope = Dot(n, d);
  vec3 a1 = Abs(e1);
  vec3 a2 = Abs(e2);
  vec3 nBound =
      vec3(a1.y * a2.z + a1.z * a2.y, a1.z * a2.x + a1.x * a2.z, a1.x * a2.y + a1.y * a2.x);
  float error = Gamma(6.0f) * Dot(nBound, Abs(toPlane));
  return slope > 0.0f ? distance <= error : distance >= -error;
}

FN TriangleHit IntersectTriangle(IN(ShearedRay) ray, vec3 v0, vec3 v1, vec3 v2) {
  TriangleHit hit;
  hit.t = -1.0f;
  hit.b0 = 0.0f;
  hit.b1 = 0.0f;
  hit.b2 = 0.0f;

  // Shear the vertices relative to the ray
  vec3 a = v0 - ray.o;
  vec3 b = v1 - ray.o;
  vec3 c = v2 - ray.o;
  float ax = a[ray.kx] - ray.sx * a[ray.kz];
  float ay = a[ray.ky] - ray.sy * a[ray.kz];
  float bx = b[ray.kx] - ray.sx * b[ray.kz];
  float by = b[ray.ky] - ray.sy * b[ray.kz];
  float cx = c[ray.kx] - ray.sx * c[ray.kz];
  float cy = c[ray.ky] - ray.sy * c[ray.kz];

  // On which side of each edge does the ray pass?
  float u = cx * by - cy * bx;
  float v = ax * cy - ay * cx;
  float w = bx * ay - by * ax;
  float signU = u;
  float signV = v;
  float signW = w;
  if (u == 0.0f || v == 0.0f || w == 0.0f) {
    signU = DifferenceOfProductsSign(cx, by, cy, bx);
    signV = DifferenceOfProductsSign(ax, cy, ay, cx);
    signW = DifferenceOfProductsSign(bx, ay, by, ax);
  }
  bool anyNegative = signU < 0.0f || signV < 0.0f || signW < 0.0f;
  bool anyPositive = signU > 0.0f || signV > 0.0f || signW > 0.0f;
  float det = u + v + w;
  if ((anyNegative && anyPositive) || det == 0.0f) return hit;

  // Interpolate the distance
  float t = (u * (ray.sz * a[ray.kz]) + v * (ray.sz * b[ray.kz]) + w * (ray.sz * c[ray.kz])) / det;
  if (!(t > 0.0f) || StartsOnPlane(ray.o, ray.d, v0, v1, v2, t)) return hit;
  hit.t = t;
  hit.b0 = u / det;
  hit.b1 = v / det;
  hit.b2 = w / det;
  return hit;
}

// Barycentric coordinates moved so far into the triangle that the point keeps `margin` from the edges, so
// that rays which start there are on the right side of the neighbours in corners too. In a triangle that is
// too small for that, the middle of its inscribed circle.
FN vec3 InsetTrianglePoint(vec3 b, vec3 p0, vec3 p1, vec3 p2, float margin) {
  vec3 edges = vec3(Length(p2 - p1), Length(p2 - p0), Length(p1 - p0));
  float area2 = Length(Cross(p1 - p0, p2 - p0));
  float perimeter = edges.x + edges.y + edges.z;
  vec3 least = edges * Min(margin / Max(area2, 1e-36f), 1.0f / perimeter);
  vec3 c = vec3(Max(b.x, least.x), Max(b.y, least.y), Max(b.z, least.z));
  return c / (c.x + c.y + c.z);
}

KERNEL_END

#endif
