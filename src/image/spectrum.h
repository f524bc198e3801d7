// SPDX-License-Identifier: Apache-2.0
//
// From spectra to linear Rec.709: how a reflectance looks in daylight (D65), what colour light has.
// CIE 1931 2° observer and D65 in steps of 10 nm (ISO/CIE 11664-1, -2).
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "image/image.h"

namespace snell::image {

// A quantity by wavelength in nanometres.
using SpectralFunction = std::function<double(double)>;

// Of a reflectance, or whatever multiplies light: 1 everywhere is white. Not negative.
vec3 ReflectanceColor(const SpectralFunction& reflectance);

// How much red, green and blue see of daylight at a wavelength, where white adds up to 1 over whole nanometres. May be
// negative.
glm::dvec3 DaylightResponse(double nanometres);

// Of light, with the luminance 1; black if there is none to be seen.
vec3 LightColor(const SpectralFunction& power);

// Of light with these CIE xy coordinates, with the luminance 1.
vec3 LightColor(const glm::dvec2& chromaticity);

// Planck's law, without a unit; 0 at 0 K and below.
double BlackbodyRadiance(double nanometres, double kelvin);

}  // namespace snell::image
