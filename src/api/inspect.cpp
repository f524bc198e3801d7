// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "api/scene.h"
#include "bvh/bvh.h"
#include "cpu/flatten.h"
#include "scene/bounds.h"
#include "scene/framing.h"
#include "scene/settings.h"
#include "util/text.h"
#include "util/timer.h"

namespace snell {

namespace {

constexpr float DegreesPerRadian = 57.29577951f;

std::string Format(kernel::vec3 v) { return fmt::format("{:g} {:g} {:g}", v.x, v.y, v.z); }

const char* KindOf(scene::LightKind kind) {
  switch (kind) {
    case scene::LightKind::Ambient: return "ambient light";
    case scene::LightKind::Directional: return "directional light";
    case scene::LightKind::Point: return "point light";
    case scene::LightKind::Spot: return "spot light";
    case scene::LightKind::Rectangle: return "rectangle light";
    case scene::LightKind::Triangle: return "triangle light";
    case scene::LightKind::Disk: return "disk light";
    case scene::LightKind::Sphere: return "sphere light";
  }
  return "light";
}

const char* UnitOf(scene::LightKind kind) {
  switch (kind) {
    case scene::LightKind::Point:
    case scene::LightKind::Spot: return "W/sr";
    case scene::LightKind::Directional: return "W/m²";
    default: return "W/(sr·m²)";
  }
}

struct KindName {
  const char* operator()(const scene::Sphere&) { return "sphere"; }
  const char* operator()(const scene::Plane&) { return "plane"; }
  const char* operator()(const scene::Disk&) { return "disk"; }
  const char* operator()(const scene::Rectangle&) { return "rectangle"; }
  const char* operator()(const scene::Box&) { return "box"; }
  const char* operator()(const scene::Cone& c) {
    return c.radius == c.topRadius ? "cylinder" : "cone";
  }
  const char* operator()(const scene::Torus&) { return "torus"; }
  const char* operator()(const scene::MeshGeometry&) { return "mesh"; }
};

SceneInfo::Item Describe(const scene::Camera& camera) {
  static constexpr const char* Kinds[] = {"pinhole", "orthographic", "panorama", "fisheye"};
  std::string detail = "at " + Format(camera.position);
  const float fov = camera.fov * DegreesPerRadian;
  switch (camera.kind) {
    case scene::CameraKind::Pinhole:
      detail += fmt::format(", {:g}° {}", fov,
                            camera.fovAxis == scene::FovAxis::Vertical ? "high" : "wide");
      break;
    case scene::CameraKind::Orthographic:
      detail += fmt::format(", {:g} m high", camera.height);
      break;
    case scene::CameraKind::Panorama:
      detail += fmt::format(", {:g}° × {:g}°",
                            std::abs(camera.longitude.y - camera.longitude.x) * DegreesPerRadian,
                            (camera.latitude.y - camera.latitude.x) * DegreesPerRadian);
      break;
    case scene::CameraKind::Fisheye: detail += fmt::format(", {:g}° across", fov); break;
  }
  if (camera.lens.radius > 0) {
    detail += fmt::format(", aperture {:g} mm, focus at {:g} m", camera.lens.radius * 2000,
                          camera.lens.focusDistance);
  }
  return {camera.name, Kinds[int(camera.kind)], detail};
}

SceneInfo::Item DescribePhysical(const scene::Material& material) {
  const scene::OpenPbr& pbr = *material.physical;
  std::string detail = fmt::format("roughness {:g}", pbr.specularRoughness.value);
  if (pbr.baseMetalness.value > 0)
    detail += fmt::format(", metalness {:g}", pbr.baseMetalness.value);
  if (material.Refractive())
    detail +=
        fmt::format(", transmits, ior {:g}{}", pbr.specularIor, material.thin ? ", thin" : "");
  if (pbr.coatWeight.value > 0) detail += ", coat";
  if (pbr.fuzzWeight.value > 0) detail += ", fuzz";
  if (pbr.thinFilmWeight.value > 0) detail += ", thin film";
  if (pbr.emission.value != kernel::Spectrum(0.0f)) detail += ", glows";
  if (material.alphaMode == scene::AlphaMode::Mask) detail += ", cut out";
  if (material.alphaMode == scene::AlphaMode::Blend) detail += ", blended";
  return {material.name, "physical", detail};
}

SceneInfo::Item Describe(const scene::Material& material) {
  if (material.physical) return DescribePhysical(material);
  std::string detail = Plural(material.terms.size(), "term");
  if (material.reflectivity.value != kernel::Spectrum(0.0f)) detail += ", reflects";
  if (material.Refractive())
    detail += fmt::format(", transparent, ior {:g}{}", material.ior, material.thin ? ", thin" : "");
  if (material.emission.value != kernel::Spectrum(0.0f)) detail += ", glows";
  return {material.name, "classic", detail};
}

SceneInfo::Item Describe(const scene::Texture& texture) {
  static constexpr const char* Kinds[] = {"checker", "stripes", "gradient",
                                          "marble",  "wood",    "picture"};
  return {texture.name, Kinds[int(texture.kind)], ""};
}

SceneInfo::Item Describe(const scene::Mesh& mesh) {
  std::string detail = fmt::format("{}, {}", Plural(mesh.triangles.size(), "triangle"),
                                   WithCommas(mesh.positions.size()) + " vertices");
  if (!mesh.normals.empty()) detail += ", normals";
  if (!mesh.uvs.empty()) detail += ", uv";
  if (!mesh.keys.empty()) detail += fmt::format(", {} moments", 1 + mesh.keys.size());
  return {mesh.name, "mesh", detail};
}

}  // namespace

SceneInfo Inspect(const Scene& opened) {
  const scene::Scene& scene = opened.contents();
  SceneInfo info;
  info.name = scene.name;
  info.width = scene.settings.width;
  info.height = scene.settings.height;
  scene::RenderSettings settings = scene.settings;
  scene::Resolve(scene, settings);
  info.spp = settings.spp;
  info.integrator = settings.integrator == scene::Integrator::Path ? "path" : "whitted";
  for (const scene::Camera& camera : scene.cameras) info.cameras.push_back(Describe(camera));
  for (const scene::Light& light : scene.lights) {
    info.lights.push_back(
        {light.name, KindOf(light.kind),
         fmt::format("{} {}", Format(light.color * light.strength), UnitOf(light.kind))});
  }
  for (const scene::Material& material : scene.materials)
    info.materials.push_back(Describe(material));
  for (const scene::Texture& texture : scene.textures) info.textures.push_back(Describe(texture));
  for (const scene::Mesh& mesh : scene.meshes) {
    info.meshes.push_back(Describe(mesh));
    info.meshTriangles += mesh.triangles.size();
  }

  // Count the objects
  std::map<std::string, std::uint64_t> counts;
  for (const scene::Object& object : scene.objects) {
    ++counts[std::visit(KindName{}, object.geometry)];
    if (const auto* mesh = std::get_if<scene::MeshGeometry>(&object.geometry))
      info.instancedTriangles += scene.meshes[std::size_t(mesh->mesh)].triangles.size();
  }
  info.objectsByKind.assign(counts.begin(), counts.end());
  info.objects = scene.objects.size();
  const scene::Box3 box = scene::BoundsOf(scene);
  info.bounded = !box.Empty();
  if (info.bounded) {
    info.lower = {box.lower.x, box.lower.y, box.lower.z};
    info.upper = {box.upper.x, box.upper.y, box.upper.z};
  }

  // Prepare it as for rendering, to see what it takes
  const Timer timer;
  const scene::Camera camera =
      scene.cameras.empty() ? scene::DefaultCamera(scene, 1) : scene.cameras.front();
  cpu::FlatScene flat = cpu::Flatten(scene, scene.settings, camera);
  const bvh::Bvh bvh(flat.Geometry());
  info.buildSeconds = timer.Seconds();
  info.textureBytes = flat.TextureBytes();
  info.sceneBytes = flat.MemoryBytes() - info.textureBytes;
  info.finerTriangles = flat.finerTriangles;
  info.warnings = flat.warnings;
  info.bvhBytes = bvh.MemoryBytes();
  return info;
}

}  // namespace snell
