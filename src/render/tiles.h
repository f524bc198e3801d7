// SPDX-License-Identifier: Apache-2.0
//
// The order in which a picture is worked on: square tiles along a Hilbert curve, so that neighbours in time
// are neighbours in the picture; and passes of growing numbers of samples.
#pragma once

#include <cstdint>
#include <vector>

#include "render/film.h"

namespace snell::render {

// Tiles of `size` pixels that cover `rect`, each pixel once.
std::vector<PixelRect> TilesInOrder(PixelRect rect, int size);

struct SampleRange {
  std::uint32_t first;
  std::uint32_t last;
};

// [first, last) cut into passes of 1, 1, 2, 4, … up to 64 samples.
std::vector<SampleRange> Passes(std::uint32_t first, std::uint32_t last);

}  // namespace snell::render
