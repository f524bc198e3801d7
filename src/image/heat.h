// SPDX-License-Identifier: Apache-2.0
//
// A colour scale for maps of errors: black, purple, crimson, orange, cream. CIE lightness rises evenly,
// so that it reads the same in grey and for colour-blind eyes.
#pragma once

#include "image/image.h"

namespace snell::image {

// The linear colour for a value from 0 (black) to 1 (cream); values outside are clamped, NaN is 1.
vec3 HeatColor(float value);

}  // namespace snell::image
