// SPDX-License-Identifier: Apache-2.0
//
// "tree": branches that fork in two (Aono and Kunii 1984, "Botanical tree image generation"), each an open
// cone with a sphere on its end, in a field. The facts are those of SPD 3.14's tree.
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include "spd/generators.h"
#include "spd/nff_writer.h"

namespace snell::spd {
namespace {

using glm::dmat4;

constexpr double Taper = 0.67;  // of the radius, along a branch and from branch to branch
constexpr double TrunkRadius = 0.15;

// From a branch, which goes from 0 to 1 on the z axis, to the one that grows out of its end: shorter, leaning
// from the axis, turned around it.
dmat4 Fork(double leanDegrees, double turnDegrees, double contraction) {
  dmat4 fork = glm::translate(dmat4(1.0), dvec3(0, 0, 1));
  fork = glm::scale(fork, dvec3(contraction));
  fork = glm::rotate(fork, glm::radians(turnDegrees), dvec3(0, 0, 1));
  return glm::rotate(fork, glm::radians(leanDegrees), dvec3(1, 0, 0));
}

void Grow(NffWriter& writer, const std::array<dmat4, 2>& forks, const dmat4& place, double radius,
          int levels) {
  const dvec3 base(place[3]);
  const dvec3 end(place[3] + place[2]);
  writer.AddCone(base, radius, end, radius * Taper);
  writer.AddSphere(end, radius * Taper);
  if (levels == 0) return;
  for (const dmat4& fork : forks) Grow(writer, forks, place * fork, radius * Taper, levels - 1);
}

}  // namespace

std::string Tree(int size) {
  const View view = {{4.5, 0.4, 2}, {0, 0, 1.5}, {0, 0, 1}, 1};
  NffWriter writer("tree", size, view,
                   {{-5, 5, 50},
                    {30, -30, 30},
                    {-40, -30, 20},
                    {10, 30, 40},
                    {-30, 40, 10},
                    {50, 25, 20},
                    {-10, -60, 30}});

  writer.SetFill({.color = {0.2, 0.7, 0.2}, .diffuse = 1, .ior = 0});
  writer.AddPolygon({{50, 50, 0}, {-50, 50, 0}, {-50, -50, 0}, {50, -50, 0}});

  writer.SetFill({.color = {0.55, 0.4, 0.2}, .diffuse = 1, .ior = 0});
  const std::array<dmat4, 2> forks = {Fork(40, 90, 0.65), Fork(25, 230, 0.70)};
  Grow(writer, forks, dmat4(1.0), TrunkRadius, size);
  return writer.Finish();
}

}  // namespace snell::spd
