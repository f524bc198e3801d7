// SPDX-License-Identifier: Apache-2.0
//
// The three mesh readers, behind read_mesh.h: bytes of a file in, polygons as the file gives them out.
// Every reader checks what a header promises against the bytes that are there before it takes memory, and
// reports faults with their line (text) or byte offset (binary).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/mesh/faces.h"
#include "io/mesh/read_mesh.h"
#include "util/error.h"

namespace snell::io {

// A mesh file that has been read into memory, and where its warnings go.
struct MeshFile {
  std::string name;  // for messages
  std::string bytes;
  const MeshReadOptions& options;
  const WarningSink& warn;

  // The place of a line, counting from 1; 0 for the file as a whole.
  Place AtLine(int line) const { return {.file = name, .line = line}; }
  // The place of a byte, counting from 0.
  Place AtByte(std::size_t offset) const { return {.file = name, .offset = std::int64_t(offset)}; }
  void Warn(std::string message, Place place) const {
    if (warn) warn({std::move(message), std::move(place)});
  }
};

// Each throws Error if the file is malformed or holds no faces. ReadObj changes the bytes.
FaceSet ReadObj(MeshFile& file);
FaceSet ReadPly(const MeshFile& file);
FaceSet ReadStl(const MeshFile& file);

// Whether the contents look like the format, whatever the file's name says.
bool LooksLikeObj(std::string_view bytes);
bool LooksLikePly(std::string_view bytes);
bool LooksLikeStl(std::string_view bytes);

}  // namespace snell::io
