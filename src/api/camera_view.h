// SPDX-License-Identifier: Apache-2.0
//
// Cameras as the public interface moves them: a place, a line of sight and an angle, whatever their kind.
#pragma once

#include "api/render.h"
#include "scene/scene.h"

namespace snell {

// Where a camera stands when its shutter opens, in a picture of that size.
CameraView ViewOfCamera(const scene::Camera& camera, int width, int height);

// The camera at another place, where it stands still. Throws Error if it cannot look like that.
scene::Camera CameraSeenFrom(scene::Camera camera, const CameraView& view);

}  // namespace snell
