// SPDX-License-Identifier: Apache-2.0
#include "tessellate/tessellate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <tuple>

#include "scene/deformation.h"
#include "tessellate/cage.h"
#include "tessellate/dice.h"
#include "tessellate/displace.h"
#include "tessellate/keys.h"
#include "tessellate/measure.h"
#include "tessellate/subdivide.h"
#include "tessellate/tangents.h"
#include "util/text.h"
#include "util/timer.h"

namespace snell::tessellate {
namespace {

using scene::Affine;
using scene::Displacement;
using scene::Mesh;
using scene::MeshGeometry;
using scene::Object;
using scene::Subdivision;
using scene::SubdivisionScheme;

constexpr int MostLevels = 10;
// What a triangle may take while it is made.
constexpr std::uint64_t BytesPerTriangle = 400;

// What is to be done to a mesh, for all objects that ask for the same.
struct Task {
  scene::MeshIndex mesh = -1;
  Subdivision subdivision;
  Displacement displacement;
  int tangentsOf = -1;  // a set of uvs; -1: no tangents are made
  std::optional<Measure> measure;
  Affine toWorld{1.0};   // of the first object
  bool isAlone = false;  // the texture moves through the world
  std::vector<std::size_t> objects;

  bool IsDisplaced() const { return displacement.texture >= 0 && displacement.scale != 0; }
  bool IsSubdivided() const { return subdivision.scheme != SubdivisionScheme::None; }
  bool NeedsSize() const {
    return IsDisplaced() || (IsSubdivided() && subdivision.target != scene::EdgeTarget());
  }
};

class Tessellator {
 public:
  Tessellator(const scene::Scene& scene, const scene::Camera& camera, const View& view,
              const TextureLookup& lookup, std::uint64_t mostTriangles)
      : scene_(scene),
        camera_(camera),
        view_(view),
        lookup_(lookup),
        trianglesLeft_(mostTriangles) {}

  FinerMeshes Tessellate() {
    CollectTasks();
    for (Task& task : tasks_) Perform(task);
    Warn(coarser_, "mesh", "coarser than asked for, lest the scene get too many triangles");
    Warn(unsubdivided_, "mesh", "left as it is: its faces cannot be subdivided");
    Warn(deforming_, "mesh", "with a displaced material left smooth: its shape changes");
    Warn(shapes_, "shape", "with a displaced material left smooth: only meshes are displaced");
    return std::move(result_);
  }

 private:
  void Warn(std::uint64_t count, const char* noun, const char* what) {
    if (count > 0) result_.warnings.push_back(fmt::format("{} {}", Plural(count, noun), what));
  }

  void CollectTasks() {
    result_.meshOf.assign(scene_.objects.size(), -1);
    std::map<scene::MeshIndex, std::vector<std::size_t>> tasksOf;
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      const Object& object = scene_.objects[i];
      const auto* geometry = std::get_if<MeshGeometry>(&object.geometry);
      Task task = TaskOf(object);
      if (!geometry) {
        if (task.IsDisplaced()) ++shapes_;
        continue;
      }
      result_.meshOf[i] = task.mesh = geometry->mesh;
      const Mesh& mesh = scene_.meshes[std::size_t(task.mesh)];
      task.tangentsOf = TangentsOf(object, mesh, task);
      if (!task.IsDisplaced() && !task.IsSubdivided() && task.tangentsOf < 0 && mesh.keys.empty())
        continue;

      std::vector<std::size_t>& known = tasksOf[task.mesh];
      const auto same =
          std::ranges::find_if(known, [&](std::size_t k) { return IsSame(tasks_[k], task); });
      const std::size_t number = same == known.end() ? tasks_.size() : *same;
      if (number == tasks_.size()) {
        if (task.NeedsSize()) task.measure.emplace(object.toWorld);
        known.push_back(number);
        tasks_.push_back(std::move(task));
      }
      Task& joined = tasks_[number];
      joined.objects.push_back(i);
      if (joined.measure) joined.measure->AddEye(view_, object.toWorld);
    }
  }

  Task TaskOf(const Object& object) const {
    Task task;
    task.subdivision = object.subdivision;
    task.displacement = scene_.materials[std::size_t(object.material)].displacement;
    task.toWorld = object.toWorld;
    if (task.displacement.texture >= 0)
      task.isAlone = scene_.textures[std::size_t(task.displacement.texture)].space ==
                     scene::TextureSpace::World;
    return task;
  }

  // The coordinates by which a normal map needs tangents that the finer mesh will not have.
  int TangentsOf(const Object& object, const Mesh& mesh, const Task& task) const {
    const scene::TextureIndex map =
        scene_.materials[std::size_t(object.material)].normalMap.texture;
    const bool lost = task.IsDisplaced() || task.IsSubdivided();
    if (map < 0 || mesh.uvs.empty() || (!mesh.tangents.empty() && !lost)) return -1;
    return scene_.textures[std::size_t(map)].uvSet;
  }

  static bool IsSame(const Task& a, const Task& b) {
    return !a.isAlone && a.subdivision == b.subdivision && a.displacement == b.displacement &&
           a.tangentsOf == b.tangentsOf && (!a.measure || a.measure->Fits(b.toWorld));
  }

  void Perform(Task& task) {
    Mesh mesh = scene::ShapeDuring(scene_.meshes[std::size_t(task.mesh)], camera_.shutterOpen,
                                   camera_.shutterClose);
    bool isCoarser = false;
    if (task.IsSubdivided()) SubdivideMesh(task, mesh, isCoarser);
    if (task.IsDisplaced()) DisplaceMesh(task, mesh, isCoarser);
    if (task.tangentsOf >= 0 && mesh.tangents.empty()) {
      ChangeAllKeys(mesh, [&](Mesh& still) {
        MakeTangents(still, task.tangentsOf);
        return true;
      });
    }
    if (isCoarser) ++coarser_;
    if (task.IsSubdivided() || task.IsDisplaced()) result_.triangles += mesh.triangles.size();
    trianglesLeft_ -= std::min<std::uint64_t>(trianglesLeft_, mesh.triangles.size());
    for (const std::size_t object : task.objects)
      result_.meshOf[object] = scene::MeshIndex(scene_.meshes.size() + result_.meshes.size());
    result_.meshes.push_back(std::move(mesh));
  }

  void SubdivideMesh(const Task& task, Mesh& mesh, bool& isCoarser) {
    int levels = task.measure && task.subdivision.target != scene::EdgeTarget()
                     ? LevelsFor(mesh, *task.measure, task.subdivision)
                     : task.subdivision.levels;
    const auto count = [&] { return SubdividedTriangles(mesh, task.subdivision, levels); };
    while (levels > 0 && count() > trianglesLeft_) {
      --levels;
      isCoarser = true;
    }
    CheckMemory(count() * (1 + mesh.keys.size()));
    const auto subdivide = [&](Mesh& still) { return Subdivide(still, task.subdivision, levels); };
    if (count() > trianglesLeft_ || !ChangeAllKeys(mesh, subdivide)) ++unsubdivided_;
  }

  // As many halvings as the longest edge of a polygon needs.
  static int LevelsFor(const Mesh& mesh, const Measure& measure, const Subdivision& subdivision) {
    const Cage cage = MakeCage(mesh, subdivision.scheme == SubdivisionScheme::Loop);
    const auto at = [&](std::size_t corner) {
      return cage.positions[std::size_t(cage.places[corner])];
    };
    double most = 1;
    std::size_t first = 0;
    for (const int size : cage.sizes) {
      const std::size_t end = first + std::size_t(size);
      for (std::size_t i = first; i < end; ++i)
        most = std::max(most,
                        measure.Excess(at(i), at(i + 1 < end ? i + 1 : first), subdivision.target));
      first = end;
    }
    return std::clamp(int(std::ceil(std::log2(std::min(most, 1e6)))), 0, MostLevels);
  }

  void DisplaceMesh(const Task& task, Mesh& mesh, bool& isCoarser) {
    if (!mesh.keys.empty()) {
      ++deforming_;
      return;
    }
    CheckMemory(mesh.triangles.size());
    if (!Dice(mesh, *task.measure, task.displacement.target, trianglesLeft_)) isCoarser = true;
    const Displacement& d = task.displacement;
    const int uvSet = scene_.textures[std::size_t(d.texture)].uvSet;
    const Height height = [&](std::size_t i, float width) {
      TexturePoint point;
      point.local = mesh.positions[i];
      point.world = scene::vec3(glm::dvec3(task.toWorld * glm::dvec4(glm::dvec3(point.local), 1)));
      const auto& uvs = uvSet == 1 && !mesh.uvs1.empty() ? mesh.uvs1 : mesh.uvs;
      point.uv = uvs.empty() ? scene::vec2(0.0f) : uvs[i];
      point.width = width;
      return d.scale * (lookup_(d.texture, d.channel, point) - d.middle);
    };
    Displace(mesh, *task.measure, uvSet, height);
  }

  void CheckMemory(std::uint64_t triangles) const {
    const std::uint64_t bytes = triangles * BytesPerTriangle, available = AvailableMemoryBytes();
    if (available > 0 && bytes > available)
      throw Error(fmt::format("the finer meshes need about {} of memory; {} are available",
                              ByteSize(bytes), ByteSize(available)),
                  {scene_.name}, "ask for fewer levels or for longer edges");
  }

  const scene::Scene& scene_;
  const scene::Camera& camera_;
  const View& view_;
  const TextureLookup& lookup_;
  std::uint64_t trianglesLeft_;
  std::vector<Task> tasks_;
  FinerMeshes result_;
  std::uint64_t coarser_ = 0, unsubdivided_ = 0, deforming_ = 0, shapes_ = 0;
};

}  // namespace

FinerMeshes Tessellate(const scene::Scene& scene, const scene::RenderSettings& settings,
                       const scene::Camera& camera, const TextureLookup& lookup,
                       std::uint64_t mostTriangles) {
  const View view(camera, settings.width, settings.height);
  try {
    return Tessellator(scene, camera, view, lookup, mostTriangles).Tessellate();
  } catch (const std::bad_alloc&) {
    throw Error("not enough memory for the finer meshes", {scene.name},
                "ask for fewer levels or for longer edges");
  }
}

}  // namespace snell::tessellate
