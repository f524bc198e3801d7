// SPDX-License-Identifier: Apache-2.0
//
// Affine maps for tests: random ones of several kinds, the kernel's form of a matrix (independent of the
// flattening that devices use), and the kernel's maps applied in double precision.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "kernel/transform.h"
#include "support/random.h"

namespace snell::test {

inline kernel::Transform ToKernel(const glm::dmat4& m) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(m));
  kernel::Transform t;
  t.x = kernel::vec3(m[0]);
  t.y = kernel::vec3(m[1]);
  t.z = kernel::vec3(m[2]);
  t.origin = kernel::vec3(m[3]);
  t.rowX = kernel::vec3(inverse[0][0], inverse[1][0], inverse[2][0]);
  t.rowY = kernel::vec3(inverse[0][1], inverse[1][1], inverse[2][1]);
  t.rowZ = kernel::vec3(inverse[0][2], inverse[1][2], inverse[2][2]);
  return t;
}

// What kind of map: each is also rotated and moved.
enum class MapKind { Rigid, Mirrored, NonUniform, Sheared };
inline constexpr MapKind MapKinds[] = {MapKind::Rigid, MapKind::Mirrored, MapKind::NonUniform,
                                       MapKind::Sheared};

// A map of about the given scale whose origin lies up to `distance` scales from the world's.
inline glm::dmat4 RandomMap(Random& random, MapKind kind, double scale, double distance) {
  glm::dmat4 m(1.0);
  m = glm::translate(m, random.InCube() * (distance * scale));
  m = glm::rotate(m, random.Uniform(0, 6.28), random.Direction());
  glm::dvec3 factors(scale);
  if (kind == MapKind::Mirrored) factors.x = -factors.x;
  if (kind == MapKind::NonUniform || kind == MapKind::Sheared) {
    factors *= glm::dvec3(random.LogUniform(0.1, 10), random.LogUniform(0.1, 10),
                          random.LogUniform(0.1, 10));
  }
  m = glm::scale(m, factors);
  if (kind == MapKind::Sheared) {
    glm::dmat4 shear(1.0);
    shear[1][0] = random.Uniform(-1, 1);
    shear[2][1] = random.Uniform(-1, 1);
    m = m * glm::rotate(glm::dmat4(1.0), random.Uniform(0, 6.28), random.Direction()) * shear;
  }
  return m;
}

// The maps of the kernel's records without rounding.
inline glm::dvec3 ExactToWorld(const kernel::Transform& m, glm::dvec3 p) {
  return glm::dvec3(m.x) * p.x + glm::dvec3(m.y) * p.y + glm::dvec3(m.z) * p.z +
         glm::dvec3(m.origin);
}
inline glm::dvec3 ExactToLocalVector(const kernel::Transform& m, glm::dvec3 v) {
  return {glm::dot(glm::dvec3(m.rowX), v), glm::dot(glm::dvec3(m.rowY), v),
          glm::dot(glm::dvec3(m.rowZ), v)};
}
inline glm::dvec3 ExactToLocal(const kernel::Transform& m, glm::dvec3 p) {
  return ExactToLocalVector(m, p - glm::dvec3(m.origin));
}

// How unevenly the map stretches: 1 for similarities, about the ratio of the largest to the smallest stretch.
inline double Stretch(const kernel::Transform& m) {
  const auto squares = [](kernel::vec3 a, kernel::vec3 b, kernel::vec3 c) {
    const glm::dvec3 x(a), y(b), z(c);
    return glm::dot(x, x) + glm::dot(y, y) + glm::dot(z, z);
  };
  return std::sqrt(squares(m.x, m.y, m.z) * squares(m.rowX, m.rowY, m.rowZ)) / 3;
}

}  // namespace snell::test
