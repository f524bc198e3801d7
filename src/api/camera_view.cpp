// SPDX-License-Identifier: Apache-2.0
#include "api/camera_view.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include "scene/camera.h"
#include "scene/motion.h"

namespace snell {

namespace {

std::array<double, 3> ToArray(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 ToVector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

void RequireSound(const CameraView& view) {
  const glm::dvec3 sight = ToVector(view.lookAt) - ToVector(view.position);
  const glm::dvec3 side = glm::cross(sight, ToVector(view.up));
  const bool isTurned = glm::dot(side, side) > 0 && std::isfinite(glm::dot(side, side));
  if (!isTurned || !(view.fovDegrees > 0 && view.fovDegrees < 180))
    throw Error(
        "a camera cannot look like that: its line of sight must have a length and must not "
        "be parallel to its up, and its angle lies between 0 and 180 degrees");
}

}  // namespace

CameraView ViewOfCamera(const scene::Camera& camera, int width, int height) {
  const scene::Affine frame = scene::FrameAt(camera, camera.shutterOpen);
  const glm::dvec3 position(frame[3]);
  const double distance = glm::distance(glm::dvec3(camera.position), glm::dvec3(camera.lookAt));
  CameraView view;
  view.position = ToArray(position);
  view.up = ToArray(glm::dvec3(frame[1]));
  view.lookAt = ToArray(position - glm::dvec3(frame[2]) * distance);
  if (camera.motion.empty()) {
    view.up = ToArray(glm::dvec3(camera.up));
    view.lookAt = ToArray(glm::dvec3(camera.lookAt));
  }

  // Half the view's height at distance 1
  const double half = std::abs(scene::HalfExtent(camera, width, height).y);
  if (camera.kind == scene::CameraKind::Pinhole)
    view.fovDegrees = glm::degrees(2 * std::atan(half));
  if (camera.kind == scene::CameraKind::Orthographic)
    view.fovDegrees = glm::degrees(2 * std::atan(half / distance));
  return view;
}

scene::Camera CameraSeenFrom(scene::Camera camera, const CameraView& view) {
  RequireSound(view);
  camera.position = glm::vec3(ToVector(view.position));
  camera.lookAt = glm::vec3(ToVector(view.lookAt));
  camera.up = glm::vec3(ToVector(view.up));
  camera.motion = {};
  const double fov = glm::radians(view.fovDegrees);
  if (camera.kind == scene::CameraKind::Pinhole) {
    camera.fov = float(fov);
    camera.fovAxis = scene::FovAxis::Vertical;
  }
  if (camera.kind == scene::CameraKind::Orthographic)
    camera.height = float(2 * std::tan(fov / 2) *
                          glm::distance(ToVector(view.position), ToVector(view.lookAt)));
  return camera;
}

}  // namespace snell
