// SPDX-License-Identifier: Apache-2.0
//
// What a physical (OpenPBR) surface's scattering consists of at one point, seen from one direction: the record that
// bsdf.h evaluates and samples, and that scene_bsdf.h fills.
#ifndef SNELL_KERNEL_LOBES_H
#define SNELL_KERNEL_LOBES_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

struct Bsdf {
  vec2 alpha;        // GGX widths of the base
  float eta;         // index of what lies behind over that of wo's side
  float etaFresnel;  // the same, as Fresnel's equations take it: changed by the specular weight
  float metalness;
  Spectrum metalF0;            // conductor: reflectance at normal incidence,
  Spectrum metalTint;          // by how much it falls short of Schlick's at 82°,
  float metalWeight;           // and what is left of all of it
  Spectrum metalScale;         // gives back the conductor's lost energy
  Spectrum reflectionScale;    // the dielectric's reflection: tint, lost energy
  Spectrum transmissionScale;  // its refraction; 0 for an opaque base
  Spectrum diffuse;            // albedo of what is below the dielectric, by its share of the light
  Spectrum diffuseColor;       // the same without that share
  float diffuseRoughness;
  Spectrum diffuseTransmission;  // albedo, to the other side
  Spectrum subsurface;           // what enters the body to wander there,
  Spectrum subsurfaceColor;      // and what comes back of it
  uint thin;                     // 1: what is refracted goes straight on
  uint closed;                   // 1: what is refracted is lost
  float film;                    // weight of a thin film on the base,
  float filmEta;                 // its index over that of wo's side,
  float filmPath;                // and twice its thickness times its index, micrometres
  Spectrum metalEta;             // index of the conductor below it over that of wo's side,
  Spectrum metalK;               // and its imaginary part
  float coat;                    // weight
  float coatScale;               // of its reflection
  uint coatTilted;               // 1: its frame is not that of the base,
  vec3 coatX;                    // but has these axes
  vec3 coatZ;
  vec2 coatAlpha;
  float coatEta;
  Spectrum coatTint;   // of light that crosses the coat twice at normal incidence
  Spectrum underCoat;  // what the coat leaves to the base, but for its tint
  Spectrum fuzz;
  float fuzzAlpha;
  float underFuzz;  // what the fuzz leaves to all else
  // Probabilities of the lobes; they sum to 1
  float pickCoat;
  float pickBase;
  float pickDiffuse;
  float pickDiffuseTransmission;
  float pickSubsurface;
  float pickFuzz;
};

// From where a surface is seen.
struct BsdfView {
  vec3 wo;          // the direction, in the base's frame,
  vec3 coatNormal;  // as is this
  float eta;        // the index of what lies behind over that of wo's side,
  float nearIor;    // and the latter
  uint outside;     // 1: wo is on the side where coat and fuzz are
  uint blurs;       // 1: narrow lobes are made wider (microfacet.h)
};

// A matt surface and nothing else.
FN Bsdf DiffuseBsdf(Spectrum albedo) {
  Spectrum zero = Spectrum(0.0f, 0.0f, 0.0f);
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Bsdf b;
  b.alpha = vec2(0.0f, 0.0f);
  b.eta = 1.0f;
  b.etaFresnel = 1.0f;
  b.metalness = 0.0f;
  b.metalF0 = zero;
  b.metalTint = one;
  b.metalWeight = 0.0f;
  b.metalScale = one;
  b.reflectionScale = zero;
  b.transmissionScale = zero;
  b.diffuse = albedo;
  b.diffuseColor = albedo;
  b.diffuseRoughness = 0.0f;
  b.diffuseTransmission = zero;
  b.subsurface = zero;
  b.subsurfaceColor = zero;
  b.thin = 0u;
  b.closed = 0u;
  b.film = 0.0f;
  b.filmEta = 1.0f;
  b.filmPath = 0.0f;
  b.metalEta = one;
  b.metalK = zero;
  b.coat = 0.0f;
  b.coatScale = 0.0f;
  b.coatTilted = 0u;
  b.coatX = vec3(1.0f, 0.0f, 0.0f);
  b.coatZ = vec3(0.0f, 0.0f, 1.0f);
  b.coatAlpha = vec2(0.0f, 0.0f);
  b.coatEta = 1.0f;
  b.coatTint = one;
  b.underCoat = one;
  b.fuzz = zero;
  b.fuzzAlpha = 1.0f;
  b.underFuzz = 1.0f;
  b.pickCoat = 0.0f;
  b.pickBase = 0.0f;
  b.pickDiffuse = 1.0f;
  b.pickDiffuseTransmission = 0.0f;
  b.pickSubsurface = 0.0f;
  b.pickFuzz = 0.0f;
  return b;
}

// The same surface with matt reflection in place of what wanders below.
FN Bsdf WithoutSubsurface(IN(Bsdf) from) {
  Bsdf b = from;
  b.diffuse += b.subsurface * b.subsurfaceColor;
  b.pickDiffuse += b.pickSubsurface;
  b.pickSubsurface = 0.0f;
  return b;
}

// Make the probabilities of the lobes sum to 1, or leave them at 0.
FN void NormalizePicks(INOUT(Bsdf) b) {
  float sum = b.pickCoat + b.pickBase + b.pickDiffuse + b.pickDiffuseTransmission +
              b.pickSubsurface + b.pickFuzz;
  float scale = sum > 0.0f ? 1.0f / sum : 0.0f;
  b.pickCoat *= scale;
  b.pickBase *= scale;
  b.pickDiffuse *= scale;
  b.pickDiffuseTransmission *= scale;
  b.pickSubsurface *= scale;
  b.pickFuzz *= scale;
}

// Kinds of lobes, as bits.
CONST uint LOBE_DIFFUSE = 1u;  // matt, below the surface, fuzz
CONST uint LOBE_SPECULAR = 2u;
CONST uint LOBE_REFRACTION = 4u;
CONST uint LOBE_DIFFUSE_TRANSMISSION = 8u;
CONST uint ALL_LOBES = 15u;

// The same surface with some kinds of lobes alone; what the others would scatter is lost.
FN Bsdf OnlyLobes(IN(Bsdf) from, uint lobes) {
  Bsdf b = from;
  Spectrum zero = Spectrum(0.0f, 0.0f, 0.0f);
  bool specular = (lobes & LOBE_SPECULAR) != 0u;
  bool refraction = (lobes & LOBE_REFRACTION) != 0u && MaxChannel(b.transmissionScale) > 0.0f;
  // Where nothing is matt, mirrors are sampled evenly in part, and likewise behind a sheet
  bool evenly = MaxChannel(b.diffuse) <= 0.0f && specular;
  bool evenlyThrough = MaxChannel(b.diffuseTransmission) <= 0.0f && refraction;
  if ((lobes & LOBE_DIFFUSE) == 0u) {
    b.diffuse = zero;
    b.subsurface = zero;
    b.fuzz = zero;
    b.pickSubsurface = 0.0f;
    b.pickFuzz = 0.0f;
    if (!evenly) b.pickDiffuse = 0.0f;
  }
  if ((lobes & LOBE_DIFFUSE_TRANSMISSION) == 0u) {
    b.diffuseTransmission = zero;
    if (!evenlyThrough) b.pickDiffuseTransmission = 0.0f;
  }
  if (!specular) {
    b.metalScale = zero;
    b.reflectionScale = zero;
    b.coatScale = 0.0f;
    b.pickCoat = 0.0f;
  }
  if (!refraction) b.closed = 1u;
  if (!specular && !refraction) b.pickBase = 0.0f;
  NormalizePicks(b);
  return b;
}

KERNEL_END

#endif
