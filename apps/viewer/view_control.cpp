// SPDX-License-Identifier: Apache-2.0
#include "viewer/view_control.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace snell::viewer {

namespace {

using glm::dvec3;

constexpr double NearestToPole = 0.01;  // radians

dvec3 ToVector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
std::array<double, 3> ToArray(const dvec3& v) { return {v.x, v.y, v.z}; }

// What a view stands on: its distance and unit vectors.
struct Frame {
  explicit Frame(const CameraView& view)
      : sight(ToVector(view.lookAt) - ToVector(view.position)),
        distance(glm::length(sight)),
        forward(sight / distance),
        pole(glm::normalize(ToVector(view.up))),
        right(glm::normalize(glm::cross(forward, pole))),
        up(glm::cross(right, forward)) {}

  dvec3 sight;
  double distance;
  dvec3 forward;
  dvec3 pole;
  dvec3 right;
  dvec3 up;
};

// Rodrigues' rotation about a unit axis.
dvec3 Rotated(const dvec3& v, const dvec3& axis, double angle) {
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
}

// The line of sight, turned about the pole and towards it.
dvec3 TurnedSight(const Frame& frame, double right, double up) {
  const double elevation = std::asin(std::clamp(glm::dot(frame.forward, frame.pole), -1.0, 1.0));
  const double most = std::numbers::pi / 2 - NearestToPole;
  const double turn = std::clamp(elevation + up, -most, most) - elevation;
  return Rotated(Rotated(frame.sight, frame.right, turn), frame.pole, -right);
}

CameraView Moved(CameraView view, const dvec3& way) {
  view.position = ToArray(ToVector(view.position) + way);
  view.lookAt = ToArray(ToVector(view.lookAt) + way);
  return view;
}

}  // namespace

CameraView Orbit(const CameraView& view, double right, double up) {
  CameraView turned = view;
  turned.position = ToArray(ToVector(view.lookAt) - TurnedSight(Frame(view), -right, -up));
  return turned;
}

CameraView Look(const CameraView& view, double right, double up) {
  CameraView turned = view;
  turned.lookAt = ToArray(ToVector(view.position) + TurnedSight(Frame(view), right, up));
  return turned;
}

CameraView Pan(const CameraView& view, double right, double up) {
  const Frame frame(view);
  const double height = 2 * frame.distance * std::tan(glm::radians(view.fovDegrees) / 2);
  return Moved(view, (frame.right * right + frame.up * up) * height);
}

CameraView Dolly(const CameraView& view, double factor) {
  CameraView moved = view;
  moved.position = ToArray(ToVector(view.lookAt) - Frame(view).sight * factor);
  return moved;
}

CameraView Fly(const CameraView& view, double right, double up, double forward) {
  const Frame frame(view);
  return Moved(view,
               (frame.right * right + frame.up * up + frame.forward * forward) * frame.distance);
}

CameraView Focus(const CameraView& view, const std::array<double, 3>& point) {
  const dvec3 sight = ToVector(point) - ToVector(view.position);
  const double side = glm::length(glm::cross(sight, glm::normalize(ToVector(view.up))));
  if (!(side > NearestToPole * glm::length(sight))) return view;  // above or below, or no distance
  CameraView turned = view;
  turned.lookAt = point;
  return turned;
}

}  // namespace snell::viewer
