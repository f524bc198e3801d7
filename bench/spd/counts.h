// SPDX-License-Identifier: Apache-2.0
//
// How many rays Snell follows in the Standard Procedural Databases, to be compared with the published
// numbers. Those hold for rays through the corners of 512 × 512 pixels, five levels of rays and no cut-off;
// the databases' own view and the settings of NFF files give the same.
#pragma once

#include <cstdint>

#include "spd/generators.h"

namespace snell::spd {

struct RayCounts {
  std::int64_t eye = 0;  // all of them, whether they hit anything or not
  std::int64_t reflected = 0;
  std::int64_t refracted = 0;
  std::int64_t shadow = 0;
};

// Render the database at its usual size and count. The picture has `side` × `side` pixels: 513 as published;
// fewer rays give numbers in proportion.
RayCounts CountRays(const Database& database, int side = 513);

}  // namespace snell::spd
