// SPDX-License-Identifier: Apache-2.0
//
// Any file that Snell opens becomes a scene: native scenes, NFF and pbrt as they are; bare meshes, and glTF without
// lights, set into a studio (scene/framing.h).
#pragma once

#include <filesystem>
#include <optional>

#include "scene/scene.h"

namespace snell::io {

struct ReadOptions {
  // For bare meshes: whether the file's z axis points up, to be turned to y. Without a word it does in STL,
  // which is the language of 3D printing, and does not in others.
  std::optional<bool> zUp;
  // Crease angle in degrees for bare meshes without normals; 0: flat. Without a word, an OBJ file's smoothing
  // groups count first.
  std::optional<float> smooth;
  std::optional<double> time =
      {};  // seconds, of glTF's animations; without it everything is at rest
};

// Throws Error with every mistake found. The result is valid (scene/validate.h).
scene::Scene ReadScene(const std::filesystem::path& path, const ReadOptions& options,
                       const WarningSink& warn);

}  // namespace snell::io
