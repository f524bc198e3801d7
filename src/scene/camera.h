// SPDX-License-Identifier: Apache-2.0
//
// What a camera sees: the size of its picture in the units of its kind (kernel::Camera). Square pixels where the kind
// has a free choice.
#pragma once

#include <glm/vec2.hpp>

#include "scene/scene.h"

namespace snell::scene {

// Half the width and height: of the plane at distance 1 (pinhole), in metres (orthographic), in radians (panorama), or
// in a fisheye's distances from the axis. A panorama from right to left has a negative width.
glm::dvec2 HalfExtent(const Camera& camera, int width, int height);

// Where a fisheye shows what is at this angle from its axis.
double FisheyeDistance(FisheyeProjection projection, double angle);

}  // namespace snell::scene
