// SPDX-License-Identifier: Apache-2.0
//
// From measured angles to the planes all around a lamp. Files leave out what symmetry gives, and photometry of types A
// and B counts its angles as longitude and latitude about other axes.
#pragma once

#include <string>
#include <vector>

#include "scene/light_profile.h"

namespace snell::io {

// What a file has measured: W/sr by angles in degrees that rise, verticals fastest.
struct Measurement {
  std::vector<double> verticals;
  std::vector<double> horizontals;
  std::vector<double> values;
};

// What is wrong with the angles; "": nothing.
std::string FaultOfC(const Measurement& measured);
std::string FaultOfAOrB(const Measurement& measured);

// Without a name.
scene::LightProfile ProfileOfC(const Measurement& measured);
scene::LightProfile ProfileOfB(const Measurement& measured);
scene::LightProfile ProfileOfA(const Measurement& measured);

}  // namespace snell::io
