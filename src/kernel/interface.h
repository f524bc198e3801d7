// SPDX-License-Identifier: Apache-2.0
//
// How a classic material shares the light that falls on it. Per channel, with transparency T, reflectivity
// R and Fresnel's reflectance F of the boundary:
//
//   own colour  (1 − T)(1 − R)
//   reflection  (1 − T) R + T F
//   refraction  T (1 − F)
//
// The three sum to 1, so a surface gives back what it receives and no more. Emission is added. The specular
// terms stand for the reflection of the light sources themselves and get what is not refracted.
#ifndef SNELL_KERNEL_INTERFACE_H
#define SNELL_KERNEL_INTERFACE_H

#include "kernel/fresnel.h"
#include "kernel/types.h"

KERNEL_BEGIN

struct Shares {
  Spectrum own;
  Spectrum reflection;
  Spectrum refraction;
};

FN Shares ShareLight(Spectrum transparency, Spectrum reflectivity, float fresnel) {
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Spectrum opaque = one - transparency;
  Shares shares;
  shares.own = opaque * (one - reflectivity);
  shares.reflection = opaque * reflectivity + transparency * fresnel;
  shares.refraction = transparency * (1.0f - fresnel);
  return shares;
}

// Reflectivity of the opaque part at an angle, by the material's model.
FN Spectrum ReflectivityAt(uint model, Spectrum reflectivity, float cosIncident, float ior) {
  if (model == REFLECTION_CONSTANT) return reflectivity;
  if (model == REFLECTION_SCHLICK) return FrSchlick(reflectivity, cosIncident);
  return reflectivity * FrDielectric(cosIncident, RefractedCosine(cosIncident, ior), ior);
}

// Reflectance of a sheet with two parallel faces of reflectance F each, all reflections between them added.
FN float SheetReflectance(float fresnel) { return 2.0f * fresnel / (1.0f + fresnel); }

KERNEL_END

#endif
