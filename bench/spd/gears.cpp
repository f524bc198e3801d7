// SPDX-License-Identifier: Apache-2.0
//
// "gears": a cube of meshed gears over a mirror. The faces of a gear are polygons of 144 corners; one gear in
// five is of glass. The facts are those of SPD 3.14's gears.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "spd/generators.h"
#include "spd/nff_writer.h"

namespace snell::spd {
namespace {

using std::numbers::pi;

constexpr int Teeth = 36;
constexpr std::size_t Corners = 4 * Teeth;
constexpr double ToothDepth = 0.1;    // of the radius
constexpr double OuterRatio = 0.995;  // leaves a gap between meshing gears
constexpr double MostThickness = 0.1;

struct Gear {
  dvec3 center;  // of the upper face
  double radius;
  double angle;
  double thickness;
};

// The upper face, counter-clockwise: two corners on the outside of each tooth, two in the gap after it.
std::array<dvec3, Corners> UpperFace(const Gear& gear) {
  static constexpr double Offsets[4] = {-0.19, 0.19, 0.3, 0.7};  // in teeth
  std::array<dvec3, Corners> face;
  for (std::size_t i = 0; i < Corners; ++i) {
    const double angle = gear.angle + (double(i / 4) + Offsets[i % 4]) * 2 * pi / Teeth;
    const double radius = gear.radius * (i % 4 < 2 ? OuterRatio : 1 - ToothDepth);
    face[i] = gear.center + radius * dvec3(std::cos(angle), std::sin(angle), 0);
  }
  return face;
}

void AddGear(NffWriter& writer, const Gear& gear) {
  const std::array<dvec3, Corners> upper = UpperFace(gear);
  const dvec3 down(0, 0, -gear.thickness);
  writer.AddPolygon(upper);
  for (std::size_t i = 0; i < Corners; ++i) {
    const dvec3 here = upper[i], next = upper[(i + 1) % Corners];
    writer.AddPolygon({here, here + down, next + down, next});
  }

  // The lower face goes round the other way; as above, its first three corners are convex
  std::array<dvec3, Corners> lower;
  for (std::size_t i = 0; i < Corners; ++i) lower[i] = upper[(Corners + 1 - i) % Corners] + down;
  writer.AddPolygon(lower);
}

// One of 7³ colours, made as bright as they go.
dvec3 GearColor(int x, int y, int z) {
  const auto fraction = [](int sevenths) { return 0.01 + (sevenths % 7) / 7.0; };
  const dvec3 color(fraction((3 * x + 2 * y + z + 1) * 5), fraction((3 * y + 2 * z + x + 1) * 3),
                    fraction((3 * z + 2 * x + y + 1) * 2));
  return color / std::max({color.x, color.y, color.z});
}

}  // namespace

std::string Gears(int size) {
  const View view = {{-1.1, -2.1, 2.6}, {0, 0, 0}, {0, 0, 1}, 1};
  NffWriter writer("gears", size, view,
                   {{2, 4, 4}, {-2, 4, 3}, {2, -2.5, 2.5}, {-1, -4, 2}, {-1.111, -2.121, 2.626}});

  writer.SetFill(
      {.color = {1, 0.85, 0.7}, .diffuse = 0.3, .mirror = 0.6, .highlightDegrees = 37, .ior = 0});
  writer.AddPolygon({{2, 2, 0}, {-2, 2, 0}, {-2, -2, 0}, {2, -2, 0}});

  // Gears overlap by half a tooth's depth and fill the square [−1, 1]²
  const double radius = 1 / (size - (size - 1) * ToothDepth / 2);
  const double apart = radius * (2 - ToothDepth);
  const double thickness = std::min(MostThickness, 0.5 / size);
  for (int z = 0; z < size; ++z) {
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const dvec3 color = GearColor(x, y, z);
        if ((4 * x + 2 * y + z) % 5 == 0) {
          writer.SetFill({.color = color, .diffuse = 0.2, .transmittance = 0.8, .ior = 1.1});
        } else {
          writer.SetFill({.color = color, .diffuse = 1, .ior = 0});
        }
        const dvec3 center(radius - 1 + x * apart, radius - 1 + y * apart, 1 - double(z) / size);
        AddGear(writer, {center, radius, (x + y + z) % 2 * pi / Teeth, thickness});
      }
    }
  }
  return writer.Finish();
}

}  // namespace snell::spd
