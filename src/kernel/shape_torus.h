// SPDX-License-Identifier: Apache-2.0
//
// The torus around +y: a tube of radius r (minor) whose middle runs at distance R (major) from the axis,
// r ≤ R. The quartic along the ray only brackets the roots; each root is then found on the distance
// function of the surface itself, which keeps its digits for thin tubes too. Whether the ray starts inside
// is decided at its origin, so a surface does not hit itself.
#ifndef SNELL_KERNEL_SHAPE_TORUS_H
#define SNELL_KERNEL_SHAPE_TORUS_H

#include "kernel/math.h"
#include "kernel/shape_surface.h"

KERNEL_BEGIN

// Signed distance to the torus, negative inside.
FN float TorusDistance(vec3 p, float major, float minor) {
  float ring = sqrt(p.x * p.x + p.z * p.z) - major;
  return sqrt(ring * ring + p.y * p.y) - minor;
}

// The root of the monotone cubic s³·c3 + s·c1 + c0 in [lower, upper], or the end nearer to it.
FN float CubicRootInBracket(float c3, float c1, float c0, float lower, float upper) {
  float atLower = (c3 * lower * lower + c1) * lower + c0;
  float atUpper = (c3 * upper * upper + c1) * upper + c0;
  if (atLower * atUpper >= 0.0f) return abs(atLower) < abs(atUpper) ? lower : upper;
  float a = lower;
  float b = upper;
  for (uint i = 0u; i < 24u; ++i) {
    float middle = 0.5f * (a + b);
    float value = (c3 * middle * middle + c1) * middle + c0;
    if ((value > 0.0f) == (atUpper > 0.0f)) {
      b = middle;
    } else {
      a = middle;
    }
  }
  return 0.5f * (a + b);
}

// The root of the distance function between lower (where the sign is `before`) and upper (where it is the
// other): regula falsi with the Illinois rule, safeguarded by bisection.
FN float TorusRootInBracket(vec3 o, vec3 d, float major, float minor, float lower, float upper,
                            float atLower, float atUpper) {
  float a = lower;
  float b = upper;
  float fa = atLower;
  float fb = atUpper;
  for (uint i = 0u; i < 32u; ++i) {
    float middle = a + (b - a) * (fa / (fa - fb));
    if (!(middle > a && middle < b)) middle = 0.5f * (a + b);
    float value = TorusDistance(o + middle * d, major, minor);
    if ((value > 0.0f) == (fb > 0.0f)) {
      b = middle;
      fb = value;
      fa = 0.5f * fa;
    } else {
      a = middle;
      fa = value;
      fb = 0.5f * fb;
    }
    if (abs(value) <= 2.0f * UnitRoundoff * major || b - a <= 2.0f * UnitRoundoff * abs(b)) {
      return middle;
    }
  }
  return 0.5f * (a + b);
}

FN float IntersectTorus(vec3 o, vec3 d, float major, float minor) {
  // Measure along the ray from its point nearest to the centre, in units of length
  float speed = Length(d);
  vec3 w = d / speed;
  float sFar = Dot(o, w);
  vec3 rough = o - sFar * w;
  // A second step gives back the digits that a far origin has cost
  float sNear = Dot(rough, w);
  vec3 q = rough - sNear * w;
  float sOrigin = sFar + sNear;
  float m = Dot(q, q);
  // A slightly larger sphere around all makes sure that its rim is outside
  float reach2 = Sqr(1.0001f * (major + minor)) - m;
  if (reach2 <= 0.0f) return -1.0f;
  float reach = sqrt(reach2);
  float start = Max(sOrigin, -reach);
  if (start >= reach) return -1.0f;

  // G(s) = s⁴ + c2 s² + c1 s + c0 has the torus's roots; between its extrema there is at most one
  float k = m + major * major - minor * minor;
  float fourR2 = 4.0f * major * major;
  float c2 = 2.0f * k - fourR2 * (1.0f - w.y * w.y);
  float c1 = 2.0f * fourR2 * q.y * w.y;

  // The extrema are the roots of 4s³ + 2 c2 s + c1, which are parted by ±√(−c2/6)
  float knots[5];
  uint knotCount = 0u;
  float h = c2 < 0.0f ? sqrt(-c2 / 6.0f) : 0.0f;
  float ends[4];
  ends[0] = -reach;
  ends[1] = Clamp(-h, -reach, reach);
  ends[2] = Clamp(h, -reach, reach);
  ends[3] = reach;
  for (uint i = 0u; i < 3u; ++i) {
    if (ends[i + 1u] > ends[i]) {
      float extremum = CubicRootInBracket(4.0f, 2.0f * c2, c1, ends[i], ends[i + 1u]);
      if (extremum > start && extremum < reach) {
        knots[knotCount] = extremum;
        knotCount += 1u;
      }
    }
  }
  knots[knotCount] = reach;
  knotCount += 1u;

  // Walk from the start to the first change of sign
  float s = start;
  float f = TorusDistance(start == sOrigin ? o : q + start * w, major, minor);
  for (uint i = 0u; i < knotCount; ++i) {
    float fNext = TorusDistance(q + knots[i] * w, major, minor);
    if ((f > 0.0f) != (fNext > 0.0f)) {
      float root = TorusRootInBracket(q, w, major, minor, s, knots[i], f, fNext);
      return ((root - sNear) - sFar) / speed;
    }
    s = knots[i];
    f = fNext;
  }
  return -1.0f;
}

FN LocalSurface TorusSurface(vec3 o, vec3 d, float major, float minor, float t, bool mapped) {
  LocalSurface s;
  vec3 p = o + t * d;
  float fromAxis = sqrt(p.x * p.x + p.z * p.z);
  vec3 outward = fromAxis > 0.0f ? vec3(p.x, 0.0f, p.z) / fromAxis : vec3(0.0f, 0.0f, 1.0f);
  vec3 middle = outward * major;
  s.n = Normalize(p - middle);
  s.p = middle + minor * s.n;
  s.error = Abs(s.p) * Gamma(8.0f) + vec3(1.0f, 1.0f, 1.0f) * (major * Gamma(8.0f));
  s.uv = vec2(0.0f, 0.0f);
  if (mapped)
    s.uv = vec2(0.5f + Atan2(p.x, p.z) * Inv2Pi, 0.5f + Atan2(p.y, fromAxis - major) * Inv2Pi);
  s.dpdu = vec3(s.p.z, 0.0f, -s.p.x) * (2.0f * Pi);
  return s;
}

KERNEL_END

#endif
