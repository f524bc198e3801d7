// SPDX-License-Identifier: Apache-2.0
//
// Placing what a file holds that an object of a scene takes in (inclusions.h).
#pragma once

#include <string>

#include "io/toml/groups.h"

namespace snell::io {

// What a placement hands down to the members of its group.
struct Surroundings {
  Affine toWorld{1.0};
  std::string name;
  scene::MaterialIndex material = -1;
  bool visibleToCamera = true;
  bool visibleToSecondary = true;
  bool castsShadow = true;
  scene::Motion motion = {};  // takes the place of toWorld
};

// The motion of an object that stands, or moves, within them.
scene::Motion MotionWithin(const Surroundings& around, const scene::Object& object);

// "outer/inner"
std::string JoinNames(const std::string& outer, const std::string& inner);

// Place objects, lights and cameras of the file where `around`, which includes the member itself, says. Reports
// what cannot be placed.
void PlaceIncluded(Reader& reader, const Member& member, const Surroundings& around);

}  // namespace snell::io
