// SPDX-License-Identifier: Apache-2.0
//
// How a medium scatters light at a point: the phase function of Henyey and Greenstein 1941, "Diffuse radiation in the
// galaxy", by the mean cosine g of its angle of deflection. `wo` and `wi` point away from the point; what goes straight
// on has wi = −wo.
#ifndef SNELL_KERNEL_PHASE_H
#define SNELL_KERNEL_PHASE_H

#include "kernel/math.h"

KERNEL_BEGIN

// The share of light per solid angle that goes to wi, which is also the density of SamplePhase.
FN float EvalPhase(float g, vec3 wo, vec3 wi) {
  float d = Max(1.0f + g * g + 2.0f * g * Dot(wo, wi), 1e-7f);
  return 0.25f * InvPi * (1.0f - g * g) / (d * sqrt(d));
}

// A direction by u ∈ [0, 1)²: the distribution of the cosine is inverted.
FN vec3 SamplePhase(float g, vec3 wo, vec2 u) {
  float cosine = 1.0f - 2.0f * u.x;
  if (abs(g) > 1e-3f) {
    float s = (1.0f - g * g) / (1.0f + g - 2.0f * g * u.x);
    cosine = Clamp((1.0f + g * g - s * s) / (2.0f * g), -1.0f, 1.0f);
  }
  float sine = SafeSqrt(1.0f - cosine * cosine);
  float s;
  float c;
  SinCos(2.0f * Pi * u.y, s, c);
  vec3 x;
  vec3 y;
  CoordinateSystem(-wo, x, y);
  return Normalize(x * (sine * c) + y * (sine * s) - wo * cosine);
}

KERNEL_END

#endif
