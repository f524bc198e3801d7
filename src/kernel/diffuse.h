// SPDX-License-Identifier: Apache-2.0
//
// Rough diffuse reflection that keeps all energy: EON, Portsmouth, Kutz and Hill 2024, "EON: a practical
// energy-preserving rough diffuse BRDF" (Fujii's form of Oren and Nayar's model, with what scatters several times).
#ifndef SNELL_KERNEL_DIFFUSE_H
#define SNELL_KERNEL_DIFFUSE_H

#include "kernel/math.h"

KERNEL_BEGIN

CONST float EonLoss = 0.28779340921080556f;        // 1/2 − 2/(3π)
CONST float EonAverageLoss = 0.0724882123936466f;  // 2/3 − 28/(15π)

// The share of light that the single-scattering part of albedo 1 sends back at a cosine.
FN float EonSingleAlbedo(float cosine, float roughness) {
  float m = 1.0f - cosine;
  float g = m * (0.0571085289f + m * (0.491881867f + m * (-0.332181442f + m * 0.0714429953f)));
  return (1.0f + roughness * g) / (1.0f + EonLoss * roughness);
}

// Radiance per irradiance, 1/sr, both directions above the surface; roughness in [0, 1]. `albedo` is the share of all
// light that comes back at the first reflection, `color` what each further one leaves.
FN Spectrum EvalEon(Spectrum albedo, Spectrum color, float roughness, vec3 wo, vec3 wi) {
  if (roughness <= 0.0f) return albedo * InvPi;
  float s = Dot(wi, wo) - wi.z * wo.z;
  float ratio = s > 0.0f ? s / Max(Max(wi.z, wo.z), 1e-6f) : s;
  float single = (1.0f + roughness * ratio) / (1.0f + EonLoss * roughness);

  float average = (1.0f + EonAverageLoss * roughness) / (1.0f + EonLoss * roughness);
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Spectrum again = albedo * color * average / (one - color * (1.0f - average));
  float lost = Max(1.0f - EonSingleAlbedo(wo.z, roughness), 1e-7f) *
               Max(1.0f - EonSingleAlbedo(wi.z, roughness), 1e-7f) / Max(1.0f - average, 1e-7f);
  return (albedo * single + again * lost) * InvPi;
}

KERNEL_END

#endif
