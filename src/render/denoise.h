// SPDX-License-Identifier: Apache-2.0
//
// What a denoiser is given: the picture as two halves with as many samples each, what is known of the surfaces behind
// it, again as halves, and how far the samples scatter.
#pragma once

#include <array>
#include <vector>

#include "image/image.h"
#include "kernel/dialect.h"

namespace snell::render {

using kernel::vec3;

// Means over the samples of each half; rows from the top.
struct DenoiseInput {
  int width = 0;
  int height = 0;
  std::array<std::vector<vec3>, 2> color;      // not negative, finite
  std::array<std::vector<vec3>, 2> albedo;     // 0 to 1
  std::array<std::vector<vec3>, 2> normal;     // −1 to 1
  std::array<std::vector<float>, 2> nearness;  // 1 / distance, 0 where nothing is
  std::vector<vec3> variance;  // of the mean of both colours, by the samples' scatter

  std::size_t Pixels() const { return std::size_t(width) * std::size_t(height); }
};

// The picture without its noise by nonlinearly weighted first-order regression (nfor.cpp). The same on any number of
// threads.
image::Image DenoiseByRegression(const DenoiseInput& input);

}  // namespace snell::render
