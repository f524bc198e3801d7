// SPDX-License-Identifier: Apache-2.0
//
// The scene's camera as the kernel's, and what its rays stand for.
#pragma once

#include "bvh/bounds.h"
#include "cpu/flatten.h"
#include "scene/scene.h"

namespace snell::cpu {

// Set the camera and the cone of its rays.
void FlattenCamera(const scene::Camera& camera, const scene::RenderSettings& settings,
                   FlatScene& flat);

// Whether a ray of the flattened camera may start in the box.
bool MayStartIn(const bvh::Bounds& box, const FlatScene& flat);

}  // namespace snell::cpu
