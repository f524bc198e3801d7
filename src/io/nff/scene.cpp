// SPDX-License-Identifier: Apache-2.0
#include "io/nff/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <utility>

#include "io/mesh/polygon.h"
#include "util/text.h"

namespace snell::io {

using scene::Spectrum;
using scene::vec3;

// A light that the textbooks call of intensity 1 gives the irradiance π (kernel/classic.h).
static constexpr float Intensity = std::numbers::pi_v<float>;

NffScene::NffScene(std::string file, const WarningSink& warn)
    : file_(std::move(file)), warn_(warn) {
  scene_.name = std::filesystem::path(file_).filename().string();

  // Trace as the authors of the standard scenes ask: one ray a pixel, five levels, no branch cut off
  scene::RenderSettings& settings = scene_.settings;
  settings.width = settings.height = NffView{}.width;
  settings.spp = 1;
  settings.filter = scene::PixelFilter::Box;
  settings.maxDepth = 5;
  settings.minContribution = 0;
}

void NffScene::AddView(const NffView& view, const Place& place) {
  if (scene_.cameras.empty()) {
    scene_.settings.width = view.width;
    scene_.settings.height = view.height;
  }
  if (view.width != view.height) Note(WideView, place);

  // Widen the angle by the half pixels beyond the middles of the outermost rows
  scene::Camera camera;
  camera.position = view.from;
  camera.lookAt = view.at;
  camera.up = view.up;
  const double angle = double(view.angleDegrees) * (std::numbers::pi / 180);
  const double rows = view.height > 1 ? view.height / (view.height - 1.0) : 1.0;
  camera.fov = float(2 * std::atan(std::tan(0.5 * angle) * rows));
  scene_.cameras.push_back(camera);
}

void NffScene::SetBackground(Spectrum color) {
  scene_.environment.bottom = color;
  scene_.environment.top = color;
}

void NffScene::AddLight(vec3 position, Spectrum color) {
  scene::Light light;
  light.kind = scene::LightKind::Point;
  light.falloff = scene::Falloff::None;
  light.position = position;
  light.color = color;
  light.strength = Intensity;
  scene_.lights.push_back(light);
  lightHasColor_.push_back(true);
}

void NffScene::AddLight(vec3 position) {
  AddLight(position, Spectrum(1.0f));
  lightHasColor_.back() = false;
}

// NFF adds shares of the arriving light: Kd · diffuse + Ks · (highlight + mirrored) + T · refracted. Our
// material gives its terms what reflection and refraction leave (kernel/interface.h), so the shares are
// divided by that, as far as energy is conserved.
static scene::Material ClassicMaterial(const NffFill& fill) {
  const float opaque = 1 - fill.transmittance;
  const float own = opaque * (1 - fill.specular);
  const auto shareOf = [](float share, float left) { return share < left ? share / left : 1.0f; };

  scene::Material material;
  if (fill.diffuse > 0) {
    scene::Term diffuse;
    diffuse.kind = scene::TermKind::Diffuse;
    diffuse.color.value = fill.color * shareOf(fill.diffuse, own);
    material.terms.push_back(diffuse);
  }
  if (fill.specular > 0) {
    scene::Term specular;
    specular.kind = scene::TermKind::Phong;
    specular.color.value = Spectrum(shareOf(fill.specular, opaque));
    specular.exponent = fill.shine;
    material.terms.push_back(specular);
  }
  material.reflection = scene::ReflectionModel::Constant;
  material.reflectivity.value = Spectrum(fill.specular);
  material.transparency.value = Spectrum(fill.transmittance);
  material.ior = fill.transmittance > 0 ? fill.ior : 1.0f;
  return material;
}

scene::MaterialIndex NffScene::MaterialOf(const NffFill& fill, const Place& place) {
  const std::array<float, 8> key = {fill.color.x,  fill.color.y, fill.color.z,       fill.diffuse,
                                    fill.specular, fill.shine,   fill.transmittance, fill.ior};
  const auto [entry, isNew] = materialOf_.try_emplace(key, int(scene_.materials.size()));
  if (isNew) {
    scene_.materials.push_back(ClassicMaterial(fill));
    scene_.materials.back().name = fmt::format("fill of line {}", place.line);
  }
  return entry->second;
}

void NffScene::SetFill(const NffFill& fill, const Place& place) {
  // Cut what would give back more light than arrives
  NffFill cut = fill;
  cut.color = Spectrum(std::min(cut.color.x, 1.0f), std::min(cut.color.y, 1.0f),
                       std::min(cut.color.z, 1.0f));
  for (float* share : {&cut.diffuse, &cut.specular, &cut.transmittance})
    *share = std::min(*share, 1.0f);
  const bool fits = cut.color == fill.color && cut.diffuse == fill.diffuse &&
                    cut.specular == fill.specular && cut.transmittance == fill.transmittance;
  if (!fits) Note(ShareAboveOne, place);

  // A body that light passes through is a mesh of its own, so that its inside is its own
  const scene::MaterialIndex material = MaterialOf(cut, place);
  if (material != material_ || cut.transmittance > 0) CloseMesh();
  material_ = material;
}

void NffScene::AddObject(scene::Geometry geometry, const Place& place) {
  if (material_ < 0) {
    Note(NoFill, place);
    SetFill(NffFill{}, place);
  }
  scene::Object object;
  object.geometry = std::move(geometry);
  object.material = material_;
  object.place = place;
  scene_.objects.push_back(std::move(object));
}

void NffScene::AddSphere(vec3 center, float radius, const Place& place) {
  if (radius == 0) return Note(NoExtent, place);
  if (radius < 0) Note(InsideOnly, place);
  AddObject(scene::Sphere{center, std::abs(radius)}, place);
}

void NffScene::AddCone(vec3 base, float radius, vec3 top, float topRadius, const Place& place) {
  if (radius == 0 && topRadius == 0) return Note(NoExtent, place);
  if (radius < 0 || topRadius < 0) Note(InsideOnly, place);
  AddObject(scene::Cone{base, top, std::abs(radius), std::abs(topRadius), false}, place);
}

scene::Mesh& NffScene::OpenMesh(const Place& place) {
  if (openMesh_ < 0) {
    const scene::MeshIndex index = int(scene_.meshes.size());
    scene_.meshes.emplace_back();
    scene_.meshes.back().name = fmt::format("polygons from line {}", place.line);
    AddObject(scene::MeshGeometry{index}, place);
    openMesh_ = index;
  }
  return scene_.meshes[std::size_t(openMesh_)];
}

void NffScene::CloseMesh() {
  if (openMesh_ < 0) return;
  scene::Mesh& mesh = scene_.meshes[std::size_t(openMesh_)];
  if (!openMeshIsSmooth_) mesh.normals = {};
  openMesh_ = -1;
  openMeshIsSmooth_ = false;
}

void NffScene::AddPolygon(std::span<const vec3> corners, std::span<const vec3> normals,
                          const Place& place) {
  const PolygonTriangles polygon = TriangulatePolygon(corners);
  if (polygon.triangles.empty()) return Note(NoArea, place);
  if (!polygon.simple) Note(CrossedOutline, place);

  // Flat polygons bring their own normal, in case patches follow in the same mesh
  scene::Mesh& mesh = OpenMesh(place);
  const std::uint32_t first = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 given = normals.empty() ? glm::dvec3(0.0) : glm::dvec3(normals[i]);
    const double length = glm::length(given);
    mesh.normals.push_back(length > 0 ? vec3(given / length) : polygon.normal);
  }
  openMeshIsSmooth_ = openMeshIsSmooth_ || !normals.empty();
  for (const scene::uvec3& triangle : polygon.triangles) mesh.triangles.push_back(triangle + first);
}

void NffScene::Note(Finding finding, const Place& place) {
  if (findings_[finding].times++ == 0) findings_[finding].first = place;
}

void NffScene::Warn() const {
  static constexpr std::array<const char*, FindingCount> Messages = {
      "objects before the first fill ('f') are white",
      "colours and shares of light above 1 are cut to 1",
      "a negative radius asks for the inside only; both sides are shown",
      "a shape with radius 0 is left out",
      "a polygon without area is left out",
      "the outline of a polygon crosses itself; its area is a guess",
      "the view is not as wide as high; its angle is taken from top to bottom"};
  for (std::size_t i = 0; i < FindingCount; ++i) {
    const Count& count = findings_[i];
    if (count.times == 0 || !warn_) continue;
    const std::string times =
        count.times > 1 ? fmt::format(" ({} times)", WithCommas(count.times)) : "";
    warn_({Messages[i] + times, count.first, ""});
  }
}

scene::Scene NffScene::Finish() {
  CloseMesh();
  Warn();
  if (scene_.objects.empty())
    throw Error("nothing to see: no sphere, cone or polygon in this NFF file", {file_});

  // Where the file says nothing, n lights share the brightness as 1/√n each
  const float share = 1 / std::sqrt(float(std::max<std::size_t>(scene_.lights.size(), 1)));
  for (std::size_t i = 0; i < scene_.lights.size(); ++i)
    if (!lightHasColor_[i]) scene_.lights[i].strength = Intensity * share;
  return std::move(scene_);
}

}  // namespace snell::io
