// SPDX-License-Identifier: Apache-2.0
//
// The meshes of a file that Assimp has read, checked once more.
#pragma once

#include <optional>

#include "io/gltf/findings.h"
#include "io/read_limits.h"
#include "scene/scene.h"

struct aiMesh;

namespace snell::io {

// Nothing, with a note, if the mesh holds no triangles. Throws Error (without a place) if its indices are out
// of range or it has more than `triangleLimit` triangles.
std::optional<scene::Mesh> ReadAssimpMesh(const aiMesh& from, std::uint64_t triangleLimit,
                                          GltfFindings& findings, const std::string& part);

}  // namespace snell::io
