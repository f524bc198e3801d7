// SPDX-License-Identifier: Apache-2.0
#include "image/color.h"

#include <cmath>

namespace snell::image {

float EncodeSrgb(float linear) {
  if (linear <= 0.0031308f) return 12.92f * linear;
  return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float DecodeSrgb(float encoded) {
  if (encoded <= 0.04045f) return encoded / 12.92f;
  return std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

vec3 EncodeSrgb(const vec3& linear) {
  return {EncodeSrgb(linear.x), EncodeSrgb(linear.y), EncodeSrgb(linear.z)};
}

vec3 DecodeSrgb(const vec3& encoded) {
  return {DecodeSrgb(encoded.x), DecodeSrgb(encoded.y), DecodeSrgb(encoded.z)};
}

vec3 Expose(const vec3& color, float stops) { return color * std::exp2(stops); }

// The product of a float and the largest code is exact in double precision, and so is the rounding.
template <typename Code>
static Code Quantize(float value, double largest) {
  if (!(value > 0)) return 0;
  if (value >= 1) return Code(largest);
  return Code(double(value) * largest + 0.5);
}

std::uint8_t Quantize8(float value) { return Quantize<std::uint8_t>(value, 255); }

std::uint16_t Quantize16(float value) { return Quantize<std::uint16_t>(value, 65535); }

static float FiniteOrZero(float value) { return std::isfinite(value) ? value : 0.0f; }

vec3 FiniteOrZero(const vec3& color) {
  return {FiniteOrZero(color.x), FiniteOrZero(color.y), FiniteOrZero(color.z)};
}

bool IsFinite(const vec3& color) {
  return std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
}

}  // namespace snell::image
