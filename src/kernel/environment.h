// SPDX-License-Identifier: Apache-2.0
//
// What rays see that leave the scene: one colour, or a gradient from bottom to top, or a map. A map is a picture of
// all directions, equirectangular: its upper border is +y, its lower one −y, its middle looks along −z, what lies to
// the right of that along +x. Places on it: (0, 0) is its upper left corner, (1, 1) its lower right one.
#ifndef SNELL_KERNEL_ENVIRONMENT_H
#define SNELL_KERNEL_ENVIRONMENT_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// Radiance from the unit direction d. The gradient is linear in the sine of the elevation.
FN Spectrum GradientLe(IN(Environment) environment, vec3 d) {
  float height = (d.y - environment.sinBottom) / (environment.sinTop - environment.sinBottom);
  float t = Clamp(height, 0.0f, 1.0f);
  return Lerp(t, environment.bottom, environment.top);
}

// Where a map that is turned shows the unit direction d.
FN vec2 EquirectPlace(vec3 d, float turn) {
  float u = 0.5f + Atan2(d.x, -d.z) * Inv2Pi + turn;
  return vec2(u - floor(u), Acos(d.y) * InvPi);
}

FN vec3 EquirectDirection(vec2 place, float turn) {
  float sinPhi;
  float cosPhi;
  SinCos(2.0f * Pi * (place.x - 0.5f - turn), sinPhi, cosPhi);
  float sine;
  float cosine;
  SinCos(Pi * place.y, sine, cosine);
  return vec3(sine * sinPhi, cosine, -sine * cosPhi);
}

// The sine of the angle between +y and the texels of a row, of so many.
FN float RowSine(uint row, uint rows) { return Sin(Pi * (float(row) + 0.5f) / float(rows)); }

// What a texel counts in the sampling of a map, solid angle aside: only the part of its brightness that exceeds the
// map's mean, for scattering finds the dull part well enough (Karlik et al. 2019, "MIS compensation").
FN float MapWeight(Spectrum texel, float dull) { return Max(MaxChannel(texel) - dull, 0.0f); }

// A number from 0 to 1 by the density that goes linearly from a to b, up to a factor.
FN float SampleLinear(float u, float a, float b) {
  float larger = Max(a, b);
  if (larger <= 0.0f || u <= 0.0f) return u;
  float from = a / larger;
  float to = b / larger;
  return Min(u * (from + to) / (from + sqrt(Lerp(u, from * from, to * to))), 1.0f);
}

KERNEL_END

#endif
