// SPDX-License-Identifier: Apache-2.0
#include "selftest/scenes.h"

#include <glm/trigonometric.hpp>
#include <utility>

#include "cpu/render_cpu.h"
#include "scene/validate.h"

namespace snell::selftest {

scene::Scene Empty(int size, int spp, int maxDepth) {
  scene::Scene scene;
  scene.name = "selftest";
  scene.settings.width = scene.settings.height = size;
  scene.settings.spp = spp;
  scene.settings.maxDepth = maxDepth;
  scene.settings.integrator = scene::Integrator::Path;
  scene.settings.filter = scene::PixelFilter::Box;
  return scene;
}

scene::Material Physical(Spectrum baseColor, float specularWeight) {
  scene::Material material;
  material.physical.emplace();
  material.physical->baseColor.value = baseColor;
  material.physical->specularWeight.value = specularWeight;
  return material;
}

void Add(scene::Scene& scene, scene::Geometry geometry, scene::Material material) {
  scene::Object object;
  object.geometry = std::move(geometry);
  object.material = int(scene.materials.size());
  scene.materials.push_back(std::move(material));
  scene.objects.push_back(std::move(object));
}

void AddQuad(scene::Scene& scene, vec3 corner, vec3 edgeU, vec3 edgeV, Spectrum albedo) {
  Add(scene, scene::Rectangle{corner, edgeU, edgeV}, Physical(albedo));
}

void LookAt(scene::Scene& scene, vec3 position, vec3 at, float fovDegrees, vec3 up) {
  scene::Camera camera;
  camera.position = position;
  camera.lookAt = at;
  camera.up = up;
  camera.fov = glm::radians(fovDegrees);
  scene.cameras = {camera};
}

glm::dvec3 MeanRadiance(const scene::Scene& scene) {
  return MeanRadiance(scene, {0, 0, scene.settings.width, scene.settings.height});
}

glm::dvec3 MeanRadiance(const scene::Scene& scene, const Part& part) {
  scene::Validate(scene, {});
  render::RenderRequest request;
  request.settings = scene.settings;
  request.camera = scene.cameras.at(0);
  request.rect = {part.x0, part.y0, part.x1, part.y1};
  request.lastSample = std::uint32_t(scene.settings.spp);
  render::Film film(request.rect);
  cpu::CpuRenderer renderer;
  renderer.Render(scene, request, film, nullptr, nullptr);
  glm::dvec3 sum(0.0);
  const image::Image picture = film.ToImage();
  for (const vec3& pixel : picture.pixels) sum += glm::dvec3(pixel);
  return sum / double(picture.pixels.size());
}

}  // namespace snell::selftest
