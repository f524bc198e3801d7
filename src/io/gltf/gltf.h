// SPDX-License-Identifier: Apache-2.0
//
// glTF 2.0 files (.gltf, .glb) as scenes. docs/gltf.md says what is read, approximated and left out. The
// parts: document.h opens the file, data.h reads its numbers, nodes.h places the nodes,
// meshes.h, materials.h and places.h make what stands in the scene.
#pragma once

#include <filesystem>

#include "io/contents.h"

namespace snell::io {

// Light of 555 nm; the photometric units of glTF are divided by it.
inline constexpr float LumensPerWatt = 683;

// The file's cameras, lights and objects, no others. Reads no file outside of the file's folder and those that
// the options add. Throws Error if the file is malformed, lacks the scene or the variant that is asked for,
// or refers to what is not there; what was repaired, approximated or left out goes to `warn`, which may be
// empty, as one counted warning for each kind.
Contents ReadGltf(const std::filesystem::path& path, const ReadOptions& options,
                  const WarningSink& warn);

}  // namespace snell::io
