// SPDX-License-Identifier: Apache-2.0
//
// A whole OBJ file as objects with materials: the faces of each object, group and material become an object
// of their own. docs/obj.md describes it for users.
#pragma once

#include <filesystem>

#include "io/mesh/read_mesh.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

// The objects, meshes, materials, textures and pictures of the file and of what it names in its own folder;
// no camera, no lights. Objects whose material is not
// defined have material -1. At most about a thousand objects besides one for each material: of files with more
// groups, those that share a material are merged. Throws Error like ReadMesh, and for malformed libraries.
scene::Scene ReadObjScene(const std::filesystem::path& path, const MeshReadOptions& options,
                          const WarningSink& warn);

}  // namespace snell::io
