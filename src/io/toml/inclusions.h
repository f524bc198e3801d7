// SPDX-License-Identifier: Apache-2.0
//
// The scenes that objects of a scene file take in: files with materials, lights and cameras of their own. Like
// meshes (meshes.h) they are only noted while the text is read; one that is named several times with the same
// options is read once, and all that show it share its meshes and pictures.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "io/contents.h"

namespace snell::io {

class Reader;

// Scenes may take in scenes this deep.
inline constexpr std::size_t MaxInclusionDepth = 16;

class InclusionLibrary {
 public:
  // A file to read; `place` is where it is named first. Returns its number in the library.
  int Request(const std::filesystem::path& path, const ReadOptions& options, const Place& place);

  // Read all files. What they refer to goes to the reader's scene; what went wrong is reported to the reader.
  void Load(Reader& reader, const WarningSink& warn);

  // After Load: a file's cameras, lights and objects, with indices of the reader's scene.
  const scene::Scene& operator[](int number) const {
    return items_[std::size_t(number)].contents.scene;
  }
  const std::filesystem::path& PathOf(int number) const { return items_[std::size_t(number)].path; }

  // The materials that a file brings, by name and as indices of the reader's scene.
  using Materials = std::vector<std::pair<std::string, scene::MaterialIndex>>;
  const Materials& MaterialsOf(int number) const { return items_[std::size_t(number)].materials; }

 private:
  struct Item {
    std::filesystem::path path;
    ReadOptions options;
    Place place;
    Contents contents;
    Materials materials;
  };

  static bool MayRead(Reader& reader, const Item& item, const std::string& real);
  static void Read(Reader& reader, Item& item, const WarningSink& warn);

  std::vector<Item> items_;
  std::map<std::tuple<std::string, float, bool, double, double, std::string, std::string>, int>
      requests_;
};

}  // namespace snell::io
