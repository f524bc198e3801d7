// SPDX-License-Identifier: Apache-2.0
//
// How far a pixel is, probably, from its value after endless samples, as it shows on a display. The standard error
// of the mean of n samples of variance s² is √(g·s²/n): g = 1 if they were independent; how much better Sobol' points
// do is measured by how close the means of two halves are to one another, over 9 × 9 pixels. The display's curve
// stands for a square root (Dammertz, Hanika, Keller and Lensch 2010, "A hierarchical automatic stopping condition
// for Monte Carlo global illumination", section 2). Only + − × ÷ √: the same on every machine. docs/long-renders.md
// says what that is worth.
#pragma once

#include <vector>

#include "render/film.h"

namespace snell::render {

// A radiance as it shows, 1 for the display's white: √(x + 0.0015), which has sRGB's slope at black. `scale` is the
// exposure's factor.
double DisplayValue(double radiance, double scale);

// Per pixel, rows from top to bottom: DisplayValue's standard error, its square half the pixel's own and half the mean
// of 3 × 3. Pixels with less than two samples count as 0.
std::vector<float> DisplayErrors(const Film& film, double scale);

// The largest value within `radius` pixels to each side, rows and columns.
std::vector<float> LargestNearby(const std::vector<float>& values, int width, int radius);

}  // namespace snell::render
