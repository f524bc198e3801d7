// SPDX-License-Identifier: Apache-2.0
//
// What a scene refers to by indices, moved into another scene.
#pragma once

#include "scene/scene.h"

namespace snell::io {

// Move pictures, textures, materials and meshes of `from` behind those of `to`. Cameras, lights and objects
// stay in `from`, and their indices count in `to`; -1 stays -1.
void AppendResources(scene::Scene& from, scene::Scene& to);

}  // namespace snell::io
