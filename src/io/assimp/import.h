// SPDX-License-Identifier: Apache-2.0
//
// Runs Assimp over a file: only the reader of its format, only its own folder, first in a process of its own.
#pragma once

#include <assimp/Importer.hpp>
#include <filesystem>
#include <memory>

#include "io/read_options.h"

struct aiScene;

namespace snell::io {

struct AssimpImport {
  std::unique_ptr<Assimp::Importer> importer;  // owns the scene
  const aiScene* scene = nullptr;
};

// Triangles with normals and nothing else. Throws Error.
AssimpImport ImportByAssimp(const std::filesystem::path& path, const ReadOptions& options);

}  // namespace snell::io
