// SPDX-License-Identifier: Apache-2.0
#include "image/heat.h"

#include <algorithm>

#include "image/color.h"

namespace snell::image {

// Even steps of CIE lightness from 0 to 97, while the hue in Oklab (Ottosson 2020) turns from 288° over
// red to 102°, with 90 % of the chroma that sRGB allows there and at most 0.2; sRGB codes of 8 bits.
static constexpr int Steps = 10;
static constexpr unsigned char Points[Steps + 1][3] = {
    {0, 0, 0},     {43, 6, 70},    {82, 13, 91},   {126, 21, 101},  {171, 31, 98},  {214, 49, 83},
    {245, 85, 57}, {247, 136, 67}, {249, 177, 97}, {251, 214, 138}, {254, 248, 199}};

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
