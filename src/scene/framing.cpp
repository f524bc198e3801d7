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
constexpr double FramingMargin = 1.18;
constexpr double FramingDistanceOfNothing = 7;

// From the object to the viewer.
glm::dvec3 Direction(double azimuth, double elevation) {
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          std::cos(azimuth) * std::cos(elevation)};
}

// Where to stand so that all objects fit between two planes through the eye.
struct Fit {
  double offset = 0;    // of the line of sight from the centre, along the axis
  double distance = 0;  // of the eye from the centre, along the line of sight
};

// Fit the objects between the planes that rise by `tangent` to both sides of the line of sight. A point at
// (x, z) along the axis and towards the viewer lies between them if x - offset ≤ (distance - z) · tangent
// and the same holds for -x and -offset. Both sides are linear in the point, so that the box of the sheared
// objects gives the extreme ones.
Fit FitBetween(const Scene& scene, glm::dvec3 center, glm::dvec3 axis, glm::dvec3 toViewer,
               double tangent) {
  tangent /= FramingMargin;
  const glm::dvec3 rising = toViewer + axis / tangent, falling = toViewer - axis / tangent;
  Affine shear(1.0);
  for (int column = 0; column < 3; ++column) {
    shear[column][0] = rising[column];
    shear[column][1] = falling[column];
  }
  shear[3] = glm::dvec4(-glm::dot(rising, center), -glm::dot(falling, center), 0, 1);
  const Box3 box = BoundsOf(scene, shear);
  if (box.Empty()) return {};
  return {tangent * (box.upper.x - box.upper.y) / 2, (box.upper.x + box.upper.y) / 2};
}

Light StudioLight(const char* name, double azimuth, double elevation, Spectrum color,
                  float irradiance, double sizeDegrees) {
  Light light;
  light.name = name;
  light.kind = LightKind::Directional;
  light.direction = vec3(-Direction(azimuth * Degree, elevation * Degree));
  light.color = color;
  light.strength = irradiance;
  light.angularSize = float(sizeDegrees * Degree);
  light.samples = 4;
  return light;
}

}  // namespace

Camera DefaultCamera(const Scene& scene, double aspect) {
  const Box3 box = BoundsOf(scene);

  // Look at the middle from the front, or at the origin if there are only infinite planes, or nothing
  const glm::dvec3 center = box.Empty() ? glm::dvec3(0) : box.Center();
  const glm::dvec3 toViewer = Direction(FramingAzimuth, FramingElevation);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), toViewer));
  const glm::dvec3 up = glm::cross(toViewer, right);
  const Fit across = FitBetween(scene, center, right, toViewer, std::tan(FramingFov / 2) * aspect);
  const Fit upright = FitBetween(scene, center, up, toViewer, std::tan(FramingFov / 2));

  // Take the distance that both ways need; a single point would need none
  double distance = std::max(across.distance, upright.distance);
  if (box.Empty() || box.lower == box.upper) distance = FramingDistanceOfNothing;
  const glm::dvec3 target = center + right * across.offset + up * upright.offset;

  Camera camera;
  camera.name = "default";
  camera.position = vec3(target + toViewer * distance);
  camera.lookAt = vec3(target);
  camera.fov = float(FramingFov);
  return camera;
}

Material DefaultMaterial() {
  Material material;
  material.name = "default";
  Term diffuse;
  diffuse.color.value = Spectrum(0.74f, 0.65f, 0.55f);
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

Material ColoredMaterial() {
  Material material;
  material.name = "vertex colors";
  material.physical.emplace().baseColor.value = Spectrum(1.0f);
  return material;
}

void AddStudio(Scene& scene) {
  const Box3 box = BoundsOf(scene);

  // Stand the objects on a ground that is darker and cooler than they are and mirrors a little of the room
  Material ground;
  ground.name = "studio ground";
  Term diffuse;
  diffuse.color.value = Spectrum(0.16f, 0.18f, 0.2f);
  Term ambient = diffuse;
  ambient.kind = TermKind::Ambient;
  ground.terms = {ambient, diffuse};
  ground.reflectivity.value = Spectrum(1.0f);
  ground.reflection = ReflectionModel::Fresnel;
  ground.ior = 1.3f;
  Object floor;
  floor.name = "studio ground";
  floor.material = MaterialIndex(scene.materials.size());
  // A little below them, for their own lowest faces are to be seen
  const double height = box.Empty() ? 0 : box.lower.y - 2e-4 * glm::length(box.upper - box.lower);
  floor.geometry = Plane{vec3(0.0f, float(height), 0.0f), vec3(0, 1, 0)};
  scene.materials.push_back(ground);
  scene.objects.push_back(floor);

  // Light them warm from the left, cool from the right and along the edges from behind
  const Spectrum warm(1.0f, 0.94f, 0.86f), cool(0.8f, 0.9f, 1.0f), white(1.0f);
  scene.lights.push_back(StudioLight("key", -42, 46, warm, 3.1f, 10));
  scene.lights.push_back(StudioLight("fill", 75, 30, cool, 0.45f, 25));
  scene.lights.push_back(StudioLight("rim", 165, 40, white, 0.9f, 15));
  Light fill;
  fill.name = "room";
  fill.kind = LightKind::Ambient;
  fill.color = cool;
  fill.strength = 0.1f;
  scene.lights.push_back(fill);
  scene.environment.bottom = Spectrum(0.45f, 0.42f, 0.38f);
  scene.environment.top = Spectrum(0.5f, 0.62f, 0.75f);
}

}  // namespace snell::scene
