// SPDX-License-Identifier: Apache-2.0
//
// The pixel filters, sampled instead of weighted: each sample's place in the image plane is drawn from the
// filter's density, so every sample counts the same and pixels stay independent, as denoisers want (Ernst,
// Stamminger, Greiner 2006, "Filter importance sampling"). All four filters are separable.
#ifndef SNELL_KERNEL_PIXEL_FILTER_H
#define SNELL_KERNEL_PIXEL_FILTER_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// The Gaussian's standard deviation in units of the filter's radius, where it is cut off.
CONST float GaussianSigma = 1.0f / 3.0f;
// Its integral over the radius: the error function of 3/√2.
CONST float GaussianMass = 0.99730020393673981095f;

// Coefficients of the four-term Blackman–Harris window (Harris 1978).
CONST float Blackman0 = 0.35875f;
CONST float Blackman1 = 0.48829f;
CONST float Blackman2 = 0.14128f;
CONST float Blackman3 = 0.01168f;

// Density of the filter at x ∈ [−1, 1], in units of the radius; integrates to 1.
FN float EvalPixelFilter(uint kind, float x) {
  if (abs(x) > 1.0f) return 0.0f;
  switch (kind) {
    case FILTER_BOX: return 0.5f;
    case FILTER_TENT: return 1.0f - abs(x);
    case FILTER_GAUSSIAN: {
      float z = x / GaussianSigma;
      return Exp(-0.5f * z * z) * (0.39894228040143267794f / (GaussianSigma * GaussianMass));
    }
  }
  float a = Pi * x;
  return (Blackman0 + Blackman1 * Cos(a) + Blackman2 * Cos(2.0f * a) + Blackman3 * Cos(3.0f * a)) /
         (2.0f * Blackman0);
}

// Inverse of the distribution function of the Blackman–Harris window on [−1, 1], off by less than 3e-7 in
// the function's value.
FN float SampleBlackmanHarris(float u) {
  // Start from the left half's mass: by the Gaussian of the same variance, in the far tail by a power
  float mass = Min(u, 1.0f - u);
  float gaussian = 0.38f * ErfInv(Max(2.0f * mass - 1.0f, -0.9999f));
  float x = Min(Max(gaussian, Pow(0.5f * mass, 0.2f) - 1.0f), 0.0f);

  // Refine by Newton's method
  for (uint i = 0u; i < 3u; ++i) {
    float s1;
    float c1;
    SinCos(Pi * x, s1, c1);
    float s2 = 2.0f * s1 * c1;
    float c2 = 2.0f * c1 * c1 - 1.0f;
    float s3 = s2 * c1 + c2 * s1;
    float c3 = c2 * c1 - s2 * s1;
    float integral = Blackman0 * Pi * (x + 1.0f) + Blackman1 * s1 + 0.5f * Blackman2 * s2 +
                     (1.0f / 3.0f) * (Blackman3 * s3);
    float error = integral / (2.0f * Blackman0 * Pi) - mass;
    float density =
        (Blackman0 + Blackman1 * c1 + Blackman2 * c2 + Blackman3 * c3) / (2.0f * Blackman0);
    x = Clamp(x - error / Max(density, 8e-5f), -1.0f, 0.0f);
  }
  return u < 0.5f ? x : -x;
}

FN float SamplePixelFilter1D(uint kind, float u) {
  switch (kind) {
    case FILTER_BOX: return 2.0f * u - 1.0f;
    case FILTER_TENT: return u < 0.5f ? sqrt(2.0f * u) - 1.0f : 1.0f - sqrt(2.0f * (1.0f - u));
    case FILTER_GAUSSIAN: {
      float z = ErfInv((2.0f * u - 1.0f) * GaussianMass);
      return Clamp(1.41421356237309504880f * GaussianSigma * z, -1.0f, 1.0f);
    }
  }
  return SampleBlackmanHarris(u);
}

// Offset from the pixel's centre, in pixels.
FN vec2 SamplePixelFilter(uint kind, float radius, vec2 u) {
  return vec2(SamplePixelFilter1D(kind, u.x) * radius, SamplePixelFilter1D(kind, u.y) * radius);
}

KERNEL_END

#endif
