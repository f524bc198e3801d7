// SPDX-License-Identifier: Apache-2.0
#include "image/view.h"

#include <algorithm>
#include <cmath>

#include "image/color.h"

namespace snell::image {

namespace {

constexpr float MiddleGrey = 0.18f;

// Rows of a matrix of colours.
struct Matrix {
  vec3 rows[3];

  vec3 operator*(const vec3& c) const {
    const auto dot = [&](const vec3& r) { return r.x * c.x + r.y * c.y + r.z * c.z; };
    return {dot(rows[0]), dot(rows[1]), dot(rows[2])};
  }
};

template <class Function>
vec3 PerChannel(const vec3& c, Function f) {
  return {f(c.x), f(c.y), f(c.z)};
}

vec3 Clamped(const vec3& c) {
  return PerChannel(c, [](float x) { return std::clamp(x, 0.0f, 1.0f); });
}

// AgX's sigmoid: a line through a pivot, bent to (0, 0) and (1, 1) by hyperbolas of two powers (Sobotka's generator of
// the configuration, with its values).
float AgxCurve(float x) {
  constexpr float PivotX = 10.0f / 16.5f, PivotY = 0.5f, Slope = 2, Toe = 3, Shoulder = 3.25f;
  const auto bend = [](float run, float rise, float power, float along) {
    const float line = Slope * run;
    const float scale = line * std::pow(std::pow(line / rise, power) - 1, -1 / power);
    const float u = Slope * along / scale;
    return scale * u / std::pow(1 + std::pow(u, power), 1 / power);
  };
  if (x < PivotX) return PivotY - bend(PivotX, PivotY, Toe, PivotX - x);
  return PivotY + bend(1 - PivotX, 1 - PivotY, Shoulder, x - PivotX);
}

struct Band {
  float below;  // stops from middle grey
  vec3 code;
};

// The legend is in docs/views.md.
constexpr float DisplayWhite = 2.4739f;  // stops; log2(1 / 0.18)
const Band Bands[] = {
    {-6, {0.10f, 0.04f, 0.16f}},
    {-4, {0.16f, 0.20f, 0.65f}},
    {-2, {0.13f, 0.50f, 0.80f}},
    {-1, {0.15f, 0.65f, 0.60f}},
    {-0.5f, {0.20f, 0.55f, 0.30f}},
    {0.5f, {0.50f, 0.50f, 0.50f}},
    {1, {0.55f, 0.75f, 0.25f}},
    {2, {0.85f, 0.85f, 0.25f}},
    {DisplayWhite, {0.95f, 0.75f, 0.20f}},
    {4, {0.95f, 0.50f, 0.15f}},
    {6, {0.85f, 0.15f, 0.15f}},
};
constexpr vec3 Brightest = {1.0f, 0.75f, 0.90f};

}  // namespace

const std::vector<std::pair<std::string, View>>& ViewNames() {
  static const std::vector<std::pair<std::string, View>> names = {
      {"srgb", View::Srgb},
      {"agx", View::Agx},
      {"neutral", View::Neutral},
      {"aces", View::Aces},
      {"false-color", View::FalseColor},
      {"raw", View::Raw},
  };
  return names;
}

vec3 AgxTone(const vec3& linear) {
  // To Rec.2020 and into a smaller gamut, so that bright colours fade evenly (matrices of EaryChow's AgX for Blender)
  static constexpr Matrix ToRec2020 = {{{0.6274039f, 0.3292830f, 0.0433131f},
                                        {0.0690973f, 0.9195404f, 0.0113623f},
                                        {0.0163914f, 0.0880133f, 0.8955953f}}};
  static constexpr Matrix FromRec2020 = {{{1.6604910f, -0.5876411f, -0.0728499f},
                                          {-0.1245505f, 1.1328999f, -0.0083494f},
                                          {-0.0181508f, -0.1005789f, 1.1187297f}}};
  static constexpr Matrix Inset = {{{0.856627153f, 0.0951212405f, 0.0482516061f},
                                    {0.137318973f, 0.761241991f, 0.101439036f},
                                    {0.111898213f, 0.0767994186f, 0.811302368f}}};
  static constexpr Matrix Outset = {{{1.12710058f, -0.110606643f, -0.0164939387f},
                                     {-0.141329763f, 1.15782370f, -0.0164939387f},
                                     {-0.141329763f, -0.110606643f, 1.25193641f}}};
  constexpr float LeastStops = -12.47393f, MostStops = 4.026069f;
  const vec3 curved = PerChannel(Inset * (ToRec2020 * linear), [](float x) {
    const float stops = std::log2(std::max(x, 1e-10f));
    const float place = (stops - LeastStops) / (MostStops - LeastStops);
    return AgxCurve(std::clamp(place, 0.0f, 1.0f));
  });
  // The curve gives code values of a display with the power 2.2
  const vec3 light =
      PerChannel(Outset * curved, [](float x) { return std::pow(std::max(x, 0.0f), 2.2f); });
  return Clamped(FromRec2020 * light);
}

vec3 NeutralTone(const vec3& linear) {
  constexpr float F90 = 0.04f, Start = 0.8f - F90, Desaturation = 0.15f;
  vec3 c = PerChannel(linear, [](float x) { return std::max(x, 0.0f); });
  const float least = std::min({c.x, c.y, c.z});
  c -= vec3(least <= 2 * F90 ? least - least * least / (4 * F90) : F90);
  const float peak = std::max({c.x, c.y, c.z});
  if (peak <= Start) return c;
  constexpr float Room = 1 - Start;
  const float newPeak = 1 - Room * Room / (peak + Room - Start);
  c *= newPeak / peak;
  const float white = 1 - 1 / (Desaturation * (peak - newPeak) + 1);
  return Clamped(c + (vec3(newPeak) - c) * white);
}

vec3 AcesTone(const vec3& linear) {
  static constexpr Matrix Input = {{{0.59719f, 0.35458f, 0.04823f},
                                    {0.07600f, 0.90834f, 0.01566f},
                                    {0.02840f, 0.13383f, 0.83777f}}};
  static constexpr Matrix Output = {{{1.60475f, -0.53108f, -0.07367f},
                                     {-0.10208f, 1.10813f, -0.00605f},
                                     {-0.00327f, -0.07276f, 1.07602f}}};
  const vec3 fitted = PerChannel(Input * linear, [](float x) {
    const float v = std::clamp(x, 0.0f, 1e8f);
    return (v * (v + 0.0245786f) - 0.000090537f) / (v * (0.983729f * v + 0.4329510f) + 0.238081f);
  });
  return Clamped(Output * fitted);
}

vec3 FalseColor(const vec3& linear) {
  const float luminance = std::max(Luminance(linear), 1e-10f);
  const float stops = std::log2(luminance / MiddleGrey);
  for (const Band& band : Bands) {
    if (stops < band.below) return band.code;
  }
  return Brightest;
}

vec3 ViewColor(View view, const vec3& linear) {
  switch (view) {
    case View::Srgb: return EncodeSrgb(linear);
    case View::Agx: return EncodeSrgb(AgxTone(linear));
    case View::Neutral: return EncodeSrgb(NeutralTone(linear));
    case View::Aces: return EncodeSrgb(AcesTone(linear));
    case View::FalseColor: return FalseColor(linear);
    case View::Raw: return linear;
  }
  return linear;
}

}  // namespace snell::image
