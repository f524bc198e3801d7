// SPDX-License-Identifier: Apache-2.0
//
// The GGX distribution of microfacet normals, with a width along x and one along y: Trowbridge and Reitz 1975; Walter
// et al. 2007, "Microfacet models for refraction through rough surfaces"; masking and shadowing correlated by height
// (Heitz 2014, "Understanding the masking-shadowing function"). Directions are in the surface's frame, z along the normal.
#ifndef SNELL_KERNEL_MICROFACET_H
#define SNELL_KERNEL_MICROFACET_H

#include "kernel/math.h"

KERNEL_BEGIN

// Narrower than this a surface is taken to be perfectly smooth.
CONST float SmoothAlpha = 1e-3f;

// Microfacet area of unit normal m per solid angle and per area of the surface.
FN float GgxDistribution(vec2 alpha, vec3 m) {
  float t = Sqr(m.x / alpha.x) + Sqr(m.y / alpha.y) + m.z * m.z;
  return 1.0f / (Pi * alpha.x * alpha.y * t * t);
}

// Smith's Λ of a direction: invisible per visible microfacet area.
FN float GgxLambda(vec2 alpha, vec3 w) {
  float cos2 = w.z * w.z;
  float slope2 = (Sqr(alpha.x * w.x) + Sqr(alpha.y * w.y)) / Max(cos2, 1e-12f);
  return 0.5f * (sqrt(1.0f + slope2) - 1.0f);
}

// Share of the facets that are seen from w, and that are seen from both directions.
FN float GgxMasking(vec2 alpha, vec3 w) { return 1.0f / (1.0f + GgxLambda(alpha, w)); }
FN float GgxMasking(vec2 alpha, vec3 wo, vec3 wi) {
  return 1.0f / (1.0f + GgxLambda(alpha, wo) + GgxLambda(alpha, wi));
}

// A normal of those that are seen from wo, wo.z > 0, by how much of them is seen. Dupuy and Benyoub 2023, "Sampling
// visible GGX normals with spherical caps".
FN vec3 SampleGgxVisible(vec2 alpha, vec3 wo, vec2 u) {
  vec3 w = Normalize(vec3(alpha.x * wo.x, alpha.y * wo.y, wo.z));
  float z = (1.0f - u.y) * (1.0f + w.z) - w.z;
  float sine = SafeSqrt(1.0f - z * z);
  float s;
  float c;
  SinCos(2.0f * Pi * u.x, s, c);
  vec3 h = vec3(sine * c, sine * s, z) + w;
  return Normalize(vec3(alpha.x * h.x, alpha.y * h.y, Max(h.z, 1e-7f)));
}
FN float PdfGgxVisible(vec2 alpha, vec3 wo, vec3 m) {
  return GgxMasking(alpha, wo) * GgxDistribution(alpha, m) * Max(Dot(wo, m), 0.0f) /
         Max(abs(wo.z), 1e-7f);
}

// GGX widths of a roughness and an anisotropy in [0, 1] (OpenPBR 1.1, section on microfacets).
FN vec2 GgxWidths(float roughness, float anisotropy) {
  float along = roughness * roughness * sqrt(2.0f / (1.0f + Sqr(1.0f - anisotropy)));
  return vec2(Max(along, 1e-4f), Max(along * (1.0f - anisotropy), 1e-4f));
}

// The same as glTF has it (KHR_materials_anisotropy): only the width along the direction grows.
FN vec2 GgxWidthsOfGltf(float roughness, float strength) {
  float across = Max(roughness * roughness, 1e-4f);
  return vec2(Lerp(strength * strength, across, 1.0f), across);
}

// A lobe wide enough for samples of light to find it, in place of a narrow one: a caustic becomes a soft one of about the
// same light (Kaplanyan and Dachsbacher 2013, "Path space regularization for holistic and robust light transport"; the
// widths of pbrt-v4's TrowbridgeReitzDistribution::Regularize).
FN float RegularizedWidth(float alpha) {
  if (alpha >= 0.3f) return alpha;
  return Clamp(2.0f * alpha, 0.1f, 0.3f);
}
FN vec2 RegularizedWidths(vec2 alpha) {
  return vec2(RegularizedWidth(alpha.x), RegularizedWidth(alpha.y));
}

KERNEL_END

#endif
