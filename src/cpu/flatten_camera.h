// SPDX-License-Identifier: Apache-2.0
//
// The scene's camera as the kernel's, and what its rays stand for.
#pragma once

#include "cpu/flatten.h"
#include "scene/scene.h"

namespace snell::cpu {

// Set the camera and the cone of its rays.
void FlattenCamera(const scene::Camera& camera, const scene::RenderSettings& settings,
                   FlatScene& flat);

// Note whether one of its rays may start inside of one of the scene's bodies.
void SeeWhetherInside(FlatScene& flat);

// Set another camera in a scene that is flattened, and nothing else: one that stands still, or the scene's own for a
// picture of another size. What was cut finer for the eye stays as it is.
void ReplaceCamera(const scene::Camera& camera, const scene::RenderSettings& settings,
                   FlatScene& flat);

}  // namespace snell::cpu
