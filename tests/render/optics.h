// SPDX-License-Identifier: Apache-2.0
//
// The laws that pictures are compared with, in double precision: Snell's and Fresnel's (Hecht, Optics,
// sections 4.4 and 4.6).
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

namespace snell::test {

using glm::dvec3;

// Reflectance for unpolarised light where the index of refraction grows by the factor eta; 1 where the
// reflection is total.
inline double Fresnel(double cosIncident, double eta) {
  const double sin2 = (1 - cosIncident * cosIncident) / (eta * eta);
  if (sin2 >= 1) return 1;
  const double cosRefracted = std::sqrt(1 - sin2);
  const double s = (cosIncident - eta * cosRefracted) / (cosIncident + eta * cosRefracted);
  const double p = (eta * cosIncident - cosRefracted) / (eta * cosIncident + cosRefracted);
  return (s * s + p * p) / 2;
}

// The angle behind the boundary, in radians.
inline double Refracted(double incident, double eta) { return std::asin(std::sin(incident) / eta); }

// The direction d mirrored at the plane with the unit normal n.
inline dvec3 Mirrored(dvec3 d, dvec3 n) { return d - n * (2 * glm::dot(d, n)); }

// Radiance of the environment `bottom = 0, top = 1` in a direction of unit length: a picture of it shows
// where rays go.
inline constexpr const char* DirectionMeter = "[environment]\nbottom = 0\ntop = 1\n";
inline double MeterReading(dvec3 d) { return (d.y + 1) / 2; }

}  // namespace snell::test
