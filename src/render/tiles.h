// SPDX-License-Identifier: Apache-2.0
//
// The order in which a picture is worked on: square tiles along a Hilbert curve, so that neighbours in time
// are neighbours in the picture.
#pragma once

#include <vector>

#include "render/film.h"

namespace snell::render {

// Tiles of `size` pixels that cover `rect`, each pixel once.
std::vector<PixelRect> TilesInOrder(PixelRect rect, int size);

}  // namespace snell::render
