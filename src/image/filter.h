// SPDX-License-Identifier: Apache-2.0
//
// Separable filtering of one channel, as image metrics need it.
#pragma once

#include <vector>

namespace snell::image {

// One channel of a picture, row by row from the top.
using Plane = std::vector<float>;

// The weights of a filter in one direction, for offsets −radius … radius.
struct Kernel {
  int radius = 0;
  std::vector<double> weights{1.0};
};

// The plane convolved with `horizontal` along its rows and `vertical` along its columns, summed in double
// precision: derivatives of what is flat must be 0. Pixels beyond the edges are those at the edges. Runs
// on all threads; the result does not depend on their number.
Plane Convolve(const Plane& plane, int width, int height, const Kernel& horizontal,
               const Kernel& vertical);

}  // namespace snell::image
