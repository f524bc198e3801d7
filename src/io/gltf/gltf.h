// SPDX-License-Identifier: Apache-2.0
//
// glTF 2.0 files (.gltf, .glb) as scenes. docs/gltf.md says what is read, approximated and left out. The
// parts: document.h opens the file, data.h reads its numbers, nodes.h places the nodes,
// meshes.h, materials.h and places.h make what stands in the scene.
#pragma once

#include <filesystem>
#include <optional>

#include "scene/scene.h"

namespace snell::io {

// The file's cameras, lights and objects, no others. `time` in seconds plays its animations; without it
// everything is at rest. Reads no file outside of the file's folder. Throws Error if the file is malformed
// or refers to what is not there; what was repaired, approximated or left out goes to `warn`, which may be
// empty, as one counted warning for each kind.
scene::Scene ReadGltf(const std::filesystem::path& path, std::optional<double> time,
                      const WarningSink& warn);

}  // namespace snell::io
