// SPDX-License-Identifier: Apache-2.0
//
// Spectra among a statement's parameters, in whatever way they are written: rgb, blackbody, by name, as pairs, in a
// file, or as a number.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"
#include "io/pbrt/spectra.h"

namespace snell::io {

struct PbrtSpectrum {
  std::optional<PbrtTable> table;  // else `rgb`
  scene::Spectrum rgb{0.0f};

  // An RGB colour is taken as constant over a third of the wavelengths each.
  double At(double nanometres) const;
  // What is left of white light; not negative.
  scene::Spectrum Factor() const;
  // Light; a table has the luminance 1, as pbrt scales it.
  scene::Spectrum Light() const;
};

// Nothing if there is no such parameter, or, after a finding, no such spectrum.
std::optional<PbrtSpectrum> SpectrumOf(const PbrtParameters& parameters, std::string_view name,
                                       PbrtContext& context);

// The same as a factor between 0 and 1.
scene::Spectrum AlbedoOf(const PbrtParameters& parameters, std::string_view name,
                         const scene::Spectrum& absent, PbrtContext& context);

// Clamped to between 0 and 1.
scene::Spectrum Albedo(const scene::Spectrum& color);

float Largest(const scene::Spectrum& color);
float Mean(const scene::Spectrum& color);

}  // namespace snell::io
