// SPDX-License-Identifier: Apache-2.0
//
// Motion while the shutter is open: places between two keys, and surfaces that are found where they stand still. Maps are
// interpolated linearly, element by element, so that every point moves on a straight line from key to key; keys are made
// close enough for turns (cpu/flatten_motion.h).
#ifndef SNELL_KERNEL_MOTION_H
#define SNELL_KERNEL_MOTION_H

#include "kernel/ray.h"
#include "kernel/transform.h"

KERNEL_BEGIN

// Between which keys a moment lies, and how far.
struct MotionMoment {
  uint step;
  float share;
};

FN MotionMoment MomentOf(float time, uint steps) {
  float place = time * float(steps);
  float step = Clamp(floor(place), 0.0f, float(steps) - 1.0f);
  MotionMoment moment;
  moment.step = uint(step);
  moment.share = place - step;
  return moment;
}

FN Transform PlaceBetween(IN(MotionKey) a, IN(MotionKey) b, float share) {
  Transform m;
  m.x = Lerp(share, a.x, b.x);
  m.y = Lerp(share, a.y, b.y);
  m.z = Lerp(share, a.z, b.z);
  m.origin = Lerp(share, a.origin, b.origin);
  // The rows of the inverse stand on two columns each
  vec3 normalX = Cross(m.y, m.z);
  float scale = 1.0f / Dot(m.x, normalX);
  m.rowX = normalX * scale;
  m.rowY = Cross(m.z, m.x) * scale;
  m.rowZ = Cross(m.x, m.y) * scale;
  return m;
}

// How far a point near `world` may seem to move, in any direction, because the inverse is rounded: by Frobenius' norms
// (Higham 2002, section 14.1).
FN vec3 InverseError(IN(Transform) m, vec3 world) {
  float size = LengthSquared(m.x) + LengthSquared(m.y) + LengthSquared(m.z);
  float inverse = LengthSquared(m.rowX) + LengthSquared(m.rowY) + LengthSquared(m.rowZ);
  float error = size * inverse * Gamma(4.0f) * Length(world - m.origin);
  return vec3(error, error, error);
}

// A shape's surface as it is where its object has moved to.
FN SurfaceInteraction MovedSurface(IN(Transform) m, IN(SurfaceInteraction) still) {
  SurfaceInteraction it = still;
  it.p = ToWorldPoint(m, still.p);
  vec3 n = ToWorldNormal(m, still.n);
  float nLength = Length(n);
  it.n = n / nLength;
  it.ns = it.n;
  it.pError = ToWorldPointError(m, still.p, still.pError, it.p) +
              Abs(it.n) * ToLocalError(m, it.p, still.n, nLength) + InverseError(m, it.p);
  it.dpdu = ToWorldVector(m, still.dpdu);
  return it;
}

KERNEL_END

#endif
