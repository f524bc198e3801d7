// SPDX-License-Identifier: Apache-2.0
//
// Which reader a file is for.
#pragma once

#include <filesystem>
#include <string>

namespace snell::io {

enum class Format { Toml, Gltf, Nff, Pbrt, Mesh, Other, Unknown };

// By the file's extension.
Format FormatOf(const std::filesystem::path& path);

// "toml, gltf, glb, nff, pbrt, obj, ply, stl …", for messages.
std::string KnownFormats();

}  // namespace snell::io
