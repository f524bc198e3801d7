// SPDX-License-Identifier: Apache-2.0
//
// pbrt's spectra: tables by wavelength, from files, from the text or by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/spectrum.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

using image::BlackbodyRadiance;
using image::LightColor;
using image::ReflectanceColor;
using image::SpectralFunction;

// Values between which lines are drawn; constant beyond the ends.
struct PbrtTable {
  std::vector<double> wavelengths;  // nanometres, rising
  std::vector<double> values;
  double At(double wavelength) const;
};

// Of wavelengths and values in turn. Throws Error if they are not pairs, or do not rise.
PbrtTable MakeTable(const std::vector<double>& numbers, const Place& place);

// The same from a file's text: '#' begins a comment.
PbrtTable ParseTable(std::string_view text, const std::string& file);

// pbrt's names of measured quantities: "metal-Au-eta", "metal-Au-k", or of glass with its index of refraction
// at 587.6 nm. Null if there is no such name.
const PbrtTable* NamedTable(std::string_view name);

// Abbe's number of a named glass; 0 if there is none.
float AbbeNumber(std::string_view name);

// The colour of one of pbrt's named lights ("stdillum-A"), with the luminance 1.
std::optional<scene::Spectrum> NamedLight(std::string_view name);

}  // namespace snell::io
