// SPDX-License-Identifier: Apache-2.0
//
// What a smooth boundary does with light: the law of reflection, Snell's law, and Fresnel's equations for
// unpolarised light between two dielectrics (Born and Wolf, Principles of Optics, section 1.5).
#ifndef SNELL_KERNEL_FRESNEL_H
#define SNELL_KERNEL_FRESNEL_H

#include "kernel/math.h"

KERNEL_BEGIN

// The direction d mirrored at a surface with unit normal n (either side).
FN vec3 Reflect(vec3 d, vec3 n) { return d - n * (2.0f * Dot(d, n)); }

// Cosine of the refracted ray's angle for an incident cosine in [0, 1]; `eta` is the index of the far side
// over that of the near side. Negative on total internal reflection.
FN float RefractedCosine(float cosIncident, float eta) {
  float sin2 = (1.0f - cosIncident * cosIncident) / (eta * eta);
  return sin2 >= 1.0f ? -1.0f : sqrt(1.0f - sin2);
}

// The unit direction d bent at a surface whose unit normal n is on the side d comes from; `cosRefracted`
// from RefractedCosine.
FN vec3 Refract(vec3 d, vec3 n, float cosIncident, float cosRefracted, float eta) {
  return d / eta + n * (cosIncident / eta - cosRefracted);
}

// The share of unpolarised light that is reflected, for cosines and eta as above; 1 on total reflection.
FN float FrDielectric(float cosIncident, float cosRefracted, float eta) {
  if (cosRefracted < 0.0f) return 1.0f;
  float parallel = (eta * cosIncident - cosRefracted) / (eta * cosIncident + cosRefracted);
  float perpendicular = (cosIncident - eta * cosRefracted) / (cosIncident + eta * cosRefracted);
  return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

// Schlick 1994: reflectance from its value at normal incidence.
FN Spectrum FrSchlick(Spectrum normalIncidence, float cosIncident) {
  float m = Clamp(1.0f - cosIncident, 0.0f, 1.0f);
  float m2 = m * m;
  return normalIncidence + (Spectrum(1.0f, 1.0f, 1.0f) - normalIncidence) * (m2 * m2 * m);
}

KERNEL_END

#endif
