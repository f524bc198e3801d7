// SPDX-License-Identifier: Apache-2.0
//
// For the tests of the glTF reader: documents made on the spot, and what reading them gives.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/gltf.h"
#include "io/mesh/test_files.h"

namespace snell::io {

inline std::string Base64(std::string_view bytes) {
  constexpr std::string_view Digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? Digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

// The bytes of numbers as glTF stores them.
template <typename T>
std::string BytesOf(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

constexpr int Byte = 5120, UnsignedByte = 5121, Short = 5122, UnsignedShort = 5123,
              UnsignedInt = 5125, Float = 5126;

// Collects accessors, each with a buffer view of its own, over one buffer.
class GltfBuilder {
 public:
  // `extra` are more members of the view and the accessor, as in R"(, "byteStride": 16)".
  int Add(const std::string& bytes, int componentType, const std::string& type, std::size_t count,
          const std::string& extraOfView = "", const std::string& extra = "") {
    const int view = AddView(bytes, extraOfView);
    return AddAccessor(
        fmt::format(R"("bufferView": {}, "componentType": {}, "type": "{}", "count": {}{})", view,
                    componentType, type, count, extra));
  }
  int AddFloats(const std::vector<float>& numbers, const std::string& type, std::size_t count) {
    return Add(BytesOf(numbers), Float, type, count);
  }
  int AddView(const std::string& bytes, const std::string& extra = "") {
    views_ += fmt::format(R"({}{{"buffer": 0, "byteOffset": {}, "byteLength": {}{}}})",
                          views_.empty() ? "" : ", ", buffer_.size(), bytes.size(), extra);
    buffer_ += bytes;
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    return viewCount_++;
  }
  int AddAccessor(const std::string& members) {
    accessors_ += fmt::format("{}{{{}}}", accessors_.empty() ? "" : ", ", members);
    return accessorCount_++;
  }
  // A triangle in the plane z = 0: (0, 0), (1, 0), (0, 1).
  int AddTriangle() { return AddFloats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3); }

  // The document with these further members.
  std::string Document(const std::string& members) const {
    return fmt::format(
        R"({{"asset": {{"version": "2.0"}},
"buffers": [{{"byteLength": {}, "uri": "data:application/octet-stream;base64,{}"}}],
"bufferViews": [{}], "accessors": [{}], {}}})",
        buffer_.size(), Base64(buffer_), views_, accessors_, members);
  }
  // With one node that shows one mesh of these primitives.
  std::string Mesh(const std::string& primitives, const std::string& members = "") const {
    return Document(fmt::format(R"("nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [{}]}}]{})",
                                primitives, members));
  }
  const std::string& buffer() const { return buffer_; }

 private:
  std::string buffer_, views_, accessors_;
  int viewCount_ = 0, accessorCount_ = 0;
};

struct GltfResult {
  scene::Scene scene;
  std::string warnings;  // a line each, without the file's name
  std::string error;     // without the file's folder

  const scene::Mesh& mesh() const { return scene.meshes.at(0); }
  const scene::OpenPbr& material(std::size_t i = 0) const {
    return *scene.materials.at(i).physical;
  }
};

inline GltfResult ReadGltfFile(const std::filesystem::path& path, std::optional<double> time = {}) {
  GltfResult result;
  const std::string folder = path.parent_path().string() + "/";
  try {
    result.scene = ReadGltf(path, {.time = time}, [&](const Diagnostic& warning) {
                     result.warnings += warning.message + "\n";
                   }).scene;
  } catch (const Error& error) {
    result.error = error.what();
    if (const std::size_t at = result.error.find(folder); at != std::string::npos)
      result.error.erase(at, folder.size());
  }
  return result;
}

inline GltfResult ReadGltfText(std::string_view text, std::optional<double> time = {},
                               const char* name = "a.gltf") {
  const TemporaryFile file(name, text);
  return ReadGltfFile(file.path(), time);
}

// A .glb file of a JSON and a binary chunk, the latter left out if empty.
inline std::string Glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4);
  const auto word = [](std::size_t n) { return BytesOf(std::vector{std::uint32_t(n)}); };
  std::string chunks = word(json.size()) + "JSON" + json;
  if (!binary.empty()) chunks += word(binary.size()) + std::string("BIN\0", 4) + binary;
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

}  // namespace snell::io
