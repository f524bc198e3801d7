// SPDX-License-Identifier: Apache-2.0
//
// Where the sun stands at a time and a place, to a hundredth of a degree from 1950 to 2050. Michalsky 1988, "The
// Astronomical Almanac's algorithm for approximate solar position".
#pragma once

#include <optional>
#include <string_view>

namespace snell::scene {

struct SunPosition {
  double elevation = 0;  // radians, without refraction by the air
  double azimuth = 0;    // radians from north by east
};

// Days are counted from noon of the first of January 2000, universal time. Latitude and longitude in radians, north and
// east positive.
SunPosition SunAt(double days, double latitude, double longitude);

// The days of "2026-06-21T12:00:00+02:00" or "2026-06-21T10:00Z"; nothing for other text.
std::optional<double> DaysOf(std::string_view time);

}  // namespace snell::scene
