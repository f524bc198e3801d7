// SPDX-License-Identifier: Apache-2.0
#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "image/color.h"
#include "image/flip.h"
#include "image/heat.h"
#include "util/error.h"

namespace snell::image {

static void CheckSizes(const Image& reference, const Image& test) {
  if (reference.width == test.width && reference.height == test.height) return;
  throw Error(fmt::format("the pictures differ in size: {}×{} and {}×{} pixels", reference.width,
                          reference.height, test.width, test.height));
}

// t − r; 0 where both are NaN or the same infinity, infinite where one is not finite.
static double Difference(float r, float t) {
  if (std::isfinite(r) && std::isfinite(t)) return double(t) - double(r);
  if (r == t || (std::isnan(r) && std::isnan(t))) return 0;
  return std::numeric_limits<double>::infinity();
}

// A channel as an 8-bit picture shows it, before rounding.
static double Shown(float linear) {
  return double(EncodeSrgb(std::isnan(linear) ? 0.0f : std::clamp(linear, 0.0f, 1.0f)));
}

Comparison Compare(const Image& reference, const Image& test) {
  CheckSizes(reference, test);
  Comparison result;
  double squares = 0, relativeSquares = 0, shownSquares = 0, ofReference = 0, ofTest = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const vec3 r = reference.Premultiplied(i), t = test.Premultiplied(i);
    if (!IsFinite(r) || !IsFinite(t)) ++result.notFinite;
    for (int channel = 0; channel < 3; ++channel) {
      const double difference = Difference(r[channel], t[channel]);
      const double level = std::isfinite(r[channel]) ? double(r[channel]) : 0.0;
      const double shown =
          std::isfinite(difference) ? Shown(t[channel]) - Shown(r[channel]) : difference;
      squares += difference * difference;
      ofReference += double(r[channel]);
      ofTest += double(t[channel]);
      relativeSquares += difference * difference / (level * level + 0.01);
      shownSquares += shown * shown;
      if (std::fabs(difference) > result.maxAbs) {
        result.maxAbs = std::fabs(difference);
        result.maxX = int(i % std::size_t(reference.width));
        result.maxY = int(i / std::size_t(reference.width));
      }
    }
  }
  const double samples = 3.0 * double(reference.pixels.size());
  result.meanReference = ofReference / samples;
  result.meanTest = ofTest / samples;
  result.rmse = std::sqrt(squares / samples);
  result.relMse = relativeSquares / samples;
  result.psnr = -10 * std::log10(shownSquares / samples);

  double flip = 0;
  for (const float error : FlipErrors(reference, test)) flip += double(error);
  result.meanFlip = flip / double(reference.pixels.size());
  return result;
}

Image DifferenceImage(const Image& reference, const Image& test) {
  CheckSizes(reference, test);
  Image image{reference.width, reference.height};
  const std::vector<float> errors = FlipErrors(reference, test);
  std::transform(errors.begin(), errors.end(), image.pixels.begin(), HeatColor);
  return image;
}

}  // namespace snell::image
