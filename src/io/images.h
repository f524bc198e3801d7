// SPDX-License-Identifier: Apache-2.0
//
// Pictures for textures, from files that an asset names: each is read once for each use, however many
// materials show it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "io/find_file.h"
#include "io/read_limits.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

// Whether a picture's numbers are colours for the eye or measures such as roughness.
enum class ImageUse { Color, Data };

// The texels of a decoded file. Pictures of 8 bits stay bytes; others become floats. Numbers that are not
// finite become 0, and so do negative ones of colours. Throws Error with `name` as the file.
scene::Image DecodeTexels(std::string_view bytes, const std::string& name, ImageUse use,
                          const ReadLimits& limits = {});

class ImageLoader {
 public:
  // Reads files in these folders and in folders within them only; the first is the asset's own.
  ImageLoader(std::vector<std::filesystem::path> roots, WarningSink warn, ReadLimits limits = {});

  // A picture that an asset brings itself under this name; the bytes must live as long as they are asked for.
  void Provide(const std::string& name, std::string_view bytes) { provided_[name] = bytes; }

  // The picture that `name`, as written in a file in `folder` (or in one of the roots), refers to: its index in
  // scene.images, of which this loader's must not be removed. -1 after a warning if the file is missing or
  // cannot be read; the warning comes once for each file.
  scene::ImageIndex Load(scene::Scene& scene, std::string_view name, ImageUse use,
                         const Place& place, const std::filesystem::path& folder = {});

 private:
  scene::ImageIndex LoadFirst(scene::Scene& scene, const std::filesystem::path& folder,
                              std::string_view name, ImageUse use, const Place& place);
  void Warn(std::string message, const Place& place, std::string hint = {});

  FileFinder finder_;
  WarningSink warn_;
  ReadLimits limits_;
  int warnings_ = 0;
  std::uint64_t texels_ = 0;
  std::map<std::tuple<std::string, std::string, ImageUse>, scene::ImageIndex> named_;  // by folder
  std::map<std::pair<std::string, ImageUse>, scene::ImageIndex> loaded_;               // by path
  std::map<std::string, std::string_view, std::less<>> provided_;
  std::set<std::string> missing_;  // names
};

}  // namespace snell::io
