// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/gltf.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <utility>

#include "io/gltf/materials.h"
#include "io/gltf/meshes.h"
#include "io/gltf/places.h"
#include "util/text.h"

namespace snell::io {
namespace {

class GltfSceneReader {
 public:
  GltfSceneReader(const GltfDocument& document, const ReadOptions& options)
      : document_(document),
        data_(document),
        nodes_(data_, options.duration > 0 ? options.time.value_or(0) : options.time,
               options.scene),
        meshes_(data_, scene_, options.variant),
        materials_(data_, scene_) {
    const double start = options.time.value_or(0);
    moments_.push_back(nodes_.Here(start));
    if (options.duration <= 0 || document.model.animations.empty()) return;
    for (int i = 1; i <= MotionKeys; ++i) {
      const double time = start + options.duration * i / MotionKeys;
      if (time > moments_.back().time) moments_.push_back(nodes_.At(data_, time));
    }
  }

  scene::Scene Read() {
    for (const int node : nodes_.visible()) {
      const std::string part = nodes_.NameOf(node);
      const tinygltf::Node& record = document_.model.nodes[std::size_t(node)];
      AddObjects(node, part);
      if (record.camera >= 0) AddCamera(node, part);
      if (auto light = ReadGltfLight(document_, node, nodes_.World(node), part)) {
        if (light->name.empty()) light->name = record.name;
        scene_.lights.push_back(std::move(*light));
      }
    }
    return std::move(scene_);
  }

 private:
  void AddCamera(int node, const std::string& part) {
    const tinygltf::Node& record = document_.model.nodes[std::size_t(node)];
    auto camera = ReadGltfCamera(document_, record.camera, nodes_.World(node), part);
    if (!camera) return;
    if (camera->name.empty()) camera->name = record.name;
    if (moments_.size() > 1) {
      camera->motion = MotionOf(node, glm::dmat4(1.0), part);
      camera->shutterOpen = moments_.front().time;
      camera->shutterClose = moments_.back().time;
    }
    scene_.cameras.push_back(std::move(*camera));
  }

  void AddObjects(int node, const std::string& part) {
    bool isSkinned = false;
    const std::vector<GltfMeshes::Part> parts = meshes_.Of(node, nodes_, moments_, isSkinned);
    if (parts.empty()) return;
    for (const glm::dmat4& instance : ReadGltfInstances(data_, node, part)) {
      const glm::dmat4 toWorld = isSkinned ? glm::dmat4(1.0) : nodes_.World(node) * instance;
      if (!IsInvertible(toWorld)) {
        document_.findings.Note("objects whose transform cannot be undone are left out", part);
        continue;
      }
      const scene::Motion motion = isSkinned ? scene::Motion() : MotionOf(node, instance, part);
      for (const GltfMeshes::Part& from : parts) {
        AddObject(from, node, toWorld);
        scene_.objects.back().motion = motion;
      }
    }
  }

  // Empty for a node that stands still.
  scene::Motion MotionOf(int node, const glm::dmat4& local, const std::string& part) {
    scene::Motion motion;
    bool moves = false;
    for (const GltfMoment& moment : moments_) {
      motion.push_back({moment.time, moment.worlds[std::size_t(node)] * local});
      moves = moves || motion.back().place != motion.front().place;
      if (IsInvertible(motion.back().place)) continue;
      document_.findings.Note("motion by a transform that cannot be undone is left out", part);
      return {};
    }
    return moves ? motion : scene::Motion();
  }

  void AddObject(const GltfMeshes::Part& from, int node, const glm::dmat4& toWorld) {
    const std::uint64_t limit = document_.limits.objects;
    if (scene_.objects.size() >= limit)
      throw document_.Fault("", fmt::format("it shows more than {}", Plural(limit, "object")),
                            LiftedBy(&ReadLimits::objects));
    scene::Object object;
    object.name = document_.model.nodes[std::size_t(node)].name;
    if (object.name.empty()) object.name = scene_.meshes[std::size_t(from.mesh)].name;
    object.geometry = scene::MeshGeometry{from.mesh};
    object.material = materials_.Get(from.material);
    object.toWorld = toWorld;
    object.place.file = document_.path.string();
    scene_.objects.push_back(std::move(object));
  }

  // Between these, movement is taken to be even.
  static constexpr int MotionKeys = 16;

  const GltfDocument& document_;
  scene::Scene scene_;
  GltfData data_;
  GltfNodes nodes_;
  GltfMeshes meshes_;
  GltfMaterials materials_;
  std::vector<GltfMoment> moments_;  // one, or those of the motion
};

}  // namespace

Contents ReadGltf(const std::filesystem::path& path, const ReadOptions& options,
                  const WarningSink& warn) {
  try {
    const GltfDocument document = OpenGltf(path, options);
    scene::Scene scene = GltfSceneReader(document, options).Read();
    document.findings.Report(path.string(), warn);
    return {std::move(scene), !document.model.animations.empty()};
  } catch (const std::bad_alloc&) {
    throw Error("not enough memory for the scene", {path.string()});
  } catch (const std::length_error&) {
    throw Error("not enough memory for the scene", {path.string()});
  }
}

}  // namespace snell::io
