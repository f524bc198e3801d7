// SPDX-License-Identifier: Apache-2.0
//
// Pictures from files: PNG, JPEG, WebP, Radiance HDR and OpenEXR, told apart by content, never by name. Any
// bytes yield a picture or one Error; sizes are checked against limits before memory is taken.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"
#include "util/file.h"

namespace snell::image {

enum class ColorSpace {
  // As the file says, where it says so by a PNG gamma or by chromaticities of HDR and EXR; else PNG, JPEG
  // and WebP are sRGB, HDR and EXR linear Rec.709. ICC profiles are not applied.
  FromFile,
  // PNG, JPEG and WebP are sRGB whatever they say, as glTF demands; HDR and EXR as above.
  Srgb,
  // The numbers themselves, integers scaled to [0, 1]: for normals, roughness, heights.
  Raw,
};

struct ReadLimits {
  std::uint64_t pixels = std::uint64_t(1) << 28;
  std::uint64_t fileBytes = DefaultFileLimit;
  std::string pixelHint = {};  // what a message about too many may suggest
};

struct ReadOptions {
  ColorSpace colorSpace = ColorSpace::FromFile;
  ReadLimits limits = {};
};

// The picture in a file, turned the way that its file says is up. EXR pictures fill the display window;
// they have premultiplied alpha and may hold values that are not finite. If `metadata` is not null, it
// receives the file's text entries. Throws Error with the file and, where known, the byte.
Image ReadImage(const std::filesystem::path& path, const ReadOptions& options = {},
                Metadata* metadata = nullptr);

// The same for bytes in memory; `name` is for messages.
Image DecodeImage(std::string_view bytes, const std::string& name, const ReadOptions& options = {},
                  Metadata* metadata = nullptr);

// What an EXR holds, of its first part.
struct ExrSummary {
  int width = 0;
  int height = 0;
  std::vector<std::pair<std::string, std::string>>
      channels;  // names and types: "half", "float", "uint"
};

// Reads the header alone. Throws Error.
ExrSummary SummarizeExr(const std::filesystem::path& path);

}  // namespace snell::image
