// SPDX-License-Identifier: Apache-2.0
//
// The lobes of the classic shader terms. A light that gives the irradiance E on a surface that faces it
// makes a diffuse term of colour k shine with k/π · cos θ · E, as Lambert's law says. The textbooks' "light
// intensity" is therefore E/π, and the specular terms are k · lobe · E/π. Phong 1975; Blinn 1977;
// normalization: Lafortune and Willems 1994 (Phong), Akenine-Möller et al. 2018, section 9.8 (Blinn).
// Directions point away from the surface: wo to the viewer, wi to the light; n on the viewer's side.
#ifndef SNELL_KERNEL_CLASSIC_H
#define SNELL_KERNEL_CLASSIC_H

#include "kernel/fresnel.h"
#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// Radiance towards wo per unit of irradiance of a facing surface from wi, for a term of colour 1.
FN float EvalTerm(uint kind, bool normalized, float exponent, vec3 n, vec3 wo, vec3 wi) {
  float cosIn = Dot(n, wi);
  if (cosIn <= 0.0f) return 0.0f;
  switch (kind) {
    case TERM_DIFFUSE: return InvPi * cosIn;
    case TERM_PHONG: {
      float cosMirror = Dot(n * (2.0f * cosIn) - wi, wo);
      if (cosMirror <= 0.0f) return 0.0f;
      float lobe = InvPi * Pow(Min(cosMirror, 1.0f), exponent);
      return normalized ? lobe * (0.5f * (exponent + 2.0f)) * cosIn : lobe;
    }
    case TERM_BLINN: {
      float cosHalf = Dot(n, Normalize(wo + wi));
      if (cosHalf <= 0.0f) return 0.0f;
      float lobe = InvPi * Pow(Min(cosHalf, 1.0f), exponent);
      if (!normalized) return lobe;
      float scale =
          (exponent + 2.0f) * (exponent + 4.0f) / (8.0f * (Exp2(-0.5f * exponent) + exponent));
      return lobe * scale * cosIn;
    }
  }
  return 0.0f;
}

KERNEL_END

#endif
