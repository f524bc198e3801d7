// SPDX-License-Identifier: Apache-2.0
#include "io/read_scene.h"

#include <fmt/format.h>

#include <cmath>

#include "io/format.h"
#include "io/gltf/gltf.h"
#include "io/mesh/read_mesh.h"
#include "io/nff/nff.h"
#include "io/obj/scene.h"
#include "io/toml/scene.h"
#include "scene/framing.h"
#include "scene/validate.h"
#include "util/file.h"

namespace snell::io {

// A turn by −90° about x: z up becomes y up.
static scene::Affine ZUpToYUp() {
  return {glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
          glm::dvec4(0, 0, 0, 1)};
}

// The objects of a mesh file.
static scene::Scene ReadObjects(const std::filesystem::path& path, const ReadOptions& options,
                                const WarningSink& warn) {
  MeshReadOptions meshOptions;
  if (options.smooth) meshOptions.smoothDegrees = *options.smooth;
  meshOptions.smoothingGroups = !options.smooth;
  if (LowerExtension(path) == "obj") return ReadObjScene(path, meshOptions, warn);

  scene::Scene scene;
  scene.meshes = ReadMesh(path, meshOptions, warn);
  const bool colored = !scene.meshes.front().colors.empty();
  scene.materials.push_back(colored ? scene::ColoredMaterial() : scene::DefaultMaterial());
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    scene::Object object;
    object.name = scene.meshes[i].name;
    object.geometry = scene::MeshGeometry{int(i)};
    object.material = 0;
    object.place.file = path.string();
    scene.objects.push_back(object);
  }
  return scene;
}

static scene::Scene ReadBareMesh(const std::filesystem::path& path, const ReadOptions& options,
                                 const WarningSink& warn) {
  scene::Scene scene = ReadObjects(path, options, warn);
  if (options.zUp.value_or(LowerExtension(path) == "stl"))
    for (scene::Object& object : scene.objects) object.toWorld = ZUpToYUp();
  scene::AddStudio(scene);
  return scene;
}

static constexpr float LumensPerWatt = 683;

static scene::Scene ReadGltfScene(const std::filesystem::path& path, const ReadOptions& options,
                                  const WarningSink& warn) {
  scene::Scene scene = ReadGltf(path, options.time, warn);
  if (scene.lights.empty()) {
    if (!scene.objects.empty()) scene::AddStudio(scene);
    return scene;
  }
  // Expose for the file's lights, which are in lumens: a matt white surface under π lux comes out white. What
  // glows is in nits then, too
  scene.settings.exposure = std::log2(LumensPerWatt);
  for (scene::Material& material : scene.materials) {
    if (material.physical) material.physical->emission.value /= LumensPerWatt;
  }
  return scene;
}

// No reader is known for the file; if there is none, that is said first.
[[noreturn]] static void Refuse(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) ReadFile(path);
  throw Error("the file's kind is not known by its extension", {path.string()},
              fmt::format("Snell opens {}", KnownFormats()));
}

scene::Scene ReadScene(const std::filesystem::path& path, const ReadOptions& options,
                       const WarningSink& warn) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw Error("this is a folder, not a file", {path.string()});
  scene::Scene scene;
  if (options.time && warn && FormatOf(path) != Format::Gltf)
    warn({"the time is for animations, which only glTF files have", {path.string()}});
  switch (FormatOf(path)) {
    case Format::Toml: scene = ReadToml(path, warn); break;
    case Format::Gltf: scene = ReadGltfScene(path, options, warn); break;
    case Format::Nff: scene = ReadNff(path, warn); break;
    case Format::Mesh: scene = ReadBareMesh(path, options, warn); break;
    case Format::Unknown: Refuse(path);
  }
  scene.name = path.string();
  scene::Validate(scene, warn);
  return scene;
}

}  // namespace snell::io
