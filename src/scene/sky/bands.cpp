// SPDX-License-Identifier: Apache-2.0
#include "scene/sky/bands.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

#include "image/chromaticity.h"

namespace snell::scene {

namespace {

// A Gaussian with a width for each side.
double Lobe(double x, double middle, double below, double above) {
  const double t = (x - middle) * (x < middle ? below : above);
  return std::exp(-0.5 * t * t);
}

// CIE 1931 colour matching. Wyman, Sloan and Shirley 2013, "Simple analytic approximations to the CIE XYZ color
// matching functions", section 2.2.
glm::dvec3 ColorMatch(double nanometres) {
  const auto lobe = [&](double middle, double below, double above) {
    return Lobe(nanometres, middle, below, above);
  };
  return {0.362 * lobe(442.0, 0.0624, 0.0374) + 1.056 * lobe(599.8, 0.0264, 0.0323) -
              0.065 * lobe(501.1, 0.0490, 0.0382),
          0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322),
          1.217 * lobe(437.0, 0.0845, 0.0278) + 0.681 * lobe(459.0, 0.0385, 0.0725)};
}

// What each band adds to the three channels.
std::array<glm::dvec3, BandCount> Columns() {
  const glm::dmat3 toRgb = glm::inverse(image::RgbToXyz({}));
  std::array<glm::dvec3, BandCount> columns;
  for (int band = 0; band < BandCount; ++band)
    columns[std::size_t(band)] = toRgb * ColorMatch(BandNanometres(band)) * 20.0;
  return columns;
}

}  // namespace

Spectrum RgbOf(const Bands& perNanometre) {
  static const std::array<glm::dvec3, BandCount> columns = Columns();
  glm::dvec3 sum(0.0);
  for (std::size_t band = 0; band < BandCount; ++band)
    sum += columns[band] * double(perNanometre[band]);
  return Spectrum(glm::max(sum, glm::dvec3(0.0)));
}

}  // namespace snell::scene
