// SPDX-License-Identifier: Apache-2.0
#include "image/heat.h"

#include <algorithm>

#include "image/color.h"

namespace snell::image {

// Even steps of Oklab lightness (Ottosson 2020) from 0 to 0.975 while the hue turns from 285° over red
// to 102°, with 92 % of the chroma that sRGB allows there; sRGB codes of 8 bits.
static constexpr int Steps = 10;
static constexpr unsigned char Points[Steps + 1][3] = {
    {0, 0, 0},     {5, 0, 15},     {37, 3, 43},    {77, 7, 64},     {123, 17, 72},  {173, 27, 65},
    {220, 51, 28}, {232, 115, 38}, {249, 161, 51}, {252, 208, 118}, {254, 249, 204}};

vec3 HeatColor(float value) {
  const float clamped = value <= 0 ? 0.0f : value < 1 ? value : 1.0f;
  const float position = clamped * float(Steps);
  const int step = std::min(int(position), Steps - 1);
  const float t = position - float(step);
  const auto& a = Points[step];
  const auto& b = Points[step + 1];
  const vec3 code = vec3(a[0], a[1], a[2]) * (1 - t) + vec3(b[0], b[1], b[2]) * t;
  return DecodeSrgb(code / 255.0f);
}

}  // namespace snell::image
