// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "bvh/bounds.h"
#include "cpu/albedo_tables.h"
#include "cpu/flatten_emitters.h"
#include "cpu/flatten_filter.h"
#include "cpu/flatten_geometry.h"
#include "cpu/flatten_medium.h"
#include "cpu/flatten_shading.h"
#include "cpu/texture_lookup.h"

namespace snell::cpu {

using namespace kernel;

bvh::Geometry FlatScene::Geometry() {
  return {positions, triangles, meshes, shapes, instances, objects, worldTriangles};
}

template <typename T>
static std::uint64_t BytesOf(const std::vector<T>& array) {
  return array.size() * sizeof(T);
}

std::uint64_t FlatScene::TextureBytes() const {
  return BytesOf(textures) + BytesOf(images) + BytesOf(texels);
}

std::uint64_t FlatScene::MemoryBytes() const {
  return BytesOf(objects) + BytesOf(shapes) + BytesOf(instances) + BytesOf(meshes) +
         BytesOf(triangles) + BytesOf(positions) + BytesOf(normals) + BytesOf(uvs) +
         BytesOf(tangents) + BytesOf(colors) + BytesOf(materials) + BytesOf(terms) +
         BytesOf(physicals) + BytesOf(lights) + BytesOf(albedos) + BytesOf(emitters) +
         BytesOf(grids) + TextureBytes();
}

Transform ToTransform(const scene::Affine& m) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(m));
  const auto column = [&](int i) { return vec3(glm::dvec3(m[i])); };
  const auto row = [&](int i) {
    return vec3(glm::dvec3(inverse[0][i], inverse[1][i], inverse[2][i]));
  };
  return {column(0), column(1), column(2), column(3), row(0), row(1), row(2)};
}

static Camera FlattenCamera(const scene::Camera& camera, const scene::RenderSettings& settings) {
  const glm::dvec3 position(camera.position);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.lookAt) - position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double halfHeight = camera.kind == scene::CameraKind::Orthographic
                                ? double(camera.height) / 2
                                : std::tan(double(camera.fov) / 2);
  const double aspect = double(settings.width) / settings.height;
  Camera flat = {};
  flat.kind = camera.kind == scene::CameraKind::Orthographic ? CAMERA_ORTHOGRAPHIC : CAMERA_PINHOLE;
  flat.resolution = {uint(settings.width), uint(settings.height)};
  flat.position = camera.position;
  flat.right = vec3(right);
  flat.up = vec3(up);
  flat.forward = vec3(forward);
  flat.extent = vec2(float(halfHeight * aspect), float(halfHeight));
  return flat;
}

static Environment FlattenEnvironment(const scene::Environment& environment) {
  return {environment.bottom, environment.top, std::sin(environment.bottomElevation),
          std::sin(environment.topElevation), environment.ior};
}

// What a camera ray stands for: a pixel, or less where many samples share it, which the textures' levels of
// detail need not smooth again (pbrt-v4, section 10.1.2).
static void FlattenCone(const scene::RenderSettings& settings, RenderParams& params) {
  const float share = std::max(0.125f, 1 / std::sqrt(float(std::max(settings.spp, 1))));
  const float pixel = 2 * params.camera.extent.y / float(params.camera.resolution.y) * share;
  const bool isPinhole = params.camera.kind == CAMERA_PINHOLE;
  params.coneWidth = isPinhole ? 0 : pixel;
  params.coneSpread = isPinhole ? pixel : 0;
}

// Whether a ray of the camera may start in the box.
static bool MayStartIn(const bvh::Bounds& box, const Camera& camera) {
  bvh::Bounds starts;
  starts.Extend(camera.position);
  if (camera.kind == CAMERA_ORTHOGRAPHIC) {
    const vec3 reach = Abs(camera.right) * camera.extent.x + Abs(camera.up) * camera.extent.y;
    starts = {camera.position - reach * 1.1f, camera.position + reach * 1.1f};
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (starts.upper[axis] < box.lower[axis] || starts.lower[axis] > box.upper[axis]) return false;
  }
  return true;
}

FlatScene Flatten(const scene::Scene& scene, const scene::RenderSettings& settings,
                  const scene::Camera& camera) {
  FlatScene flat;
  flat.params = {};
  flat.params.camera = FlattenCamera(camera, settings);
  flat.params.environment = FlattenEnvironment(scene.environment);
  FlattenFilter(settings.filter, settings.filterRadius, flat.params);
  flat.params.maxDepth = uint(settings.maxDepth);
  flat.params.maxVolumeDepth = uint(settings.maxVolumeDepth);
  flat.params.surroundings = FlattenMedium(scene.environment.medium);
  flat.params.minContribution = settings.minContribution;
  flat.params.seed = settings.seed;
  FlattenCone(settings, flat.params);

  FlattenMaterials(scene, flat);
  FlattenGrids(scene, flat);
  FlattenLights(scene, flat);
  const tessellate::FinerMeshes finer =
      tessellate::Tessellate(scene, settings, camera, LookupIn(flat));
  flat.finerTriangles = finer.triangles;
  flat.warnings = finer.warnings;
  flat.integrator = settings.integrator;
  const bool isPath = settings.integrator == scene::Integrator::Path;
  if (isPath) flat.albedos = AlbedoTables();
  FlattenObjects(scene, finer,
                 isPath                   ? ShadowRays::Path
                 : settings.tintedShadows ? ShadowRays::Tinted
                                          : ShadowRays::Opaque,
                 flat);
  if (isPath) FlattenEmitters(flat);

  // See what the objects ask of the integrator
  for (const Object& object : flat.objects) {
    if ((object.mask & MASK_TINT) != 0) flat.params.tintedShadows = 1;
  }
  for (const Shape& shape : flat.shapes) {
    const bool hasInside = (flat.objects[shape.object].mask & MASK_INSIDE) != 0;
    if (hasInside && MayStartIn(bvh::ShapeBounds(shape), flat.params.camera))
      flat.params.camera.inside = 1;
  }
  const bvh::Geometry geometry = flat.Geometry();
  std::vector<bvh::Bounds> worldMeshes(flat.meshes.size());
  for (uint i = 0; i < flat.worldTriangles; ++i)
    worldMeshes[flat.triangles[i].mesh].Extend(bvh::TriangleBounds(geometry, i));
  for (std::size_t i = 0; i < flat.meshes.size(); ++i) {
    const uint object = flat.meshes[i].object;
    const bool hasInside = object != None && (flat.objects[object].mask & MASK_INSIDE) != 0;
    if (hasInside && MayStartIn(worldMeshes[i], flat.params.camera)) flat.params.camera.inside = 1;
  }
  for (const Instance& instance : flat.instances) {
    if ((flat.objects[instance.object].mask & MASK_INSIDE) == 0) continue;
    bvh::Bounds local;
    for (uint i = 0; i < instance.triangleCount; ++i)
      local.Extend(bvh::TriangleBounds(geometry, instance.firstTriangle + i));
    if (MayStartIn(bvh::TransformedBounds(instance.toWorld, local), flat.params.camera))
      flat.params.camera.inside = 1;
  }
  return flat;
}

}  // namespace snell::cpu
