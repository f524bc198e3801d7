// SPDX-License-Identifier: Apache-2.0
#include "tessellate/measure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "scene/camera.h"

namespace snell::tessellate {

using glm::dmat3;
using glm::dvec3;

// Of many instances, the first ones alone say how near the camera comes.
constexpr std::size_t MostEyes = 64;

View::View(const scene::Camera& camera, int width, int height)
    : eye(camera.position),
      isOrthographic(camera.kind == scene::CameraKind::Orthographic),
      pixel(2 * scene::HalfExtent(camera, width, height).y / std::max(height, 1)) {}

static dmat3 MetricOf(const scene::Affine& toWorld) {
  const dmat3 linear(toWorld);
  return glm::transpose(linear) * linear;
}

Measure::Measure(const scene::Affine& toWorld)
    : metric_(MetricOf(toWorld)), inverse_(glm::inverse(metric_)) {}

bool Measure::Fits(const scene::Affine& toWorld) const {
  const dmat3 other = MetricOf(toWorld);
  const double size = metric_[0][0] + metric_[1][1] + metric_[2][2];
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (std::abs(other[column][row] - metric_[column][row]) > 1e-9 * size) return false;
  return true;
}

void Measure::AddEye(const View& view, const scene::Affine& toWorld) {
  isOrthographic_ = view.isOrthographic;
  pixel_ = view.pixel;
  if (eyes_.size() < MostEyes)
    eyes_.push_back(glm::inverse(dmat3(toWorld)) * (view.eye - dvec3(toWorld[3])));
}

double Measure::Excess(const scene::vec3& a, const scene::vec3& b,
                       const scene::EdgeTarget& target) const {
  const auto lengthOf = [&](const dvec3& v) { return std::sqrt(glm::dot(v, metric_ * v)); };
  const double length = lengthOf(dvec3(a) - dvec3(b));
  double excess = target.length > 0 ? length / double(target.length) : 0;
  if (!(target.pixels > 0) || eyes_.empty()) return excess;

  double distance = isOrthographic_ ? 1 : std::numeric_limits<double>::infinity();
  if (!isOrthographic_) {
    const dvec3 middle = (dvec3(a) + dvec3(b)) * 0.5;
    for (const dvec3& eye : eyes_) distance = std::min(distance, lengthOf(middle - eye));
    // What is nearer than its own length hardly gets larger
    distance = std::max(distance, length);
  }
  return std::max(excess, length / (pixel_ * distance * double(target.pixels)));
}

dvec3 Measure::AlongNormal(const dvec3& normal) const {
  const dvec3 raised = inverse_ * normal;
  const double square = glm::dot(normal, raised);
  return square > 0 ? raised / std::sqrt(square) : dvec3(0.0);
}

}  // namespace snell::tessellate
