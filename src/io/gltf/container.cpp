// SPDX-License-Identifier: Apache-2.0
//
// The chunks of a .glb file (glTF 2.0, section 4).
#include <fmt/format.h>

#include <cstring>

#include "io/gltf/document.h"

namespace snell::io {

static constexpr std::uint32_t JsonChunk = 0x4e4f534a;
static constexpr std::uint32_t BinaryChunk = 0x004e4942;

// Of little-endian bytes that are there.
static std::uint32_t Word(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return std::uint32_t(std::uint8_t(bytes[at + i])); };
  return byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
}

GltfContainer SplitGltf(std::string_view bytes, const std::string& file) {
  const auto fault = [&](std::string message, std::size_t offset) {
    return Error(std::move(message), {.file = file, .offset = std::int64_t(offset)});
  };
  if (!bytes.starts_with("glTF")) {
    constexpr std::string_view Mark = "\xef\xbb\xbf";
    return {.json = bytes.starts_with(Mark) ? bytes.substr(Mark.size()) : bytes};
  }
  if (bytes.size() < 20)
    throw fault("the file ends within the header of its first chunk", bytes.size());
  if (const std::uint32_t version = Word(bytes, 4); version != 2)
    throw fault(fmt::format("this is glTF {}; Snell reads glTF 2.0", version), 4);
  const std::uint64_t length = Word(bytes, 8);
  if (length > bytes.size())
    throw fault(fmt::format("the file has {} bytes, its header promises {}", bytes.size(), length),
                8);
  if (length < 20) throw fault(fmt::format("the header gives the file a length of {}", length), 8);
  bytes = bytes.substr(0, std::size_t(length));

  // The first chunk is JSON, the second binary if there is one; others are to be skipped
  GltfContainer container;
  int chunk = 0;
  for (std::size_t at = 12; at < bytes.size(); ++chunk) {
    if (bytes.size() - at < 8) throw fault("the file ends within the header of a chunk", at);
    const std::size_t size = Word(bytes, at);
    const std::uint32_t type = Word(bytes, at + 4);
    if (size > bytes.size() - at - 8) throw fault("a chunk reaches beyond the end of the file", at);
    const std::string_view body = bytes.substr(at + 8, size);
    if (chunk == 0) {
      if (type != JsonChunk) throw fault("the first chunk is not JSON", at + 4);
      container.json = body;
    } else if (chunk == 1 && type == BinaryChunk) {
      container.binary = body;
      container.hasBinary = true;
    }
    // Chunks are padded to four bytes; some writers leave that out at the end
    at += 8 + std::min(bytes.size() - at - 8, (size + 3) / 4 * 4);
  }
  return container;
}

}  // namespace snell::io
