// SPDX-License-Identifier: Apache-2.0
//
// How much two pictures of the same size differ: in numbers and as a picture. Alpha counts as black
// behind; differences of alpha alone are not seen.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace snell::image {

// Means are over all pixels and channels. Pixels that are not finite in the same way in both pictures
// (NaN with NaN, infinities of one sign) are equal; in one of the two only, they make the numbers
// infinite and the mean of FLIP count 1 there.
struct Comparison {
  double rmse = 0;  // root of the mean squared difference, linear
  double relMse = 0;  // mean of (t − r)² / (r² + 0.01), linear; the 0.01 bounds it where r is dark
  double psnr = 0;  // decibels, of the sRGB-encoded values in [0, 1] with peak 1; ∞ if they agree
  double maxAbs = 0;  // largest absolute difference of a channel, linear
  int maxX = 0;       // the pixel where that is, from the top left
  int maxY = 0;
  double meanReference = 0;  // of all channels, linear
  double meanTest = 0;
  double meanFlip = 0;          // mean FLIP error (flip.h), 0 to 1
  std::uint64_t notFinite = 0;  // pixels that hold a NaN or an infinity in either picture
};

// Throws Error if the sizes differ.
Comparison Compare(const Image& reference, const Image& test);

// The FLIP error of every pixel on a scale from black (none) over red to cream (heat.h). Throws Error if
// the sizes differ.
Image DifferenceImage(const Image& reference, const Image& test);

}  // namespace snell::image
