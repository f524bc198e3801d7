// SPDX-License-Identifier: Apache-2.0
#include "image/filter.h"

#include <algorithm>
#include <cstdint>

#include "util/check.h"
#include "util/threads.h"

namespace snell::image {

static void ConvolveRow(const float* from, float* to, int width, const Kernel& kernel) {
  // Write the row with its ends prolonged, so that the sum needs no conditions
  std::vector<float> prolonged(std::size_t(width + 2 * kernel.radius));
  for (int x = -kernel.radius; x < width + kernel.radius; ++x)
    prolonged[std::size_t(x + kernel.radius)] = from[std::clamp(x, 0, width - 1)];

  // Convolution reads backwards: the weight of offset k meets the pixel at x − k
  for (int x = 0; x < width; ++x) {
    double sum = 0;
    for (int k = -kernel.radius; k <= kernel.radius; ++k)
      sum += kernel.weights[std::size_t(k + kernel.radius)] *
             double(prolonged[std::size_t(x - k + kernel.radius)]);
    to[x] = float(sum);
  }
}

Plane Convolve(const Plane& plane, int width, int height, const Kernel& horizontal,
               const Kernel& vertical) {
  CHECK(width > 0 && height > 0 && plane.size() == std::size_t(width) * std::size_t(height));
  const auto row = [&](int y) { return std::size_t(y) * std::size_t(width); };

  Plane across(plane.size());
  ParallelInOrder(std::uint64_t(height), [&](std::uint64_t y, int) {
    ConvolveRow(&plane[row(int(y))], &across[row(int(y))], width, horizontal);
  });

  Plane result(plane.size());
  ParallelInOrder(std::uint64_t(height), [&](std::uint64_t y, int) {
    std::vector<double> sums(static_cast<std::size_t>(width), 0.0);
    for (int k = -vertical.radius; k <= vertical.radius; ++k) {
      const double weight = vertical.weights[std::size_t(k + vertical.radius)];
      const float* from = &across[row(std::clamp(int(y) - k, 0, height - 1))];
      for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += weight * double(from[x]);
    }
    std::transform(sums.begin(), sums.end(), &result[row(int(y))],
                   [](double sum) { return float(sum); });
  });
  return result;
}

}  // namespace snell::image
