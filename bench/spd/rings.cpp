// SPDX-License-Identifier: Apache-2.0
//
// "rings": six pentagonal rings of cylinders join the middles of a dodecahedron's edges; such bodies are
// heaped up as a pyramid that is seen along its axis, before a wall. The facts are those of SPD 3.14's rings.
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>

#include "spd/generators.h"
#include "spd/nff_writer.h"

namespace snell::spd {
namespace {

using std::numbers::pi;

// Rings with their corners on the unit sphere touch at this radius. The corners are then drawn nearer to the
// centre, the tubes stay as they are, so that they cross a little.
constexpr double TubeRadius = 0.07412;

// Five corners for each of six rings, on a sphere around the origin.
std::array<dvec3, 30> RingCorners() {
  const double scale = 1 / (1 + TubeRadius);
  const double tilt = 2 * std::acos(std::cos(pi / 3) / std::sin(pi / 5));  // between adjacent faces
  std::array<dvec3, 30> corners;
  for (int ring = 0; ring < 6; ++ring) {
    // The first ring lies flat, five more lean around it
    glm::dmat4 place(1.0);
    if (ring > 0) {
      place = glm::rotate(place, pi * (2 * ring - 1) / 5, dvec3(0, 0, 1));
      place = glm::rotate(place, tilt, dvec3(1, 0, 0));
    }
    for (int i = 0; i < 5; ++i) {
      const double angle = i * 2 * pi / 5;
      const glm::dvec4 corner(scale * std::cos(angle), scale * std::sin(angle), 0.0, 0.0);
      corners[std::size_t(5 * ring + i)] = dvec3(place * corner);
    }
  }
  return corners;
}

void AddBody(NffWriter& writer, const std::array<dvec3, 30>& corners, dvec3 center) {
  static constexpr dvec3 Colors[6] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                      {0, 1, 1}, {1, 0, 1}, {1, 1, 0}};
  for (std::size_t ring = 0; ring < 6; ++ring) {
    writer.SetFill(
        {.color = Colors[ring], .diffuse = 0.5, .mirror = 0.2, .highlightDegrees = 37, .ior = 0});
    for (std::size_t i = 0; i < 5; ++i) {
      const dvec3 corner = center + corners[5 * ring + i];
      const dvec3 before = center + corners[5 * ring + (i + 4) % 5];
      writer.AddCone(corner, TubeRadius, before, TubeRadius);
      writer.AddSphere(corner, TubeRadius);
    }
  }
}

}  // namespace

std::string Rings(int size) {
  const double spread =
      1 / std::sin(pi / 8);  // between layers, so that a view of 45° just holds them
  const dvec3 from(-1, -spread, 0.5);
  NffWriter writer("rings", size, {from, from + dvec3(0, 1, 0), {0, 0, 1}, 1},
                   {{3, -spread, 3}, {-4, -spread, 1}, {2, -spread, -4}});

  // A wall behind, one percent larger than the view
  const double y = spread * (size + 1);
  const double half = 1.01 * (y - from.y) * std::tan(pi / 8);
  writer.SetFill({.color = {1, 1, 1}, .diffuse = 1, .ior = 0});
  writer.AddPolygon({{from.x + half, y, from.z + half},
                     {from.x - half, y, from.z + half},
                     {from.x - half, y, from.z - half},
                     {from.x + half, y, from.z - half}});

  const std::array<dvec3, 30> corners = RingCorners();
  for (int layer = 0; layer < size; ++layer)
    for (int row = 0; row <= layer; ++row)
      for (int column = 0; column <= layer; ++column)
        AddBody(writer, corners, dvec3(2 * column - layer, spread * (layer + 1), 2 * row - layer));
  return writer.Finish();
}

}  // namespace snell::spd
