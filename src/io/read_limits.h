// SPDX-License-Identifier: Apache-2.0
//
// What a file may demand before Snell takes it for a mistake or an attack. All of it can be lifted; what keeps
// the stack from overflowing, such as the depth of nesting, cannot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "image/read.h"
#include "util/file.h"

namespace snell::io {

struct ReadLimits {
  std::uint64_t fileBytes = DefaultFileLimit;          // of each file
  std::uint64_t tomlBytes = std::uint64_t(128) << 20;  // of native scenes, with all they include
  std::uint64_t jsonBytes = std::uint64_t(64) << 20;   // of a glTF file, without data
  std::uint64_t mtlBytes = std::uint64_t(256) << 20;   // of a material library
  std::uint64_t triangles = std::uint64_t(1) << 30;    // of a file
  std::uint64_t numbers = std::uint64_t(1) << 33;      // that a glTF file's accessors hold
  std::uint64_t objects = 10'000'000;                  // and lights, placed
  std::uint64_t materials = 65'536;                    // of an OBJ file
  std::uint64_t pictures = 65'536;                     // of an OBJ file
  std::uint64_t picturePixels = image::ReadLimits().pixels;  // of one picture
  std::uint64_t pixels = std::uint64_t(1) << 30;             // of all pictures of a file
  std::uint64_t includes = 10'000;                           // of scenes by objects, in all

  bool operator==(const ReadLimits&) const = default;
};

using Limit = std::uint64_t ReadLimits::*;

struct LimitName {
  const char* name;  // "file-bytes"
  Limit limit;
  const char* text;  // what it limits
};
const std::vector<LimitName>& LimitNames();

// "--limit triangles=N raises the limit", for hints.
std::string LiftedBy(Limit limit);

// A whole file of at most as many bytes as the limit allows.
std::string ReadWithin(const std::filesystem::path& path, const ReadLimits& limits,
                       Limit limit = &ReadLimits::fileBytes, std::uint64_t used = 0);

}  // namespace snell::io
