// SPDX-License-Identifier: Apache-2.0
#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/bounds.h"

namespace snell::scene {

namespace {

constexpr double Degree = 3.14159265358979323846 / 180;
constexpr double FramingFov = 30 * Degree;
constexpr double FramingElevation = 20 * Degree;  // beyond half the view: the horizon stays outside
constexpr double FramingAzimuth = 25 * Degree;    // to the right of the front
constexpr double FramingMargin = 1.08;

// From the object to the viewer.
glm::dvec3 Direction(double azimuth, double elevation) {
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          std::cos(azimuth) * std::cos(elevation)};
}

Light StudioLight(const char* name, double azimuth, double elevation, float irradiance,
                  double sizeDegrees) {
  Light light;
  light.name = name;
  light.kind = LightKind::Directional;
  light.direction = vec3(-Direction(azimuth * Degree, elevation * Degree));
  light.strength = irradiance;
  light.angularSize = float(sizeDegrees * Degree);
  light.samples = 4;
  return light;
}

}  // namespace

Camera DefaultCamera(const Scene& scene, double aspect) {
  Box3 box = BoundsOf(scene);
  if (box.Empty()) {
    // Only infinite planes, or nothing: look at the origin
    box.Extend(glm::dvec3(-1));
    box.Extend(glm::dvec3(1));
  }

  // Go back as far as the corner that needs most room asks for
  const glm::dvec3 toViewer = Direction(FramingAzimuth, FramingElevation);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), toViewer));
  const glm::dvec3 up = glm::cross(toViewer, right);
  const double tanY = std::tan(FramingFov / 2);
  const double tanX = tanY * aspect;
  const glm::dvec3 center = box.Center();
  const glm::dvec3 half = box.Size() * 0.5;
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p =
        half * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const double room = FramingMargin * std::max(std::abs(glm::dot(p, right)) / tanX,
                                                 std::abs(glm::dot(p, up)) / tanY);
    distance = std::max(distance, room + glm::dot(p, toViewer));
  }
  if (!(distance > 0)) distance = 1;

  Camera camera;
  camera.name = "default";
  camera.position = vec3(center + toViewer * distance);
  camera.lookAt = vec3(center);
  camera.fov = float(FramingFov);
  return camera;
}

Material DefaultMaterial() {
  Material material;
  material.name = "default";
  Term diffuse;
  diffuse.color.value = Spectrum(0.62f, 0.6f, 0.57f);
  Term ambient = diffuse;
  ambient.kind = TermKind::Ambient;
  Term gloss;
  gloss.kind = TermKind::Blinn;
  gloss.color.value = Spectrum(0.05f);
  gloss.exponent = 40;
  gloss.normalized = true;
  material.terms = {ambient, diffuse, gloss};
  return material;
}

void AddStudio(Scene& scene) {
  const Box3 box = BoundsOf(scene);

  Material ground;
  ground.name = "studio ground";
  Term diffuse;
  diffuse.color.value = Spectrum(0.45f);
  Term ambient = diffuse;
  ambient.kind = TermKind::Ambient;
  ground.terms = {ambient, diffuse};
  Object floor;
  floor.name = "studio ground";
  floor.material = MaterialIndex(scene.materials.size());
  floor.geometry = Plane{vec3(0.0f, box.Empty() ? 0.0f : float(box.lower.y), 0.0f), vec3(0, 1, 0)};
  scene.materials.push_back(ground);
  scene.objects.push_back(floor);

  scene.lights.push_back(StudioLight("key", -40, 48, 2.4f, 10));
  scene.lights.push_back(StudioLight("fill", 60, 30, 0.7f, 20));
  scene.lights.push_back(StudioLight("rim", 165, 35, 1.1f, 10));
  Light fill;
  fill.name = "room";
  fill.kind = LightKind::Ambient;
  fill.strength = 0.12f;
  scene.lights.push_back(fill);
  scene.environment.bottom = Spectrum(0.3f);
  scene.environment.top = Spectrum(0.6f);
}

}  // namespace snell::scene
