// SPDX-License-Identifier: Apache-2.0
//
// How the classic integrator shows a physical (OpenPBR) material: a diffuse base, the highlights of the lights by
// the GGX lobe (Walter et al. 2007; height-correlated masking after Heitz 2014), a mirror image that fades as the
// surface gets rougher, a clear coat and fuzz (Estevez and Kulla 2017, "Production friendly microfacet sheen BRDF").
// Light that a rough surface would gather from its surroundings is taken from the ambient lights.
// Directions as in classic.h.
#ifndef SNELL_KERNEL_PHYSICAL_H
#define SNELL_KERNEL_PHYSICAL_H

#include "kernel/fresnel.h"
#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// A physical material at a point, its textures read.
struct PhysicalPoint {
  Spectrum diffuse;  // albedo of the base's diffuse part
  Spectrum f0;       // reflectance of base at normal incidence
  float alpha;       // GGX width of the base
  float transmission;
  float coat;  // how much of it there is
  float coatF0;
  float coatAlpha;
  Spectrum fuzz;
  float fuzzAlpha;
};

FN PhysicalPoint NoPhysicalPoint() {
  PhysicalPoint point;
  point.diffuse = Spectrum(0.0f, 0.0f, 0.0f);
  point.f0 = point.diffuse;
  point.alpha = 1.0f;
  point.transmission = 0.0f;
  point.coat = 0.0f;
  point.coatF0 = 0.0f;
  point.coatAlpha = 1.0f;
  point.fuzz = point.diffuse;
  point.fuzzAlpha = 1.0f;
  return point;
}

// What a material's textures show at a point, by role.
struct RoleTexels {
  vec4 at[RoleCount];
};

FN Spectrum ShownColor(IN(RoleTexels) shown, uint role) {
  return Spectrum(shown.at[role].x, shown.at[role].y, shown.at[role].z);
}

FN float ShownScalar(IN(ScalarSource) source, IN(RoleTexels) shown, uint role) {
  if (source.value == 0.0f) return 0.0f;
  vec4 texel = shown.at[role];
  float channel = source.channel == 0u   ? texel.x
                  : source.channel == 1u ? texel.y
                  : source.channel == 2u ? texel.z
                                         : texel.w;
  return source.value * channel;
}

// How much of the surface is there: 1 but for materials with holes or gaps.
FN float OpacityOf(IN(Material) material, IN(RoleTexels) shown, float vertexAlpha) {
  if (material.alphaMode == ALPHA_OPAQUE) return 1.0f;
  float opacity = ShownScalar(material.opacity, shown, ROLE_OPACITY) * vertexAlpha;
  if (material.alphaMode == ALPHA_MASK) return opacity < material.alphaCutoff ? 0.0f : 1.0f;
  return Clamp(opacity, 0.0f, 1.0f);
}

// Roughness to GGX width. Highlights of points of light cannot be narrower than a pixel can show.
FN float HighlightAlpha(float roughness) { return Max(roughness * roughness, 0.02f); }

// What remains of the mirror image on a rough surface: all at 0, nothing from 0.5 on.
FN float MirrorShare(float alpha) {
  float fade = Clamp(1.0f - sqrt(alpha) * 2.0f, 0.0f, 1.0f);
  return fade * fade;
}

// D · G / (4 cos cos) · cos of the isotropic GGX lobe.
FN float GgxLobe(float alpha, float cosOut, float cosIn, float cosHalf) {
  float a2 = alpha * alpha;
  float d = cosHalf * cosHalf * (a2 - 1.0f) + 1.0f;
  float distribution = a2 * InvPi / (d * d);
  float visibility = 0.5f / (cosIn * sqrt(cosOut * cosOut * (1.0f - a2) + a2) +
                             cosOut * sqrt(cosIn * cosIn * (1.0f - a2) + a2));
  return distribution * visibility * cosIn;
}

FN float FuzzLobe(float alpha, float cosOut, float cosIn, float cosHalf) {
  float inverse = 1.0f / alpha;
  float sine = Max(1.0f - cosHalf * cosHalf, 0.0078125f);
  float distribution = (2.0f + inverse) * Pow(sine, 0.5f * inverse) * (0.5f * InvPi);
  return distribution * cosIn / (4.0f * (cosIn + cosOut - cosIn * cosOut));
}

// How much light passes the coat, on its way at this angle.
FN float ThroughCoat(IN(PhysicalPoint) point, float cosine) {
  Spectrum f = FrSchlick(Spectrum(point.coatF0, point.coatF0, point.coatF0), cosine);
  return 1.0f - point.coat * f.x;
}

// Radiance towards wo per unit of irradiance of a facing surface from wi.
FN Spectrum EvalPhysical(IN(PhysicalPoint) point, vec3 n, vec3 wo, vec3 wi) {
  float cosIn = Dot(n, wi);
  float cosOut = Max(Dot(n, wo), 1e-3f);
  if (cosIn <= 0.0f) return Spectrum(0.0f, 0.0f, 0.0f);
  vec3 h = Normalize(wo + wi);
  float cosHalf = Clamp(Dot(n, h), 0.0f, 1.0f);
  float cosDifference = Clamp(Dot(wo, h), 0.0f, 1.0f);
  Spectrum fresnel = FrSchlick(point.f0, cosDifference);
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Spectrum base = point.diffuse * (one - fresnel) * (InvPi * cosIn) +
                  fresnel * GgxLobe(point.alpha, cosOut, cosIn, cosHalf);
  Spectrum f = base;
  if (point.coat > 0.0f) {
    Spectrum coatF = FrSchlick(Spectrum(point.coatF0, point.coatF0, point.coatF0), cosDifference);
    f = base * (ThroughCoat(point, cosIn) * ThroughCoat(point, cosOut)) +
        coatF * (point.coat * GgxLobe(point.coatAlpha, cosOut, cosIn, cosHalf));
  }
  if (!IsBlack(point.fuzz)) f += point.fuzz * FuzzLobe(point.fuzzAlpha, cosOut, cosIn, cosHalf);
  return f;
}

// The mirror image's weight at an angle; coat and base together.
FN Spectrum PhysicalReflectivity(IN(PhysicalPoint) point, float cosIncident) {
  Spectrum base = FrSchlick(point.f0, cosIncident) * MirrorShare(point.alpha);
  if (point.coat <= 0.0f) return base;
  Spectrum coatF = FrSchlick(Spectrum(point.coatF0, point.coatF0, point.coatF0), cosIncident);
  return base * Sqr(ThroughCoat(point, cosIncident)) +
         coatF * (point.coat * MirrorShare(point.coatAlpha));
}

// What the surface sends back of light that comes from everywhere, less what the mirror image brings.
FN Spectrum PhysicalAmbient(IN(PhysicalPoint) point, float cosOut) {
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Spectrum fresnel = FrSchlick(point.f0, cosOut);
  return point.diffuse * (one - fresnel) + fresnel * (1.0f - MirrorShare(point.alpha)) + point.fuzz;
}

KERNEL_END

#endif
