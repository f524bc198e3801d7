// SPDX-License-Identifier: Apache-2.0
#include "io/obj/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/mesh/readers.h"
#include "io/mesh/vertices.h"
#include "io/obj/materials.h"
#include "io/obj/parts.h"
#include "util/text.h"

namespace snell::io {
namespace {

// Objects that differ in more than their material.
constexpr std::size_t MaxObjects = 1000;
constexpr std::size_t LongestName = 200;

// What becomes one object, by indices of names; without the words that are not kept apart.
struct ObjectKey {
  std::uint32_t object = 0;
  std::uint32_t group = 0;
  scene::MaterialIndex material = -1;
  auto operator<=>(const ObjectKey&) const = default;
};

// Which object each part belongs to.
struct Grouping {
  std::vector<ObjectKey> objects;
  std::vector<std::size_t> objectOf;
};

// Keep apart as many words as the limit allows. A body of glass that is cut into groups stays one: light
// that enters it by one group leaves by another.
Grouping GroupParts(const ObjParts& parts, const std::vector<scene::MaterialIndex>& materialOf,
                    const scene::Scene& scene, const MeshFile& file) {
  for (int words = 2;; --words) {
    Grouping grouping;
    std::map<ObjectKey, std::size_t> known;
    for (std::size_t i = 0; i < parts.parts().size(); ++i) {
      const ObjPart& part = parts.parts()[i];
      const bool glass =
          materialOf[i] >= 0 && scene.materials[std::size_t(materialOf[i])].Refractive();
      ObjectKey key{part.object, part.group, materialOf[i]};
      if (words < 2 || glass) key.group = 0;
      if (words < 1) key.object = 0;
      const auto [entry, isNew] = known.try_emplace(key, grouping.objects.size());
      if (isNew) grouping.objects.push_back(key);
      grouping.objectOf.push_back(entry->second);
    }
    if (words > 0 && grouping.objects.size() > MaxObjects) continue;
    if (words < 2 && grouping.objects.size() < parts.parts().size())
      file.Warn(fmt::format("{} are too many to be kept apart: merged into {}",
                            Plural(parts.parts().size(), "group"),
                            Plural(grouping.objects.size(), "object")),
                file.AtLine(0));
    return grouping;
  }
}

std::string NameOf(const ObjectKey& key, const ObjParts& parts, const std::string& fallback) {
  std::string name = parts.NameOf(key.object).substr(0, LongestName);
  if (key.group != 0) {
    if (!name.empty()) name += '/';
    name += parts.NameOf(key.group).substr(0, LongestName);
  }
  return name.empty() ? fallback : name;
}

// The triangles of each object, in the order of the file.
std::vector<std::vector<std::uint32_t>> SortTriangles(const std::vector<FaceRun>& runs,
                                                      std::size_t triangles,
                                                      const Grouping& grouping) {
  std::vector<std::vector<std::uint32_t>> sorted(grouping.objects.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t end = i + 1 < runs.size() ? runs[i + 1].first : triangles;
    std::vector<std::uint32_t>& object = sorted[grouping.objectOf[runs[i].part]];
    for (std::size_t t = runs[i].first; t < end; ++t) object.push_back(std::uint32_t(t));
  }
  return sorted;
}

void AddObject(scene::Mesh mesh, std::string name, scene::MaterialIndex material,
               const MeshFile& file, scene::Scene& scene) {
  mesh.name = std::move(name);
  scene::Object object;
  object.name = mesh.name;
  object.geometry = scene::MeshGeometry{int(scene.meshes.size())};
  object.material = material;
  object.place.file = file.name;
  scene.meshes.push_back(std::move(mesh));
  scene.objects.push_back(std::move(object));
}

// Areas of a mesh on the surface and in its picture.
struct Areas {
  double surface = 0;
  double picture = 0;
};

void AddAreas(const scene::Mesh& mesh, Areas& areas) {
  for (const scene::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec2 p(mesh.uvs[t.x]), q(mesh.uvs[t.y]), r(mesh.uvs[t.z]);
    const glm::dvec2 u = q - p, v = r - p;
    areas.surface += glm::length(glm::cross(b - a, c - a));
    areas.picture += std::abs(u.x * v.y - u.y * v.x);
  }
}

// Turn heights for pictures one metre long into metres: by the length that a picture has on the surface.
void ScaleHeights(scene::Scene& scene) {
  std::vector<Areas> areas(scene.materials.size());
  for (const scene::Object& object : scene.objects) {
    const scene::Mesh& mesh =
        scene.meshes[std::size_t(std::get<scene::MeshGeometry>(object.geometry).mesh)];
    if (object.material < 0) continue;
    const scene::Material& material = scene.materials[std::size_t(object.material)];
    const bool hasHeights = material.bumpMap.texture >= 0 || material.displacement.texture >= 0;
    if (hasHeights && !mesh.uvs.empty()) AddAreas(mesh, areas[std::size_t(object.material)]);
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const float length = float(std::sqrt(areas[i].surface / areas[i].picture));
    if (!std::isfinite(length)) continue;
    scene.materials[i].bumpMap.scale *= length;
    scene.materials[i].displacement.scale *= length;
  }
}

scene::Scene ReadObjects(const std::filesystem::path& path, const MeshReadOptions& options,
                         const WarningSink& warn) {
  MeshFile file{path.string(), ReadWithin(path, options.limits), options, warn};
  ObjFile obj = ReadObjFile(file);
  file.bytes = std::string();
  std::vector<FaceRun> runs;
  scene::Mesh mesh = BuildMesh(std::move(obj.faces), file, &runs);

  scene::Scene scene;
  const std::vector<scene::MaterialIndex> materialOf = ReadObjMaterials(obj.parts, file, scene);
  const Grouping grouping = GroupParts(obj.parts, materialOf, scene, file);
  const std::string stem = path.stem().string();
  if (grouping.objects.size() == 1) {
    const std::string name = obj.parts.OnlyName();
    AddObject(std::move(mesh), name.empty() ? stem : name, grouping.objects[0].material, file,
              scene);
  } else {
    const auto triangles = SortTriangles(runs, mesh.triangles.size(), grouping);
    TriangleExtractor extractor(mesh);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (triangles[i].empty()) continue;
      const ObjectKey& key = grouping.objects[i];
      AddObject(extractor.Extract(triangles[i]), NameOf(key, obj.parts, stem), key.material, file,
                scene);
    }
  }
  ScaleHeights(scene);
  return scene;
}

}  // namespace

scene::Scene ReadObjScene(const std::filesystem::path& path, const MeshReadOptions& options,
                          const WarningSink& warn) {
  try {
    return ReadObjects(path, options, warn);
  } catch (const std::bad_alloc&) {
    throw Error("not enough memory for the meshes", {path.string()});
  } catch (const std::length_error&) {
    throw Error("not enough memory for the meshes", {path.string()});
  }
}

}  // namespace snell::io
