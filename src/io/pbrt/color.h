// SPDX-License-Identifier: Apache-2.0
//
// From spectra to linear Rec.709: how a reflectance looks in daylight (D65), what colour light has.
// CIE 1931 2° observer and D65 in steps of 10 nm (ISO/CIE 11664-1, -2).
#pragma once

#include <functional>
#include <glm/vec2.hpp>

#include "scene/scene.h"

namespace snell::io {

// A quantity by wavelength in nanometres.
using SpectralFunction = std::function<double(double)>;

// Of a reflectance, or whatever multiplies light: 1 everywhere is white. Not negative.
scene::Spectrum ReflectanceColor(const SpectralFunction& reflectance);

// Of light, with the luminance 1; black if there is none to be seen.
scene::Spectrum LightColor(const SpectralFunction& power);

// Of light with these CIE xy coordinates, with the luminance 1.
scene::Spectrum LightColor(const glm::dvec2& chromaticity);

// Planck's law, without a unit; 0 at 0 K and below.
double BlackbodyRadiance(double nanometres, double kelvin);

}  // namespace snell::io
