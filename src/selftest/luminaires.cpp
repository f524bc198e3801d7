// SPDX-License-Identifier: Apache-2.0
//
// A matt floor of albedo ½ under lamps of radiance 1, whose irradiance has closed forms: polygons by Lambert's formula
// (Arvo 1994), spheres and disks by their form factors (Howell, Mengüç and Siegel, catalogue). The lamps are area
// lights, which are sampled and met, and shapes that glow.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "selftest/scenes.h"
#include "selftest/selftest.h"

namespace snell::selftest {
namespace {

constexpr double Pi = std::numbers::pi;

// The floor at the origin, seen from just above it.
scene::Scene Floor() {
  scene::Scene scene = Empty(2, 4096, 2);
  LookAt(scene, {0, 0.005f, 0}, {0, 0, 0}, 1, {0, 0, -1});
  Add(scene, scene::Plane{}, Physical(Spectrum(0.5f)));
  return scene;
}

scene::Light Lamp(scene::LightKind kind) {
  scene::Light lamp;
  lamp.kind = kind;
  return lamp;
}

scene::Material Glowing() {
  scene::Material material = Physical(Spectrum(0.0f));
  material.physical->emission.value = Spectrum(1.0f);
  return material;
}

// Radiance of the floor under one light, or under one thing that glows.
double Under(const scene::Light& lamp) {
  scene::Scene scene = Floor();
  scene.lights.push_back(lamp);
  return MeanRadiance(scene).y;
}
double Under(const scene::Geometry& lamp) {
  scene::Scene scene = Floor();
  Add(scene, lamp, Glowing());
  return MeanRadiance(scene).y;
}
double Under(const vec3 (&corners)[3]) {
  scene::Scene scene = Floor();
  scene::Mesh mesh;
  mesh.positions = {corners[0], corners[1], corners[2]};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes.push_back(mesh);
  Add(scene, scene::MeshGeometry{0}, Glowing());
  return MeanRadiance(scene).y;
}

// The triangles are those of the polygon luminaires in nori's tests (Jakob 2015).
struct Triangle {
  vec3 corners[3];
  double radiance;  // of the floor
};
const Triangle Triangles[] = {{{{-.443432f, .596366f, .495985f},
                                {-.320397f, .0677699f, -.229359f},
                                {.0341197f, .11415f, -.343049f}},
                               0.0898394},
                              {{{.461963f, .397843f, .412747f},
                                {-.0381582f, .851323f, -.156872f},
                                {.195443f, .891957f, -.260672f}},
                               0.0229200},
                              {{{.100871f, .289075f, -.422609f},
                                {-.308386f, .629587f, .423966f},
                                {-.373132f, .237287f, .351592f}},
                               0.0534198},
                              {{{-.17575f, .639397f, .151268f},
                                {.318604f, .732996f, .459771f},
                                {.139095f, .294498f, .478556f}},
                               0.0205314},
                              {{{-.17487f, .447916f, .367201f},
                                {-.405259f, .249607f, -.354079f},
                                {.356029f, .0918984f, -.132271f}},
                               0.2617400}};

void Polygons(const CheckSink& sink) {
  int number = 0;
  for (const Triangle& triangle : Triangles) {
    ++number;
    const auto& c = triangle.corners;
    scene::Light lamp = Lamp(scene::LightKind::Triangle);
    lamp.position = c[0];
    lamp.edgeU = c[1] - c[0];
    lamp.edgeV = c[2] - c[0];
    // Its front must see the floor
    if (glm::dot(glm::cross(lamp.edgeU, lamp.edgeV), c[0]) > 0) std::swap(lamp.edgeU, lamp.edgeV);
    const double tolerance = 6e-3 * triangle.radiance;
    sink(Near("luminaires", fmt::format("triangle {}", number), Under(lamp), triangle.radiance,
              tolerance));
    sink(Near("luminaires", fmt::format("triangle {}, a mesh that glows", number), Under(c),
              triangle.radiance, tolerance));
  }
}

void SpheresAndDisks(const CheckSink& sink) {
  for (const double height : {1.2, 3.0}) {
    // E = π (r/d)² cos θ while all of it is above the floor, E = π r² / (r² + h²) on the axis of a disk
    const vec3 center(0.5f, float(height), -0.4f);
    const double d2 = double(glm::dot(center, center));
    const double sphere = 0.5 / d2 * height / std::sqrt(d2);
    scene::Light lamp = Lamp(scene::LightKind::Sphere);
    lamp.position = center;
    lamp.radius = 1;
    sink(Near("luminaires", fmt::format("sphere at {} m", height), Under(lamp), sphere,
              5e-3 * sphere));
    sink(Near("luminaires", fmt::format("sphere at {} m that glows", height),
              Under(scene::Sphere{center, 1}), sphere, 1.5e-2 * sphere));
    const double disk = 0.5 / (1 + height * height);
    lamp = Lamp(scene::LightKind::Disk);
    lamp.position = {0, float(height), 0};
    lamp.radius = 1;
    sink(Near("luminaires", fmt::format("disk at {} m", height), Under(lamp), disk, 5e-3 * disk));
    sink(Near("luminaires", fmt::format("disk at {} m that glows", height),
              Under(scene::Disk{{0, float(height), 0}, {0, -1, 0}, 1, 0}), disk, 1.5e-2 * disk));
  }
}

void Distant(const CheckSink& sink) {
  scene::Light sun = Lamp(scene::LightKind::Directional);
  sun.direction = glm::normalize(vec3(1, -2, 0.5f));
  sun.strength = 3;
  const double cosine = 2 / std::sqrt(5.25);
  sink(Near("luminaires", "sun", Under(sun), 0.5 * 3 * cosine / Pi, 1e-4));
  scene::Light point = Lamp(scene::LightKind::Point);
  point.position = {0, 2, 1};
  point.strength = 4;
  sink(Near("luminaires", "point", Under(point), 0.5 * 4 * 2 / std::pow(5, 1.5) / Pi, 1e-4));
  scene::Scene sky = Floor();
  sky.environment.bottom = sky.environment.top = Spectrum(0.8f);
  sink(Near("luminaires", "even sky", MeanRadiance(sky).y, 0.4, 1e-4));
}

}  // namespace

void Luminaires(const CheckSink& sink) {
  Polygons(sink);
  SpheresAndDisks(sink);
  Distant(sink);
}

}  // namespace snell::selftest
