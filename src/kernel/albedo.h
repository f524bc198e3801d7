// SPDX-License-Identifier: Apache-2.0
//
// Where the tables of directional albedos lie in their buffer: shares of light that microfacet lobes send back or let
// through, over the cosine of the direction, the roughness and, for dielectrics, the contrast of the indices. The
// host fills them (cpu/albedo_tables.h); they serve to give back the energy that single scattering loses.
#ifndef SNELL_KERNEL_ALBEDO_H
#define SNELL_KERNEL_ALBEDO_H

#include "kernel/math.h"

KERNEL_BEGIN

// Nodes along every axis of a table, at equal distances with both ends.
CONST uint AlbedoNodes = 16u;

// A conductor that reflects all: [roughness][cosine].
CONST uint CONDUCTOR_ALBEDO = 0u;
// Fuzz of colour 1: [roughness][cosine].
CONST uint FUZZ_ALBEDO = 256u;
// Dielectrics, [contrast][roughness][cosine]: what is reflected, from the thinner and from the denser side, and what is
// reflected or refracted.
CONST uint REFLECTED_ALBEDO = 512u;
CONST uint REFLECTED_INSIDE_ALBEDO = 4608u;
CONST uint TOTAL_ALBEDO = 8704u;
CONST uint TOTAL_INSIDE_ALBEDO = 12800u;
// Wavelengths by their share of all that are chosen: at every node 1/λ² − 1/λ² of the index of refraction (587.6 nm), in
// 1/µm², and the weights of red, green and blue (path_wavelength.h).
CONST uint WAVELENGTH_TABLE = 16896u;
CONST uint WavelengthNodes = 65u;
CONST uint AlbedoCount = 17156u;

// The contrast of two indices, in [0, 1]: 1 stands for a ratio of 3 and more.
FN float AlbedoContrast(float eta) {
  float ratio = eta < 1.0f ? 1.0f / eta : eta;
  return Min(2.0f * (ratio - 1.0f) / (ratio + 1.0f), 1.0f);
}
FN float EtaOfContrast(float contrast) { return (2.0f + contrast) / (2.0f - contrast); }

// Average of Fresnel's reflectance over the cosine-weighted hemisphere, from the thinner side; a fit by d'Eon 2021,
// "A hitchhiker's guide to multiple scattering".
FN float FrAverage(float eta) {
  return eta > 1.0f ? (eta - 1.0f) / (4.08567f + 1.00071f * eta) : 0.0f;
}

KERNEL_END

#endif
