// SPDX-License-Identifier: Apache-2.0
//
// The meshes that a scene file refers to. Files are only noted while the text is read and loaded when all
// of it is known to be right, side by side; one that is named several times with the same options is
// loaded once and shared.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "io/read_limits.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

class MeshLibrary {
 public:
  // A mesh that is here already. Returns its number in the library.
  int Add(scene::Mesh mesh);

  // A file to load; without `smooth`, an angle in degrees, smoothing groups count first. `place` is where it is
  // named first; `shapes` as in MeshReadOptions. Returns the file's number in the library.
  int Request(const std::filesystem::path& path, std::optional<float> smooth, bool ignoreNormals,
              const std::vector<MeshShape>& shapes, const Place& place);

  // Load all files and move all meshes to `meshes`. Returns what went wrong, at the places of the requests.
  std::vector<Diagnostic> Load(std::vector<scene::Mesh>& meshes, const ReadLimits& limits,
                               const WarningSink& warn);

  // After Load: the meshes of a number, a range of indices.
  struct Range {
    scene::MeshIndex first = 0;
    int count = 0;
  };
  Range MeshesOf(int number) const { return items_[std::size_t(number)].range; }

 private:
  struct Item {
    std::filesystem::path path;
    std::optional<float> smooth;
    bool ignoreNormals = false;
    std::vector<MeshShape> shapes;
    Place place;
    std::vector<scene::Mesh> meshes;
    std::vector<Diagnostic> errors;
    std::vector<Diagnostic> warnings;
    Range range;
  };

  static void LoadFile(Item& item, const ReadLimits& limits);

  std::vector<Item> items_;
  std::vector<int> files_;  // the items that are to be loaded
  std::map<std::tuple<std::string, float, bool, std::vector<MeshShape>>, int> requests_;
};

}  // namespace snell::io
