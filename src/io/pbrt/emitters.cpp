// SPDX-License-Identifier: Apache-2.0
//
// Shapes that emit as the scene's area lights: disks, spheres, parallelograms and single triangles.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "io/pbrt/lights.h"

namespace snell::io {
namespace {

// A mesh of more triangles would need as many lights.
constexpr std::size_t MaxTriangles = 12;
// Lights of one shape beyond which each gets a single shadow ray.
constexpr std::size_t ManyLights = 2;

class Emitter {
 public:
  Emitter(const PbrtEmitter& emitter, const scene::Scene& scene)
      : emitter_(emitter), scene_(scene) {}

  // The lights on its outside, in the world; none if there are none of its kind.
  std::vector<scene::Light> Lights() const {
    std::vector<scene::Light> lights;
    if (const auto* sphere = std::get_if<scene::Sphere>(&emitter_.geometry)) {
      const double scale = Similarity();
      if (scale == 0) return {};
      lights.emplace_back().kind = scene::LightKind::Sphere;
      lights[0].position = Point(sphere->center);
      lights[0].radius = float(double(sphere->radius) * scale);
    } else if (const auto* disk = std::get_if<scene::Disk>(&emitter_.geometry)) {
      const double scale = Similarity();
      if (scale == 0 || disk->innerRadius > 0) return {};
      lights.emplace_back().kind = scene::LightKind::Disk;
      lights[0].position = Point(disk->center);
      lights[0].direction = Normal(disk->normal);
      lights[0].radius = float(double(disk->radius) * scale);
    } else if (const auto* mesh = std::get_if<scene::MeshGeometry>(&emitter_.geometry)) {
      AddTriangles(scene_.meshes[std::size_t(mesh->mesh)], lights);
    }
    return lights;
  }

  double Area() const {
    if (const auto* sphere = std::get_if<scene::Sphere>(&emitter_.geometry))
      return 4 * std::numbers::pi * Square(double(sphere->radius)) * MeanScale();
    if (const auto* disk = std::get_if<scene::Disk>(&emitter_.geometry))
      return std::numbers::pi * (Square(double(disk->radius)) - Square(double(disk->innerRadius))) *
             MeanScale();
    if (const auto* cone = std::get_if<scene::Cone>(&emitter_.geometry))
      return 2 * std::numbers::pi * double(cone->radius) *
             glm::length(glm::dvec3(cone->top) - glm::dvec3(cone->base)) * MeanScale();
    const auto* geometry = std::get_if<scene::MeshGeometry>(&emitter_.geometry);
    if (!geometry) return 0;
    const scene::Mesh& mesh = scene_.meshes[std::size_t(geometry->mesh)];
    const glm::dmat3 linear(emitter_.toWorld);
    double area = 0;
    for (const scene::uvec3& t : mesh.triangles) {
      const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
      area += glm::length(glm::cross(linear * (b - a), linear * (c - a))) / 2;
    }
    return area;
  }

 private:
  static double Square(double x) { return x * x; }

  scene::vec3 Point(const scene::vec3& p) const {
    return scene::vec3(emitter_.toWorld * glm::dvec4(p, 1));
  }
  scene::vec3 Normal(const scene::vec3& n) const {
    const glm::dmat3 linear(emitter_.toWorld);
    return scene::vec3(glm::normalize(glm::transpose(glm::inverse(linear)) * glm::dvec3(n)));
  }

  // How areas grow, as for a similarity.
  double MeanScale() const {
    return std::pow(std::abs(glm::determinant(glm::dmat3(emitter_.toWorld))), 2.0 / 3);
  }
  // By how much the map enlarges all lengths; 0 if it does not treat all alike.
  double Similarity() const {
    const glm::dmat3 linear(emitter_.toWorld);
    const double scale = glm::length(linear[0]);
    for (int i = 0; i < 3; ++i) {
      if (std::abs(glm::length(linear[i]) - scale) > 1e-4 * scale) return 0;
      if (std::abs(glm::dot(linear[i], linear[(i + 1) % 3])) > 1e-4 * scale * scale) return 0;
    }
    return scale;
  }

  void AddTriangles(const scene::Mesh& mesh, std::vector<scene::Light>& lights) const {
    if (mesh.triangles.size() > MaxTriangles) return;
    for (const scene::uvec3& t : mesh.triangles) {
      scene::Light light = Triangle(mesh, t);
      if (!(glm::length(glm::cross(light.edgeU, light.edgeV)) > 0)) continue;
      if (!lights.empty() && Join(lights.back(), light)) continue;
      lights.push_back(light);
    }
  }

  // The normal of the light is that of the mesh.
  scene::Light Triangle(const scene::Mesh& mesh, const scene::uvec3& t) const {
    scene::Light light;
    light.kind = scene::LightKind::Triangle;
    const scene::vec3 a = Point(mesh.positions[t.x]), b = Point(mesh.positions[t.y]),
                      c = Point(mesh.positions[t.z]);
    light.position = a;
    light.edgeU = b - a;
    light.edgeV = c - a;
    bool isTurned = glm::determinant(glm::dmat3(emitter_.toWorld)) < 0;
    if (!mesh.normals.empty()) {
      const scene::vec3 sum = mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z];
      if (glm::dot(sum, sum) > 0)
        isTurned = glm::dot(Normal(sum), glm::cross(light.edgeU, light.edgeV)) < 0;
    }
    if (isTurned) std::swap(light.edgeU, light.edgeV);
    return light;
  }

  // Makes a parallelogram of two triangles that are its halves.
  static bool Join(scene::Light& first, const scene::Light& second) {
    if (first.kind != scene::LightKind::Triangle) return false;
    const scene::vec3 p[3] = {first.position, first.position + first.edgeU,
                              first.position + first.edgeV};
    const scene::vec3 q[3] = {second.position, second.position + second.edgeU,
                              second.position + second.edgeV};
    const float size = glm::length(first.edgeU) + glm::length(first.edgeV);
    const auto same = [&](const scene::vec3& a, const scene::vec3& b) {
      return glm::length(a - b) < 1e-4f * size;
    };
    for (int i = 0; i < 3; ++i) {
      // The corner opposite to the shared edge, and the other one's
      const scene::vec3 corner = p[i], next = p[(i + 1) % 3], last = p[(i + 2) % 3];
      for (int k = 0; k < 3; ++k) {
        if (!same(q[(k + 1) % 3], last) || !same(q[(k + 2) % 3], next)) continue;
        if (!same(corner + (next - corner) + (last - corner), q[k])) continue;
        first.kind = scene::LightKind::Rectangle;
        first.position = corner;
        first.edgeU = next - corner;
        first.edgeV = last - corner;
        return true;
      }
    }
    return false;
  }

  const PbrtEmitter& emitter_;
  const scene::Scene& scene_;
};

bool IsFinite(const scene::Light& light) {
  const scene::vec3 sum = light.position + light.edgeU + light.edgeV + light.direction;
  return std::isfinite(sum.x + sum.y + sum.z) && std::isfinite(light.radius);
}

}  // namespace

scene::Spectrum RadianceOf(const PbrtAreaLight& light, const PbrtEmitter& emitter,
                           const scene::Scene& scene) {
  if (!(light.power > 0)) return light.radiance;
  const double area = Emitter(emitter, scene).Area() * (light.isTwoSided ? 2 : 1);
  const double radiance = double(light.power) / (area * std::numbers::pi);
  if (!std::isfinite(radiance)) return light.radiance;
  return glm::min(light.radiance * float(radiance), scene::Spectrum(1e30f));
}

bool AddEmitter(const PbrtAreaLight& light, const PbrtEmitter& emitter, scene::Scene& scene) {
  std::vector<scene::Light> lights = Emitter(emitter, scene).Lights();
  if (lights.empty() || !std::ranges::all_of(lights, IsFinite)) return false;
  const std::size_t count = lights.size();
  for (scene::Light made : lights) {
    made.name = "area light";
    made.color = RadianceOf(light, emitter, scene);
    made.visible = emitter.isVisible && !light.isTwoSided;
    if (count > ManyLights) made.samples = 1;
    scene.lights.push_back(made);
    if (!light.isTwoSided || made.kind == scene::LightKind::Sphere) continue;
    std::swap(made.edgeU, made.edgeV);
    made.direction = -made.direction;
    scene.lights.push_back(made);
  }
  return true;
}

}  // namespace snell::io
