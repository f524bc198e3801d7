// SPDX-License-Identifier: Apache-2.0
//
// The materials of an OBJ scene: finds and reads the libraries that the file names, and makes materials of
// what its faces use.
#pragma once

#include <vector>

#include "io/findings.h"
#include "io/obj/parts.h"
#include "scene/scene.h"

namespace snell::io {

// Adds materials, textures and pictures to the scene. Returns the material of each part, -1 where the file
// names none that is defined.
std::vector<scene::MaterialIndex> ReadObjMaterials(const ObjParts& parts, const MeshFile& file,
                                                   scene::Scene& scene);

}  // namespace snell::io
