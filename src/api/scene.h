// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: opening scenes. Installed as <snell/api/scene.h>.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../util/error.h"

namespace snell {

namespace scene {
struct Scene;
}

// What a file may demand before it is refused, and how much that is without a word.
struct LoadLimit {
  std::string name;  // "file-bytes"
  std::string text;  // one line
  std::uint64_t value = 0;
};
SNELL_EXPORT std::vector<LoadLimit> KnownLoadLimits();

// How to open a file.
struct LoadOptions {
  WarningSink warn = {};  // receives what was repaired or is doubtful
  // bare meshes: whether the file's z axis points up; if not set, it does in STL alone
  std::optional<bool> zUp = {};
  std::optional<float> smooth =
      {};  // bare meshes without normals: crease angle in degrees; 0 = flat
  std::optional<double> time =
      {};  // seconds, of a glTF file's animations; without it everything is at rest
  // A picture of all directions, equirectangular: stands for the scene's environment and for the studio
  std::filesystem::path environment = {};
  // Folders that files may be read from besides the scene's own
  std::vector<std::filesystem::path> folders = {};
  std::map<std::string, std::uint64_t> limits = {};  // other values of known limits
};

// An opened scene, ready to render. Copies share the same contents, which do not change.
class SNELL_EXPORT Scene {
 public:
  explicit Scene(std::shared_ptr<const scene::Scene> contents) : contents_(std::move(contents)) {}
  const scene::Scene& contents() const { return *contents_; }

  // Of the pictures that the scene asks for: what PictureOptions wants.
  float exposure() const;
  std::string view() const;
  // The names of its cameras, those that have one.
  std::vector<std::string> cameras() const;

 private:
  std::shared_ptr<const scene::Scene> contents_;
};

// Open a scene (.toml, .gltf, .glb, .nff, .pbrt, …) or a mesh (.obj, .ply, .stl). A bare mesh is set into a small studio; a
// scene without a camera gets one that shows everything. Throws Error with every mistake that was found.
SNELL_EXPORT Scene LoadScene(const std::filesystem::path& path, const LoadOptions& options = {});

// "toml, gltf, glb, nff, pbrt, obj, ply, stl …", for messages.
SNELL_EXPORT std::string KnownSceneExtensions();
// Whether the file's extension is one of these.
SNELL_EXPORT bool HasSceneExtension(const std::filesystem::path& path);

// What is in a scene.
struct SceneInfo {
  struct Item {
    std::string name;    // may be empty
    std::string kind;    // "point light", "sphere", …
    std::string detail;  // one line of figures; may be empty
  };
  std::string name;
  int width = 0;
  int height = 0;
  int spp = 0;
  std::string integrator;
  std::vector<Item> cameras;
  std::vector<Item> lights;
  std::vector<Item> materials;
  std::vector<Item> textures;
  std::vector<Item> meshes;
  std::vector<std::pair<std::string, std::uint64_t>> objectsByKind;
  std::uint64_t objects = 0;
  std::uint64_t meshTriangles = 0;       // stored
  std::uint64_t instancedTriangles = 0;  // seen, instances counted
  std::uint64_t finerTriangles = 0;  // made by subdivision and displacement for the first camera
  bool bounded = false;              // whether the box below holds anything
  std::array<double, 3> lower{};
  std::array<double, 3> upper{};
  // Once prepared for rendering
  std::uint64_t sceneBytes = 0;    // without textures
  std::uint64_t textureBytes = 0;  // with their pictures
  std::uint64_t bvhBytes = 0;
  double buildSeconds = 0;
  std::vector<std::string> warnings;  // of what preparing it for rendering met
};

// Builds the BVH to measure it.
SNELL_EXPORT SceneInfo Inspect(const Scene& scene);

// The reference page of native scene files (Markdown) and their JSON Schema, made from the table that the
// reader uses.
SNELL_EXPORT std::string SceneReference();
SNELL_EXPORT std::string SceneSchema();

}  // namespace snell
