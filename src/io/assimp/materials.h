// SPDX-License-Identifier: Apache-2.0
//
// The materials of a file that Assimp has read: classic and physical keys are understood as those of MTL
// files (obj/mtl_material.h).
#pragma once

#include <filesystem>
#include <vector>

#include "io/findings.h"
#include "io/read_options.h"
#include "scene/scene.h"

struct aiScene;

namespace snell::io {

// Adds materials, textures and pictures to the scene. Returns the material of each of the file's; -1 for the
// one that the library gives to what has none.
std::vector<scene::MaterialIndex> ReadAssimpMaterials(const aiScene& file,
                                                      const std::filesystem::path& path,
                                                      const ReadOptions& options,
                                                      const WarningSink& warn, Findings& findings,
                                                      scene::Scene& scene);

}  // namespace snell::io
