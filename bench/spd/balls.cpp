// SPDX-License-Identifier: Apache-2.0
//
// "balls", the sphereflake: nine spheres of a third of the radius touch each sphere: six around its waist,
// three above, seen along the direction that it grew in. The facts are those of SPD 3.14's balls.
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>

#include "spd/generators.h"
#include "spd/nff_writer.h"

namespace snell::spd {
namespace {

constexpr double Shrink = 1.0 / 3;

dvec3 Rotated(dvec3 v, double radians, dvec3 axis) {
  return dvec3(glm::rotate(glm::dmat4(1.0), radians, axis) * glm::dvec4(v, 0.0));
}

// The directions of the nine children of a sphere that grew along +z: three neighbouring edges' directions
// of a cube, tilted so that the cube's diagonal is the axis, in three places around it.
std::array<dvec3, 9> ChildDirections() {
  const double d = std::numbers::sqrt2 / 2;
  const dvec3 trio[3] = {{d, d, 0}, {d, 0, -d}, {0, d, -d}};
  const double tilt = std::asin(2 / std::sqrt(6.0));
  std::array<dvec3, 9> directions;
  for (std::size_t i = 0; i < 9; ++i) {
    const dvec3 tilted = Rotated(trio[i % 3], tilt, dvec3(1, -1, 0));
    directions[i] = Rotated(tilted, double(i / 3) * 2 * std::numbers::pi / 3, dvec3(0, 0, 1));
  }
  return directions;
}

// Turn +z into `direction` on the shortest way.
dvec3 Aligned(dvec3 v, dvec3 direction) {
  const dvec3 z(0, 0, 1);
  if (direction.z >= 0.9999) return v;
  if (direction.z <= -0.9999) return Rotated(v, std::numbers::pi, dvec3(0, 1, 0));
  return Rotated(v, std::acos(direction.z), glm::cross(z, direction));
}

void Grow(NffWriter& writer, const std::array<dvec3, 9>& children, int levels, dvec3 center,
          double radius, dvec3 direction) {
  writer.AddSphere(center, radius);
  if (levels == 0) return;
  for (const dvec3& child : children) {
    const dvec3 outward = Aligned(child, direction);
    const dvec3 place = center + outward * (radius * (1 + Shrink));
    Grow(writer, children, levels - 1, place, radius * Shrink, outward);
  }
}

}  // namespace

std::string Balls(int size) {
  const View view = {{2.1, 1.3, 1.7}, {0, 0, 0}, {0, 0, 1}, 0.01};
  NffWriter writer("balls", size, view, {{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}});

  writer.SetFill({.color = {1, 0.75, 0.33}, .diffuse = 0.8});
  writer.AddPolygon({{12, 12, -0.5}, {-12, 12, -0.5}, {-12, -12, -0.5}, {12, -12, -0.5}});

  writer.SetFill({.color = {1, 0.9, 0.7}, .diffuse = 0.5, .mirror = 0.5, .highlightDegrees = 37});
  Grow(writer, ChildDirections(), size, dvec3(0.0), 0.5, dvec3(0, 0, 1));
  return writer.Finish();
}

}  // namespace snell::spd
