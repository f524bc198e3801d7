// SPDX-License-Identifier: Apache-2.0
//
// A glTF 2.0 document (Khronos 2021, ISO/IEC 12113) as its file gives it: .gltf with buffers beside it or
// in data URIs, or .glb. The JSON is checked and relieved of all that refers to bytes before tinygltf reads
// the rest; buffers and pictures are loaded here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/findings.h"
#include "io/gltf/model.h"
#include "io/read_options.h"
#include "util/error.h"

namespace snell::io {

// Where a picture's bytes are; nothing is known yet of what they hold.
struct GltfImage {
  std::string name;
  std::string uri;  // or
  int bufferView = -1;
};

struct GltfDocument {
  // Under this name a primitive's indices stand among its attributes.
  static constexpr const char* Indices = "indices";

  std::filesystem::path path;
  ReadLimits limits;
  std::vector<std::filesystem::path> folders;  // that files may be read from, its own first
  tinygltf::Model model;  // its `buffers` and `images` are empty, strides of views are 0
  std::vector<std::string> buffers;
  std::vector<std::size_t> strides;  // of each buffer view; 0: packed
  std::vector<GltfImage> images;
  mutable GltfFindings findings;

  // An Error about a part of the file, as in "mesh 3".
  Error Fault(std::string_view part, std::string_view message, std::string hint = {}) const;
};

// Throws Error if the file is no glTF 2.0 document, lacks a buffer or requires what Snell cannot do.
GltfDocument OpenGltf(const std::filesystem::path& path, const ReadOptions& options);

// The JSON and the binary chunk of a .glb file, or the text and nothing of a .gltf file.
struct GltfContainer {
  std::string_view json = {};
  std::string_view binary = {};
  bool hasBinary = false;
};
GltfContainer SplitGltf(std::string_view bytes, const std::string& file);

// Throws Error if an extension is required that Snell does not know; warns of others once each.
void CheckGltfExtensions(const GltfDocument& document);

}  // namespace snell::io
