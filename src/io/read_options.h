// SPDX-License-Identifier: Apache-2.0
//
// How to read a file, whatever its format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/read_limits.h"

namespace snell::io {

// What files that include each other share while they are read.
struct Inclusion {
  std::vector<std::string> open;  // real names of the files that are being read, outermost first
  std::uint64_t bytes = 0;        // of native scenes, so far
  std::uint64_t files = 0;        // that were included
  std::uint64_t things = 0;       // objects and lights that these hold
};

struct ReadOptions {
  // For bare meshes: whether the file's z axis points up, to be turned to y. Without a word it does in STL,
  // which is the language of 3D printing, and does not in others.
  std::optional<bool> zUp = {};
  // Crease angle in degrees for bare meshes without normals; 0: flat. Without a word, an OBJ file's smoothing
  // groups count first.
  std::optional<float> smooth = {};
  bool ignoreNormals = false;  // of OBJ files

  // Of glTF files
  std::optional<double> time = {};  // seconds, of animations; without it everything is at rest
  double duration = 0;              // seconds from then on, in which what is animated moves
  std::string scene = {};           // by name; empty: the file's default
  std::string variant = {};         // of the materials; empty: the default ones

  // A map (kernel/environment.h) that replaces what surrounds the scene; the caller vouches for its place
  std::filesystem::path environment = {};

  ReadLimits limits = {};
  // Folders that files may be read from besides the file's own.
  std::vector<std::filesystem::path> folders = {};
  std::shared_ptr<Inclusion> inclusion = {};  // null: the file is opened by itself
};

// The folders that a file may read others from, its own first.
inline std::vector<std::filesystem::path> FoldersOf(const std::filesystem::path& file,
                                                    const ReadOptions& options) {
  std::vector<std::filesystem::path> folders = {file.parent_path()};
  folders.insert(folders.end(), options.folders.begin(), options.folders.end());
  return folders;
}

}  // namespace snell::io
