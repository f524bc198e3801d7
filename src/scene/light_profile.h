// SPDX-License-Identifier: Apache-2.0
//
// How a lamp shines by direction, as measured (goniophotometry). Part of the scene (scene.h).
#pragma once

#include <string>
#include <vector>

namespace snell::scene {

// A table of intensities by two angles, interpolated between; as IES's and CIE's C planes have it.
struct LightProfile {
  std::string name;  // of its file, for messages
  // From the light's direction, radians, rising; what lies outside is dark
  std::vector<float> verticals;
  // About it, radians, rising from 0 to 2π; a single one: the same all around
  std::vector<float> horizontals;
  std::vector<float> intensities;  // W/sr, verticals fastest; none negative
};

}  // namespace snell::scene
