// SPDX-License-Identifier: Apache-2.0
#include "io/toml/place_included.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <utility>

#include "scene/framing.h"
#include "scene/motion.h"

namespace snell::io {

namespace {

// The material of meshes with colours that bring none.
scene::MaterialIndex ColoredMaterial(Reader& reader) {
  const auto [entry, isNew] =
      reader.materials.emplace("(vertex colors)", int(reader.scene.materials.size()));
  if (isNew) reader.scene.materials.push_back(scene::ColoredMaterial());
  return entry->second;
}

scene::MaterialIndex MaterialOf(Reader& reader, const Member& member, const Surroundings& around,
                                const scene::Object& object) {
  const auto& replaced = member.included->replaced;
  if (const auto found = replaced.find(object.material); found != replaced.end())
    return found->second;
  if (member.object.material >= 0) return member.object.material;
  if (object.material >= 0) return object.material;
  if (around.material >= 0) return around.material;
  const auto* mesh = std::get_if<scene::MeshGeometry>(&object.geometry);
  const bool colored = mesh && !reader.scene.meshes[std::size_t(mesh->mesh)].colors.empty();
  return colored ? ColoredMaterial(reader) : DefaultMaterial(reader);
}

scene::Camera Placed(scene::Camera camera, const Affine& toWorld) {
  const auto point = [&](vec3 p) { return vec3(toWorld * glm::dvec4(glm::dvec3(p), 1.0)); };
  const glm::dvec3 up = glm::dmat3(toWorld) * glm::normalize(glm::dvec3(camera.up));
  const glm::dvec3 ahead =
      glm::dmat3(toWorld) * glm::normalize(glm::dvec3(camera.lookAt) - glm::dvec3(camera.position));
  for (scene::MotionKey& key : camera.motion) key.place = toWorld * key.place;
  camera.position = point(camera.position);
  camera.lookAt = point(camera.lookAt);
  camera.up = vec3(glm::normalize(up));
  camera.height = float(double(camera.height) * glm::length(up));
  camera.lens.radius = float(double(camera.lens.radius) * glm::length(up));
  camera.lens.focusDistance = float(double(camera.lens.focusDistance) * glm::length(ahead));
  return camera;
}

}  // namespace

scene::Motion MotionWithin(const Surroundings& around, const scene::Object& object) {
  return scene::Compose(around.toWorld, around.motion, object.toWorld, object.motion);
}

std::string JoinNames(const std::string& outer, const std::string& inner) {
  return outer.empty() || inner.empty() ? outer + inner : outer + "/" + inner;
}

void PlaceIncluded(Reader& reader, const Member& member, const Surroundings& around) {
  const IncludedFile& file = *member.included;
  const scene::Scene& contents = reader.inclusions[file.number];
  for (const scene::Object& object : contents.objects) {
    scene::Object placed = object;
    placed.toWorld = around.toWorld * object.toWorld;
    placed.motion = MotionWithin(around, object);
    placed.name = JoinNames(around.name, object.name);
    placed.material = MaterialOf(reader, member, around, object);
    placed.visibleToCamera = placed.visibleToCamera && around.visibleToCamera;
    placed.visibleToSecondary = placed.visibleToSecondary && around.visibleToSecondary;
    const bool isMesh = std::holds_alternative<scene::MeshGeometry>(placed.geometry);
    if (isMesh && member.object.subdivision.scheme != scene::SubdivisionScheme::None)
      placed.subdivision = member.object.subdivision;
    placed.castsShadow = placed.castsShadow && around.castsShadow;
    if (std::string reason; !IsUsable(placed.toWorld, reason)) {
      reader.Report(fmt::format("the transform of {} in the file cannot be used here: {}",
                                QuotedName(object.name), reason),
                    member.object.place);
      return;
    }
    reader.scene.objects.push_back(std::move(placed));
  }

  for (const scene::Light& light : contents.lights) {
    if (!file.lights) break;
    LightDraft draft;
    draft.light = light;
    draft.light.strength *= file.lightScale;
    scene::Light placed;
    if (!PlaceLight(reader, draft, around.toWorld, member.object.place, placed)) return;
    placed.name = JoinNames(around.name, placed.name);
    reader.scene.lights.push_back(std::move(placed));
  }

  for (const scene::Camera& camera : contents.cameras) {
    if (!file.cameras) break;
    reader.scene.cameras.push_back(Placed(camera, around.toWorld));
    reader.scene.cameras.back().name = JoinNames(around.name, camera.name);
  }
}

}  // namespace snell::io
