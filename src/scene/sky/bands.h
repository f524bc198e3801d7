// SPDX-License-Identifier: Apache-2.0
//
// Spectra of the atmosphere's optics as 16 bands of light, 20 nm wide, and what the eye makes of them. Watts that leave
// here are weighted by the eye: a luminance or illuminance of 683 lm counts as 1 W, as for all photometric input.
#pragma once

#include <array>

#include "kernel/dialect.h"

namespace snell::scene {

using kernel::Spectrum;

inline constexpr int BandCount = 16;
using Bands = std::array<float, BandCount>;

// The middle of a band: 390 to 690 nm.
inline constexpr double BandNanometres(int band) { return 390.0 + 20.0 * band; }

// Linear Rec.709 of a quantity per nanometre. Colours out of its gamut lose their negative channels.
Spectrum RgbOf(const Bands& perNanometre);

// Irradiance of the sun above the atmosphere, W/(m²·nm): ASTM G-173, means over the bands.
inline constexpr Bands SolarIrradiance = {1.0798f, 1.7291f, 1.6506f, 1.9734f, 2.0213f, 1.9459f,
                                          1.8733f, 1.8808f, 1.8509f, 1.8343f, 1.7981f, 1.7249f,
                                          1.6642f, 1.5631f, 1.5338f, 1.4611f};

}  // namespace snell::scene
