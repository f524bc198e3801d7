// SPDX-License-Identifier: Apache-2.0
//
// Cameras and lights of a file that Assimp has read.
#pragma once

#include <optional>

#include "scene/scene.h"

struct aiCamera;
struct aiLight;

namespace snell::io {

// Nothing if the record makes no sense or there is nothing like it in Snell. `hasAngle`: whether the library has
// read the angle of view; otherwise it is the usual one.
std::optional<scene::Camera> ReadAssimpCamera(const aiCamera& from, const scene::Affine& world,
                                              bool& hasAngle);
std::optional<scene::Light> ReadAssimpLight(const aiLight& from, const scene::Affine& world);

}  // namespace snell::io
