// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "cpu/flatten_motion.h"
#include "kernel/math.h"
#include "scene/camera.h"
#include "scene/motion.h"
#include "scene/settings.h"

namespace snell::cpu {

using namespace kernel;

namespace {

uint KindOf(const scene::Camera& camera) {
  switch (camera.kind) {
    case scene::CameraKind::Pinhole: return CAMERA_PINHOLE;
    case scene::CameraKind::Orthographic: return CAMERA_ORTHOGRAPHIC;
    case scene::CameraKind::Panorama: return CAMERA_PANORAMA;
    case scene::CameraKind::Fisheye: break;
  }
  switch (camera.projection) {
    case scene::FisheyeProjection::Equidistant: return CAMERA_EQUIDISTANT;
    case scene::FisheyeProjection::Equisolid: return CAMERA_EQUISOLID;
    case scene::FisheyeProjection::Stereographic: return CAMERA_STEREOGRAPHIC;
  }
  return CAMERA_EQUIDISTANT;
}

bool IsFlat(uint kind) { return kind == CAMERA_PINHOLE || kind == CAMERA_ORTHOGRAPHIC; }

void FlattenLens(const scene::Lens& lens, Camera& flat) {
  if (!IsFlat(flat.kind) || lens.radius == 0) return;
  flat.aperture = vec2(lens.radius * lens.ratio, lens.radius);
  flat.focus = lens.focusDistance;
  flat.blades = uint(lens.blades);
  flat.bladeAngle = float(
      std::remainder(std::numbers::pi / 2 + double(lens.bladeRotation), 2 * std::numbers::pi));
}

// What a camera ray stands for: a pixel, or less where many samples share it, which the textures' levels of
// detail need not smooth again (pbrt-v4, section 10.1.2). Pixels of panoramas and fisheyes are taken to be as large as
// those on the line of sight; a lens does not count, for its rays meet different places.
void FlattenCone(const scene::RenderSettings& settings, RenderParams& params) {
  const int spp = settings.spp > 0 ? settings.spp : scene::WhittedSamples;
  const float share = std::max(0.125f, 1 / std::sqrt(float(spp)));
  const float pixel = 2 * params.camera.extent.y / float(params.camera.resolution.y) * share;
  const bool isParallel = params.camera.kind == CAMERA_ORTHOGRAPHIC;
  params.coneWidth = isParallel ? pixel : 0;
  params.coneSpread = isParallel ? 0 : pixel;
}

// The kernel's frames look ahead.
MotionKey KeyOfFrame(const scene::Affine& frame) {
  MotionKey key = KeyOfPlace(frame);
  key.z = -key.z;
  return key;
}

// Whether a ray of the flattened camera may start in the box.
bool MayStartIn(const bvh::Bounds& box, const FlatScene& flat) {
  const Camera& camera = flat.params.camera;
  vec2 beside = camera.aperture;
  if (camera.kind == CAMERA_ORTHOGRAPHIC) beside += glm::abs(camera.center) + camera.extent * 1.1f;
  bvh::Bounds starts;
  const auto extend = [&](vec3 position, vec3 right, vec3 up) {
    const vec3 reach = Abs(right) * beside.x + Abs(up) * beside.y;
    starts.Extend(bvh::Bounds{position - reach, position + reach});
  };
  extend(camera.position, camera.right, camera.up);
  for (uint i = 0; camera.motion != None && i <= camera.motionSteps; ++i) {
    const MotionKey& key = flat.motions[camera.motion + i];
    extend(key.origin, key.x, key.y);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (starts.upper[axis] < box.lower[axis] || starts.lower[axis] > box.upper[axis]) return false;
  }
  return true;
}

}  // namespace

void FlattenCamera(const scene::Camera& camera, const scene::RenderSettings& settings,
                   FlatScene& scene) {
  const scene::Affine frame = scene::FrameAt(camera, camera.shutterOpen);
  const glm::dvec2 extent = scene::HalfExtent(camera, settings.width, settings.height);
  Camera& flat = scene.params.camera;
  flat = {};
  flat.kind = KindOf(camera);
  flat.resolution = {uint(settings.width), uint(settings.height)};
  flat.position = vec3(glm::dvec3(frame[3]));
  flat.right = vec3(glm::dvec3(frame[0]));
  flat.up = vec3(glm::dvec3(frame[1]));
  flat.forward = -vec3(glm::dvec3(frame[2]));
  flat.extent = vec2(extent);
  if (IsFlat(flat.kind)) flat.center = vec2(extent * 2.0 * glm::dvec2(camera.shift));
  if (flat.kind == CAMERA_PANORAMA) {
    flat.center =
        vec2(camera.longitude.x + camera.longitude.y, camera.latitude.x + camera.latitude.y) * 0.5f;
  }
  flat.rim = float(scene::FisheyeDistance(camera.projection, double(camera.fov) / 2));
  FlattenLens(camera.lens, flat);
  FlattenMotion(camera.motion, {camera.shutterOpen, camera.shutterClose}, KeyOfFrame, scene,
                flat.motion, flat.motionSteps);
  FlattenCone(settings, scene.params);
}

void SeeWhetherInside(FlatScene& flat) {
  flat.params.camera.inside = 0;
  for (const bvh::Bounds& body : flat.bodies) {
    if (MayStartIn(body, flat)) flat.params.camera.inside = 1;
  }
}

void ReplaceCamera(const scene::Camera& camera, const scene::RenderSettings& settings,
                   FlatScene& flat) {
  // A moving camera has the keys that it had; views of the array stay sound
  const Camera before = flat.params.camera;
  std::vector<MotionKey> keys;
  keys.swap(flat.motions);
  FlattenCamera(camera, settings, flat);
  keys.swap(flat.motions);
  if (flat.params.camera.motion != None) flat.params.camera.motion = before.motion;
  SeeWhetherInside(flat);
}

}  // namespace snell::cpu
