// SPDX-License-Identifier: Apache-2.0
#include "cpu/light_cone.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace snell::cpu {

using glm::dvec3;

static constexpr double Pi = std::numbers::pi;

LightCone LightCone::Union(const LightCone& a, const LightCone& b) {
  const LightCone& wide = a.thetaO >= b.thetaO ? a : b;
  const LightCone& narrow = a.thetaO >= b.thetaO ? b : a;
  LightCone both = wide;
  both.thetaE = std::max(a.thetaE, b.thetaE);
  both.twoSided = a.twoSided || b.twoSided;
  if (wide.thetaO >= Pi) return both;
  double cosine = glm::dot(wide.axis, narrow.axis);
  dvec3 other = narrow.axis;
  if (a.twoSided && b.twoSided && cosine < 0) {
    other = -other;
    cosine = -cosine;
  }
  const double between = std::acos(std::clamp(cosine, -1.0, 1.0));
  if (between + narrow.thetaO <= wide.thetaO) return both;

  // Turn the wider one's axis towards the other's until both lie within
  both.thetaO = (wide.thetaO + between + narrow.thetaO) / 2;
  const dvec3 side = other - wide.axis * cosine;
  const double length = glm::length(side);
  if (both.thetaO >= Pi || !(length > 1e-9)) {
    both.thetaO = between < 1e-6 ? std::min(both.thetaO, Pi) : Pi;
    return both;
  }
  const double turn = both.thetaO - wide.thetaO;
  both.axis = glm::normalize(wide.axis * std::cos(turn) + side * (std::sin(turn) / length));
  return both;
}

double LightCone::Measure() const {
  const double w = std::min(thetaO + thetaE, Pi);
  const double sine = std::sin(thetaO);
  const double cosine = std::cos(thetaO);
  const double measure =
      2 * Pi * (1 - cosine) +
      Pi / 2 * (2 * w * sine - std::cos(thetaO - 2 * w) - 2 * thetaO * sine + cosine);
  return twoSided ? 2 * measure : measure;
}

}  // namespace snell::cpu
