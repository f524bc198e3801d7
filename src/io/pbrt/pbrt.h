// SPDX-License-Identifier: Apache-2.0
//
// Reads the scenes of pbrt-v4 (Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th ed., 2023, and its
// description of the file format). docs/pbrt.md tells what becomes of each statement.
#pragma once

#include <filesystem>

#include "io/read_options.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

// Throws Error with the place of the first mistake. What is approximated or left out goes to `warn`, which may be
// empty, as one counted warning for each kind. Other files are read from the folders that the options allow only.
scene::Scene ReadPbrt(const std::filesystem::path& path, const ReadOptions& options,
                      const WarningSink& warn);

}  // namespace snell::io
