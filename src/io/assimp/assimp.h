// SPDX-License-Identifier: Apache-2.0
//
// The long tail of formats, by the library Assimp: COLLADA, FBX, 3DS, OFF, AC3D and X. docs/other-formats.md
// says what is read, approximated and left out. The parts: import.h runs the library, meshes.h, materials.h
// and places.h turn what it gives into records of the scene.
#pragma once

#include <filesystem>

#include "io/contents.h"

namespace snell::io {

// The file's cameras, lights and objects. Throws Error if the library cannot read the file or does not survive
// it; what was repaired, approximated or left out goes to `warn` as one counted warning for each kind.
Contents ReadAssimp(const std::filesystem::path& path, const ReadOptions& options,
                    const WarningSink& warn);

}  // namespace snell::io
