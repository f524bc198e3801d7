// SPDX-License-Identifier: Apache-2.0
#include "image/metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "util/error.h"

namespace snell::image {

// PNG's rule for keywords (PNG 2nd edition, §11.3.4.2) narrowed to ASCII.
static bool IsKey(std::string_view key) {
  if (key.empty() || key.size() > 79 || key.front() == ' ' || key.back() == ' ') return false;
  if (key.find("  ") != key.npos) return false;
  return std::all_of(key.begin(), key.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

// Names of attributes that OpenEXR itself reads, or writes in every file (Technical Introduction to
// OpenEXR, "Predefined Attributes").
static bool IsReserved(std::string_view key) {
  static constexpr std::string_view Names[] = {
      "channels",
      "chromaticities",
      "chunkCount",
      "compression",
      "dataWindow",
      "deepImageState",
      "displayWindow",
      "envmap",
      "lineOrder",
      "maxSamplesPerPixel",
      "multiView",
      "name",
      "pixelAspectRatio",
      "preview",
      "screenWindowCenter",
      "screenWindowWidth",
      "tiles",
      "type",
      "version",
      "view",
  };
  return std::find(std::begin(Names), std::end(Names), key) != std::end(Names);
}

void CheckMetadata(const Metadata& metadata) {
  for (const auto& [key, value] : metadata) {
    if (!IsKey(key))
      throw Error(fmt::format("'{}' cannot be the key of a picture's metadata", key), {},
                  "keys have 1 to 79 printable ASCII characters and no spaces at their ends");
    if (IsReserved(key))
      throw Error(fmt::format("'{}' cannot be the key of a picture's metadata", key), {},
                  "OpenEXR uses this name itself");
    if (value.find('\0') != value.npos)
      throw Error(fmt::format("the metadata entry '{}' contains a zero byte", key));
  }
}

std::string MetadataLine(const std::string& key, const std::string& value) {
  std::string line = key + ": " + value;
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\r', ' ');
  return line;
}

void AddMetadataLine(std::string_view line, Metadata& metadata) {
  const std::size_t colon = line.find(": ");
  if (colon != line.npos && IsKey(line.substr(0, colon)))
    metadata.emplace_back(line.substr(0, colon), line.substr(colon + 2));
  else if (!line.empty())
    metadata.emplace_back("Comment", line);
}

}  // namespace snell::image
