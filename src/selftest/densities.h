// SPDX-License-Identifier: Apache-2.0
//
// Whether samples fall as a density says: χ² over cells of the unit square, or of directions by the sine of half their angle
// from an axis and their azimuth, with the density integrated by the midpoint rule. Same numbers in every run.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "kernel/math.h"

namespace snell::selftest {

using kernel::uint;
using kernel::vec2;
using kernel::vec3;

// Independent points of the unit square: number `index` of the row `seed`.
vec2 RandomPoint(uint index, uint seed);

// The p-value of points, or of what `density` says of the square; points may be missing.
using PointSampler = std::function<std::optional<vec2>(uint index)>;
double PValueOnSquare(const PointSampler& sample, const std::function<double(vec2)>& density);

// The same for directions within a cone, whose cosine is at least `leastCosine`.
struct Cone {
  vec3 axis = {0, 0, 1};
  float leastCosine = -1;
};
using DirectionSampler = std::function<std::optional<vec3>(uint index)>;
double PValueOfDirections(const Cone& cone, const DirectionSampler& sample,
                          const std::function<double(vec3)>& density);

}  // namespace snell::selftest
