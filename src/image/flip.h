// SPDX-License-Identifier: Apache-2.0
//
// The difference that a viewer sees who flips between two pictures: LDR-FLIP, by Andersson, Nilsson,
// Akenine-Möller, Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating
// Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020. Section numbers in flip.cpp are theirs.
#pragma once

#include <vector>

#include "image/image.h"

namespace snell::image {

// A 0.7 m wide monitor of 3840 pixels, seen from 0.7 m.
inline constexpr float DefaultPixelsPerDegree = 67;

// One error per pixel from 0 (no difference) to 1 (blue against green). Colours are clamped to [0, 1]
// and seen as on an sRGB monitor; alpha counts as black behind. Values that are no numbers are black,
// and where only one of the pictures has such a value the error is 1. The sizes must agree (CHECK).
std::vector<float> FlipErrors(const Image& reference, const Image& test,
                              float pixelsPerDegree = DefaultPixelsPerDegree);

}  // namespace snell::image
