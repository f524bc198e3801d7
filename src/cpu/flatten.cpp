// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten.h"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bvh/bounds.h"
#include "cpu/albedo_tables.h"
#include "cpu/flatten_camera.h"
#include "cpu/flatten_closure.h"
#include "cpu/flatten_emitters.h"
#include "cpu/flatten_environment.h"
#include "cpu/flatten_filter.h"
#include "cpu/flatten_geometry.h"
#include "cpu/flatten_light_tree.h"
#include "cpu/flatten_medium.h"
#include "cpu/flatten_shading.h"
#include "cpu/texture_lookup.h"
#include "scene/settings.h"

namespace snell::cpu {

using namespace kernel;

bvh::Geometry FlatScene::Geometry() {
  return {positions, triangles, meshes, shapes, instances, objects, worldTriangles, motions};
}

template <typename T>
static std::uint64_t BytesOf(const std::vector<T>& array) {
  return array.size() * sizeof(T);
}

std::uint64_t FlatScene::TextureBytes() const {
  return BytesOf(textures) + BytesOf(images) + BytesOf(texels);
}

std::uint64_t FlatScene::MemoryBytes() const {
  std::uint64_t bytes = 0;
  VisitBuffers([&](const auto& buffer) { bytes += BytesOf(buffer); });
  return bytes;
}

Transform ToTransform(const scene::Affine& m) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(m));
  const auto column = [&](int i) { return vec3(glm::dvec3(m[i])); };
  const auto row = [&](int i) {
    return vec3(glm::dvec3(inverse[0][i], inverse[1][i], inverse[2][i]));
  };
  return {column(0), column(1), column(2), column(3), row(0), row(1), row(2)};
}

// The power of two from the samples per pixel on.
static uint SamplesLog2(int spp) {
  return std::min(uint(std::bit_width(uint(std::max(spp, 1) - 1))), 20u);
}

static uint CausticsTag(scene::Caustics caustics) {
  switch (caustics) {
    case scene::Caustics::Full: return CAUSTICS_FULL;
    case scene::Caustics::Regularized: return CAUSTICS_REGULARIZED;
    case scene::Caustics::None: return CAUSTICS_NONE;
  }
  return CAUSTICS_FULL;
}

// The boxes of all that has an inside.
static std::vector<bvh::Bounds> BodiesOf(FlatScene& flat) {
  const bvh::Geometry geometry = flat.Geometry();
  const auto hasInside = [&](uint object) {
    return object != None && (flat.objects[object].mask & MASK_INSIDE) != 0;
  };
  std::vector<bvh::Bounds> bodies;
  for (const Shape& shape : flat.shapes) {
    if (hasInside(shape.object)) bodies.push_back(bvh::PlacedBounds(geometry, shape));
  }
  std::vector<bvh::Bounds> worldMeshes(flat.meshes.size());
  for (uint i = 0; i < flat.worldTriangles; ++i)
    worldMeshes[flat.triangles[i].mesh].Extend(bvh::TriangleBounds(geometry, i));
  for (std::size_t i = 0; i < flat.meshes.size(); ++i) {
    if (hasInside(flat.meshes[i].object)) bodies.push_back(worldMeshes[i]);
  }
  for (const Instance& instance : flat.instances) {
    if (!hasInside(instance.object)) continue;
    bvh::Bounds local;
    for (uint i = 0; i < instance.triangleCount; ++i)
      local.Extend(bvh::TriangleBounds(geometry, instance.firstTriangle + i));
    bodies.push_back(bvh::PlacedBounds(geometry, instance, {&local, 1}));
  }
  return bodies;
}

FlatScene Flatten(const scene::Scene& scene, const scene::RenderSettings& settings,
                  const scene::Camera& camera) {
  FlatScene flat;
  flat.params = {};
  FlattenCamera(camera, settings, flat);
  FlattenFilter(settings.filter, settings.filterRadius, flat.params);
  flat.params.maxDepth = uint(settings.maxDepth);
  flat.params.maxVolumeDepth = uint(settings.maxVolumeDepth);
  flat.params.maxDiffuseDepth = uint(settings.maxDiffuseDepth);
  flat.params.maxSpecularDepth = uint(settings.maxSpecularDepth);
  flat.params.maxTransmissionDepth = uint(settings.maxTransmissionDepth);
  flat.params.caustics = CausticsTag(settings.caustics);
  flat.params.surroundings = FlattenMedium(scene.environment.medium);
  flat.params.minContribution = settings.minContribution;
  flat.params.clampIndirect = settings.clampIndirect;
  flat.params.seed = settings.seed;
  const std::vector<std::string> lightGroups = scene::LightGroupsOf(scene);
  if (!settings.aovs.Empty() || settings.denoise) flat.params.aovs = uint(lightGroups.size());
  flat.params.independentSamples = settings.sampler == scene::Sampler::Independent ? 1 : 0;
  flat.params.samplesLog2 = SamplesLog2(settings.spp);
  flat.params.lightSampling =
      settings.lightSampling == scene::LightSampling::Power ? LIGHTS_BY_POWER : LIGHTS_BY_TREE;

  flat.integrator = settings.integrator.value_or(scene::Integrator::Whitted);
  FlattenMaterials(scene, flat);
  FlattenGrids(scene, flat);
  FlattenLights(scene, flat);
  const tessellate::FinerMeshes finer =
      tessellate::Tessellate(scene, settings, camera, LookupIn(flat));
  flat.finerTriangles = finer.triangles;
  flat.warnings = finer.warnings;
  const bool isPath = flat.integrator == scene::Integrator::Path;
  if (isPath) {
    flat.albedos = AlbedoTables();
    FlattenClosureTextures(scene, flat);
  }
  FlattenObjects(scene, finer,
                 isPath                   ? ShadowRays::Path
                 : settings.tintedShadows ? ShadowRays::Tinted
                                          : ShadowRays::Opaque,
                 {camera.shutterOpen, camera.shutterClose}, flat);
  if (isPath) {
    FlattenEmitters(flat);
    FlattenLightTree(flat);
  }
  const Spectrum ambientOfLights = flat.params.ambient;
  FlattenEnvironment(scene.environment, flat);
  const uint group = scene::LightGroupIndex(lightGroups, scene.environment.lightGroup);
  flat.params.environment.group = group;
  flat.params.ambientByGroup[group] += flat.params.ambient - ambientOfLights;

  // See what the objects ask of the integrator
  for (const Object& object : flat.objects) {
    if ((object.mask & MASK_TINT) != 0) flat.params.tintedShadows = 1;
  }
  flat.bodies = BodiesOf(flat);
  SeeWhetherInside(flat);
  return flat;
}

}  // namespace snell::cpu
