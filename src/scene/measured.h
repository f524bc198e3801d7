// SPDX-License-Identifier: Apache-2.0
//
// Real metals and glasses by name: what a physical material takes from measurements.
#pragma once

#include <span>
#include <string_view>

#include "scene/material.h"

namespace snell::scene {

// The complex index of refraction n + ik at some wavelengths, which rise.
struct IndexSample {
  double nanometres;
  double n;
  double k;
};

struct MeasuredMetal {
  std::string_view name;
  std::string_view source;
  std::span<const IndexSample> samples;
};

// n² = 1 + Σ b λ² / (λ² − c), λ in micrometres (Sellmeier 1871).
struct MeasuredGlass {
  std::string_view name;
  std::string_view source;
  double b[4];
  double c[4];  // µm²

  double Ior(double nanometres) const;
  double Abbe() const;  // (n_d − 1) / (n_F − n_C)
};

std::span<const MeasuredMetal> MeasuredMetals();
std::span<const MeasuredGlass> MeasuredGlasses();

// Null if there is none of that name.
const MeasuredMetal* FindMetal(std::string_view name);
const MeasuredGlass* FindGlass(std::string_view name);

// Share of unpolarised light that a conductor of index n + ik reflects in air.
double ConductorReflectance(double cosine, double n, double k);
// The cosine of about 82°, at which the tint of metals holds (kernel/bsdf.h).
inline constexpr double MetalGrazing = 1.0 / 7;
// The colours at normal incidence and there, in linear Rec.709, become the base's and its tint.
void SetMetalColors(Spectrum normal, Spectrum grazing, OpenPbr& material);

// Make the base this metal: its colours at normal incidence and at 82°, in daylight. What Rec.709 cannot show is cut.
void SetMetal(const MeasuredMetal& metal, OpenPbr& material);
// Make the base clear, with this index of refraction and dispersion.
void SetGlass(const MeasuredGlass& glass, OpenPbr& material);

}  // namespace snell::scene
