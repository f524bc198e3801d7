// SPDX-License-Identifier: Apache-2.0
//
// How a view moves: pure functions from one to the next. Angles in radians. Distances count in what lies between the
// camera and what it looks at, so that movements are as fast in a watch as in a town.
#pragma once

#include <array>

#include "api/render.h"

namespace snell::viewer {

// Turn around what is looked at: to the right and up. Stays off the poles.
CameraView Orbit(const CameraView& view, double right, double up);
// Turn in place.
CameraView Look(const CameraView& view, double right, double up);
// Move sideways, by shares of the picture's height, without turning.
CameraView Pan(const CameraView& view, double right, double up);
// Bring the camera nearer to what it looks at, or take it away: the distance is multiplied.
CameraView Dolly(const CameraView& view, double factor);
// Move the camera and what it looks at, by shares of their distance.
CameraView Fly(const CameraView& view, double right, double up, double forward);
// Look at another point from the same place, and turn around it from now on.
CameraView Focus(const CameraView& view, const std::array<double, 3>& point);

}  // namespace snell::viewer
