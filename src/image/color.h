// SPDX-License-Identifier: Apache-2.0
//
// From light to numbers in a file and back: the sRGB transfer function (IEC 61966-2-1:1999, §5.2),
// Rec.709 luminance, exposure, and rounding to integers. Primaries are in chromaticity.h.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace snell::image {

// Linear light to the sRGB code value and back, both 0 to 1. Beyond, the functions go on: the power
// above 1, the linear piece below 0; NaN stays NaN.
float EncodeSrgb(float linear);
float DecodeSrgb(float encoded);
vec3 EncodeSrgb(const vec3& linear);
vec3 DecodeSrgb(const vec3& encoded);

// The relative luminance Y of a linear Rec.709 colour (ITU-R BT.709-6, §3.2).
inline float Luminance(const vec3& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

// A colour made brighter by `stops` photographic stops: each doubles it.
vec3 Expose(const vec3& color, float stops);

// The nearest integer code for a value in [0, 1]; values outside are clamped, NaN becomes 0.
std::uint8_t Quantize8(float value);
std::uint16_t Quantize16(float value);

// The colour, with 0 for each channel that is NaN or infinite.
vec3 FiniteOrZero(const vec3& color);

bool IsFinite(const vec3& color);

}  // namespace snell::image
