// SPDX-License-Identifier: Apache-2.0
#include "image/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "image/chromaticity.h"

namespace snell::image {
namespace {

constexpr double FirstWavelength = 380;
constexpr double Step = 10;
constexpr std::size_t Count = 41;

// x̄, ȳ, z̄ and the power of D65.
constexpr std::array<std::array<double, 4>, Count> Observer = {{
    {0.001368, 0.000039, 0.006450, 49.9755}, {0.004243, 0.000120, 0.020050, 54.6482},
    {0.014310, 0.000396, 0.067850, 82.7549}, {0.043510, 0.001210, 0.207400, 91.4860},
    {0.134380, 0.004000, 0.645600, 93.4318}, {0.283900, 0.011600, 1.385600, 86.6823},
    {0.348280, 0.023000, 1.747060, 104.865}, {0.336200, 0.038000, 1.772110, 117.008},
    {0.290800, 0.060000, 1.669200, 117.812}, {0.195360, 0.090980, 1.287640, 114.861},
    {0.095640, 0.139020, 0.812950, 115.923}, {0.032010, 0.208020, 0.465180, 108.811},
    {0.004900, 0.323000, 0.272000, 109.354}, {0.009300, 0.503000, 0.158200, 107.802},
    {0.063270, 0.710000, 0.078250, 104.790}, {0.165500, 0.862000, 0.042160, 107.689},
    {0.290400, 0.954000, 0.020300, 104.405}, {0.433450, 0.994950, 0.008750, 104.046},
    {0.594500, 0.995000, 0.003900, 100.000}, {0.762100, 0.952000, 0.002100, 96.3342},
    {0.916300, 0.870000, 0.001650, 95.7880}, {1.026300, 0.757000, 0.001100, 88.6856},
    {1.062200, 0.631000, 0.000800, 90.0062}, {1.002600, 0.503000, 0.000340, 89.5991},
    {0.854450, 0.381000, 0.000190, 87.6987}, {0.642400, 0.265000, 0.000050, 83.2886},
    {0.447900, 0.175000, 0.000020, 83.6992}, {0.283500, 0.107000, 0, 80.0268},
    {0.164900, 0.061000, 0, 80.2146},        {0.087400, 0.032000, 0, 82.2778},
    {0.046770, 0.017000, 0, 78.2842},        {0.022700, 0.008210, 0, 69.7213},
    {0.011359, 0.004102, 0, 71.6091},        {0.005790, 0.002091, 0, 74.3490},
    {0.002899, 0.001047, 0, 61.6040},        {0.001440, 0.000520, 0, 69.8856},
    {0.000690, 0.000249, 0, 75.0870},        {0.000332, 0.000120, 0, 63.5927},
    {0.000166, 0.000060, 0, 46.4182},        {0.000083, 0.000030, 0, 66.8054},
    {0.000042, 0.000015, 0, 63.3828},
}};

// CIE XYZ of light.
glm::dvec3 Integrate(const SpectralFunction& f, bool inDaylight) {
  glm::dvec3 xyz(0.0);
  for (std::size_t i = 0; i < Count; ++i) {
    const auto& [x, y, z, d65] = Observer[i];
    const double value = f(FirstWavelength + Step * double(i)) * (inDaylight ? d65 : 1);
    if (std::isfinite(value)) xyz += glm::dvec3(x, y, z) * value;
  }
  return xyz;
}

glm::dvec3 ToRgb(const glm::dvec3& xyz) {
  static const glm::dmat3 matrix = glm::inverse(RgbToXyz({}));
  return matrix * xyz;
}

// Colours that Rec.709 cannot show become the nearest on its border.
vec3 Clipped(const glm::dvec3& rgb) { return vec3(glm::max(rgb, glm::dvec3(0.0))); }

}  // namespace

vec3 ReflectanceColor(const SpectralFunction& reflectance) {
  static const glm::dvec3 white = ToRgb(Integrate([](double) { return 1.0; }, true));
  return Clipped(ToRgb(Integrate(reflectance, true)) / white);
}

glm::dvec3 DaylightResponse(double nanometres) {
  static const glm::dvec3 white = ToRgb(Integrate([](double) { return 1.0; }, true)) * Step;
  const double place = (nanometres - FirstWavelength) / Step;
  if (!(place >= 0 && place <= double(Count - 1))) return glm::dvec3(0.0);
  const std::size_t i = std::min(std::size_t(place), Count - 2);
  const auto at = [](std::size_t row) {
    const auto& [x, y, z, d65] = Observer[row];
    return glm::dvec3(x, y, z) * d65;
  };
  return ToRgb(glm::mix(at(i), at(i + 1), place - double(i))) / white;
}

vec3 LightColor(const SpectralFunction& power) {
  const glm::dvec3 xyz = Integrate(power, false);
  return xyz.y > 0 && std::isfinite(1 / xyz.y) ? Clipped(ToRgb(xyz / xyz.y)) : vec3(0.0f);
}

vec3 LightColor(const glm::dvec2& chromaticity) {
  const double x = chromaticity.x, y = chromaticity.y;
  return Clipped(ToRgb(glm::dvec3(x / y, 1, (1 - x - y) / y)));
}

double BlackbodyRadiance(double nanometres, double kelvin) {
  constexpr double SecondConstant = 1.438776877e7;  // h c / k, nm·K
  if (!(kelvin > 0)) return 0;
  // Relative to 560 nm, so that nothing overflows
  const double ratio = 560 / nanometres;
  return std::pow(ratio, 5) * std::expm1(SecondConstant / (560 * kelvin)) /
         std::expm1(SecondConstant / (nanometres * kelvin));
}

}  // namespace snell::image
