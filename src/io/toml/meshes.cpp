// SPDX-License-Identifier: Apache-2.0
#include "io/toml/meshes.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "io/mesh/read_mesh.h"
#include "util/threads.h"

namespace snell::io {

int MeshLibrary::Add(scene::Mesh mesh) {
  Item item;
  item.meshes.push_back(std::move(mesh));
  items_.push_back(std::move(item));
  return int(items_.size()) - 1;
}

int MeshLibrary::Request(const std::filesystem::path& path, std::optional<float> smooth,
                         bool ignoreNormals, const std::vector<MeshShape>& shapes,
                         const Place& place) {
  std::error_code ignored;
  const auto real = std::filesystem::weakly_canonical(path, ignored);
  const auto key = std::tuple(real.string(), smooth.value_or(-1), ignoreNormals, shapes);
  const auto [request, isNew] = requests_.emplace(key, int(items_.size()));
  if (isNew) {
    Item item;
    item.path = path;
    item.smooth = smooth;
    item.ignoreNormals = ignoreNormals;
    item.shapes = shapes;
    item.place = place;
    files_.push_back(int(items_.size()));
    items_.push_back(std::move(item));
  }
  return request->second;
}

void MeshLibrary::LoadFile(Item& item, const ReadLimits& limits) {
  MeshReadOptions options;
  options.limits = limits;
  if (item.smooth) options.smoothDegrees = *item.smooth;
  options.smoothingGroups = !item.smooth;
  options.ignoreFileNormals = item.ignoreNormals;
  options.shapes = item.shapes;
  try {
    item.meshes = ReadMesh(item.path, options,
                           [&](const Diagnostic& warning) { item.warnings.push_back(warning); });
  } catch (const Error& error) {
    // Say where the file is named, and where in the file the mistake is
    for (const Diagnostic& cause : error.diagnostics())
      item.errors.push_back(
          {fmt::format("cannot use the mesh {}: {}", ToString(cause.place), cause.message),
           item.place, cause.hint});
  }
}

std::vector<Diagnostic> MeshLibrary::Load(std::vector<scene::Mesh>& meshes,
                                          const ReadLimits& limits, const WarningSink& warn) {
  ParallelInOrder(files_.size(), [&](std::uint64_t i, int) {
    LoadFile(items_[std::size_t(files_[std::size_t(i)])], limits);
  });

  // Collect in the order of the scene, whatever was ready first
  std::vector<Diagnostic> errors;
  for (Item& item : items_) {
    errors.insert(errors.end(), item.errors.begin(), item.errors.end());
    for (const Diagnostic& warning : item.warnings)
      if (warn) warn(warning);
    item.range = {int(meshes.size()), int(item.meshes.size())};
    meshes.insert(meshes.end(), std::make_move_iterator(item.meshes.begin()),
                  std::make_move_iterator(item.meshes.end()));
    item.meshes.clear();
  }
  return errors;
}

}  // namespace snell::io
