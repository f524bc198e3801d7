// SPDX-License-Identifier: Apache-2.0
//
// Any file that Snell opens becomes a scene: native scenes, NFF and pbrt as they are; bare meshes, and others without
// lights, set into a studio (scene/framing.h).
#pragma once

#include <filesystem>

#include "io/read_options.h"
#include "scene/scene.h"

namespace snell::io {

// Throws Error with every mistake found. The result is valid (scene/validate.h).
scene::Scene ReadScene(const std::filesystem::path& path, const ReadOptions& options,
                       const WarningSink& warn);

}  // namespace snell::io
