// SPDX-License-Identifier: Apache-2.0
#include "io/contents.h"

#include <fmt/format.h>

#include <utility>

#include "io/assimp/assimp.h"
#include "io/format.h"
#include "io/gltf/gltf.h"
#include "io/mesh/read_mesh.h"
#include "io/nff/nff.h"
#include "io/obj/scene.h"
#include "io/pbrt/pbrt.h"
#include "io/toml/scene.h"
#include "util/file.h"

namespace snell::io {

static scene::Scene ReadMeshFile(const std::filesystem::path& path, const ReadOptions& options,
                                 const WarningSink& warn) {
  MeshReadOptions meshOptions;
  if (options.smooth) meshOptions.smoothDegrees = *options.smooth;
  meshOptions.smoothingGroups = !options.smooth;
  meshOptions.ignoreFileNormals = options.ignoreNormals;
  meshOptions.folders = options.folders;
  meshOptions.limits = options.limits;
  if (LowerExtension(path) == "obj") return ReadObjScene(path, meshOptions, warn);

  scene::Scene scene;
  scene.meshes = ReadMesh(path, meshOptions, warn);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    scene::Object object;
    object.name = scene.meshes[i].name;
    object.geometry = scene::MeshGeometry{int(i)};
    object.place.file = path.string();
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

// No reader is known for the file; if there is none, that is said first.
[[noreturn]] static void Refuse(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) ReadFile(path);
  if (path.string().ends_with(".pbrt.gz"))
    throw Error("compressed scenes are not read", {path.string()}, "unpack it with gunzip");
  throw Error("the file's kind is not known by its extension", {path.string()},
              fmt::format("Snell opens {}", KnownFormats()));
}

Contents ReadContents(const std::filesystem::path& path, const ReadOptions& options,
                      const WarningSink& warn) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw Error("this is a folder, not a file", {path.string()});
  switch (FormatOf(path)) {
    case Format::Toml: return ReadToml(path, options, warn);
    case Format::Gltf: return ReadGltf(path, options, warn);
    case Format::Nff: return {ReadNff(path, warn, options.limits)};
    case Format::Pbrt: return {ReadPbrt(path, options, warn)};
    case Format::Mesh: return {ReadMeshFile(path, options, warn)};
    case Format::Other: return ReadAssimp(path, options, warn);
    case Format::Unknown: break;
  }
  Refuse(path);
}

}  // namespace snell::io
