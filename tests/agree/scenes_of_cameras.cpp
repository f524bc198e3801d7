// SPDX-License-Identifier: Apache-2.0
//
// Every kind of camera in the middle of the same few things: lenses with and without blades, panoramas, fisheyes.
#include <numbers>

#include "agree/scene_builder.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

constexpr float Pi = std::numbers::pi_v<float>;

// Balls and a block on all sides of the camera.
SceneBuilder Surrounded(const char* name) {
  SceneBuilder builder(name, vec3(0.1f, 0.6f, 0.2f), vec3(0.3f, 0.4f, -3));
  builder.camera().up = vec3(0.2f, 1, 0);
  builder.Add(PointLight(vec3(2, 5, 1), 90));
  builder.Add(AmbientLight(0.2f));
  builder.environment() = {{0.3f, 0.2f, 0.1f}, {0.2f, 0.3f, 0.6f}, -0.5f, 0.9f, 1};
  const int matte = builder.Add(Matte({0.8f, 0.4f, 0.3f}));
  const int mirror = builder.Add(Mirror(Spectrum(0.7f)));
  for (int i = 0; i < 6; ++i) {
    const Affine around = Turn(float(i) * 60, vec3(0, 1, 0)) * Move({0, 0.2f * float(i), -3});
    if (i % 2 == 0) {
      builder.Place(scene::Sphere{vec3(0), 0.7f}, matte, around);
    } else {
      builder.Place(scene::Box{vec3(-0.5f), vec3(0.5f)}, mirror, around);
    }
  }
  builder.Floor(-0.8f);
  return builder;
}

scene::Scene BladedLens() {
  SceneBuilder builder = Surrounded("BladedLens");
  scene::Camera& camera = builder.camera();
  camera.shift = scene::vec2(0.1f, -0.2f);
  camera.lens = {0.15f, 2.5f, 5, 0.3f, 0.7f};
  return builder.Finish();
}

scene::Scene LensOfParallelRays() {
  SceneBuilder builder = Surrounded("LensOfParallelRays");
  scene::Camera& camera = builder.camera();
  camera.kind = scene::CameraKind::Orthographic;
  camera.height = 3;
  camera.shift = scene::vec2(-0.3f, 0.1f);
  camera.lens.radius = 0.2f;
  camera.lens.focusDistance = 3;
  return builder.Finish();
}

scene::Scene Panorama() {
  SceneBuilder builder = Surrounded("Panorama");
  builder.camera().kind = scene::CameraKind::Panorama;
  return builder.Finish();
}

scene::Scene PartOfPanorama() {
  SceneBuilder builder = Surrounded("PartOfPanorama");
  builder.camera().kind = scene::CameraKind::Panorama;
  builder.camera().longitude = scene::vec2(0.5f * Pi, -Pi);
  builder.camera().latitude = scene::vec2(-0.4f, 1.2f);
  return builder.Finish();
}

scene::Scene Fisheye(const char* name, scene::FisheyeProjection projection, float fov, bool full) {
  SceneBuilder builder = Surrounded(name);
  builder.camera().kind = scene::CameraKind::Fisheye;
  builder.camera().projection = projection;
  builder.camera().fov = fov;
  builder.camera().fullFrame = full;
  return builder.Finish();
}

}  // namespace

std::vector<scene::Scene> ScenesOfCameras() {
  using scene::FisheyeProjection;
  return {BladedLens(),
          LensOfParallelRays(),
          Panorama(),
          PartOfPanorama(),
          Fisheye("EquidistantFisheye", FisheyeProjection::Equidistant, Pi, false),
          Fisheye("EquisolidFisheye", FisheyeProjection::Equisolid, 2 * Pi, false),
          Fisheye("StereographicFisheye", FisheyeProjection::Stereographic, 4, true)};
}

}  // namespace snell::agree
