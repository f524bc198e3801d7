// SPDX-License-Identifier: Apache-2.0
//
// Light from polygons of radiance 1 by Lambert's formula (Arvo 1994, "The irradiance Jacobian for partially
// occluded polyhedral sources"), and five triangles over a floor whose radiance is known.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace snell::test {

// Irradiance at p on a surface with the normal n from a polygon that lies wholly above it and whose front,
// where its corners count counter-clockwise, is seen from p.
inline double PolygonIrradiance(glm::dvec3 p, glm::dvec3 n,
                                const std::vector<glm::dvec3>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = glm::normalize(corners[i] - p);
    const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()] - p);
    const glm::dvec3 across = glm::cross(a, b);
    const double sine = glm::length(across);
    if (sine < 1e-12) continue;
    sum -= std::atan2(sine, glm::dot(a, b)) * glm::dot(across, n) / sine;
  }
  return sum / 2;
}

struct TriangleOverFloor {
  std::vector<glm::dvec3> corners;  // in either order
  double radiance;                  // of a matt floor of albedo ½ at the origin, normal +y
};

// The triangles are those of the polygon luminaires in nori's tests (Jakob 2015), the values computed anew.
inline const TriangleOverFloor TrianglesOverFloor[] = {
    {{{-.443432, .596366, .495985}, {-.320397, .0677699, -.229359}, {.0341197, .11415, -.343049}},
     0.0898394},
    {{{.461963, .397843, .412747}, {-.0381582, .851323, -.156872}, {.195443, .891957, -.260672}},
     0.0229200},
    {{{.100871, .289075, -.422609}, {-.308386, .629587, .423966}, {-.373132, .237287, .351592}},
     0.0534198},
    {{{-.17575, .639397, .151268}, {.318604, .732996, .459771}, {.139095, .294498, .478556}},
     0.0205314},
    {{{-.17487, .447916, .367201}, {-.405259, .249607, -.354079}, {.356029, .0918984, -.132271}},
     0.2617400}};

}  // namespace snell::test
