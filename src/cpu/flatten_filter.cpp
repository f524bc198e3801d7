// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_filter.h"

#include <bit>
#include <cmath>
#include <numbers>

namespace snell::cpu {

static float UsualRadius(scene::PixelFilter filter) {
  switch (filter) {
    case scene::PixelFilter::Box: return 0.5f;
    case scene::PixelFilter::Tent: return 1.0f;
    case scene::PixelFilter::Gaussian:
    case scene::PixelFilter::BlackmanHarris: return 1.5f;
  }
  return 0.5f;
}

double FilterDistribution(scene::PixelFilter filter, double x) {
  // The left half; the right one by symmetry
  if (x > 0) return 1 - FilterDistribution(filter, -x);
  switch (filter) {
    case scene::PixelFilter::Box: break;
    case scene::PixelFilter::Tent: return (1 + x) * (1 + x) / 2;
    case scene::PixelFilter::Gaussian: {
      // Cut off at three standard deviations
      const double cut = std::erfc(3 / std::numbers::sqrt2) / 2;
      return (std::erfc(-3 * x / std::numbers::sqrt2) / 2 - cut) / (1 - 2 * cut);
    }
    case scene::PixelFilter::BlackmanHarris: {
      // The four-term window (Harris 1978), integrated
      const double a = std::numbers::pi * x;
      return (0.35875 * (a + std::numbers::pi) + 0.48829 * std::sin(a) +
              0.14128 / 2 * std::sin(2 * a) + 0.01168 / 3 * std::sin(3 * a)) /
             (2 * std::numbers::pi * 0.35875);
    }
  }
  return (1 + x) / 2;
}

void FlattenFilter(scene::PixelFilter filter, float radius, kernel::RenderParams& params) {
  if (radius <= 0) radius = UsualRadius(filter);
  double lower = -1;
  for (kernel::uint i = 0; i < kernel::FilterQuantileCount; ++i) {
    // 32 masses to the octave, evenly between powers of two
    const double mass = double(std::bit_cast<float>(0x33800000u + (i << 18)));

    // Bisect between the quantile before and the middle
    double upper = 0;
    double x = lower;
    for (int step = 0; step < 40 && mass < 0.5; ++step) {
      x = (lower + upper) / 2;
      (FilterDistribution(filter, x) < mass ? lower : upper) = x;
    }
    params.filterQuantiles[i] = mass < 0.5 ? float(x) * radius : 0.0f;
  }
}

}  // namespace snell::cpu
