// SPDX-License-Identifier: Apache-2.0
#include "rays/brute_force.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "support/transforms.h"

namespace snell::bench {

using glm::dvec3;

namespace {

// Single precision may displace a triangle by so much of its distance: 16 roundings.
constexpr double Rounding = 16 * 0x1p-24;

// A bound of the length.
double Reach(dvec3 v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

bool Truth::Allows(float t) const {
  const bool covered = std::ranges::any_of(
      candidates, [t](const Candidate& c) { return c.lower <= double(t) && double(t) <= c.upper; });
  const bool missed = std::ranges::any_of(
      candidates, [t](const Candidate& c) { return c.certain && c.upper < double(t); });
  return (covered || std::isinf(t)) && !missed;
}

BruteForce::BruteForce(const Scene& scene) : scene_(scene) {
  dvec3 lower(std::numeric_limits<double>::infinity()), upper = -lower;
  for (const vec3& p : scene.positions) {
    lower = glm::min(lower, dvec3(p));
    upper = glm::max(upper, dvec3(p));
  }
  center_ = (lower + upper) * 0.5;
  for (const vec3& p : scene.positions)
    radius_ = std::max(radius_, glm::distance(center_, dvec3(p)));
}

Truth BruteForce::Trace(const Query& query) const {
  Truth truth;
  const dvec3 o(query.ray.o), d(query.ray.d);
  if (scene_.placements.empty()) TestMesh(o, d, double(query.tMax), 0, truth);
  for (const kernel::Transform& placement : scene_.placements) {
    // Mapping the ray rounds in proportion to its distance
    const dvec3 localO = test::ExactToLocal(placement, o);
    const dvec3 localD = test::ExactToLocalVector(placement, d);
    const double blur = Rounding * Reach(localO);
    const dvec3 toCenter = center_ - localO;
    const double distance = glm::length(glm::cross(toCenter, localD)) / glm::length(localD);
    if (distance <= radius_ + blur) TestMesh(localO, localD, double(query.tMax), blur, truth);
  }
  return truth;
}

void BruteForce::TestMesh(dvec3 o, dvec3 d, double tMax, double blur, Truth& truth) const {
  const double length = glm::length(d);
  d /= length;
  for (const kernel::Triangle& triangle : scene_.triangles) {
    const dvec3 corner(scene_.positions[triangle.v0]);
    const dvec3 a = corner - o;
    const dvec3 e1 = dvec3(scene_.positions[triangle.v1]) - corner;
    const dvec3 e2 = dvec3(scene_.positions[triangle.v2]) - corner;

    // Areas of the parts into which the ray divides the triangle
    const dvec3 p = glm::cross(d, e2), q = glm::cross(e1, a);
    const double signedArea = glm::dot(e1, p), area = std::abs(signedArea);
    const double sign = signedArea < 0 ? -1 : 1;
    const double u = -sign * glm::dot(a, p), v = sign * glm::dot(d, q);
    const double least = std::min({u, v, area - u - v});

    // How much of the least area may be due to displacement
    const double size = Reach(e1) + Reach(e2);
    const double offset = Rounding * (Reach(a) + size) + blur;
    const double slack = offset * size;
    if (least < -slack) continue;

    const double t = glm::dot(e2, q) / signedArea;
    if (least >= 0 && area > 0 && t > 0 && t <= tMax * length)
      truth.nearest = std::min(truth.nearest, t / length);

    // The steeper the triangle, the more does displacement change t, but not beyond the triangle's ends
    const double z0 = glm::dot(a, d), z1 = z0 + glm::dot(e1, d), z2 = z0 + glm::dot(e2, d);
    double lower = std::min({z0, z1, z2}) - offset, upper = std::max({z0, z1, z2}) + offset;
    if (area > 0) {
      const double error = offset * (1 + glm::length(glm::cross(e1, e2)) / area);
      lower = std::max(lower, t - error);
      upper = std::min(upper, t + error);
    }
    if (upper <= 0 || lower > tMax * length) continue;
    const bool certain = least > slack && lower > 0 && upper <= tMax * length;
    truth.candidates.push_back({lower / length, upper / length, certain});
  }
}

}  // namespace snell::bench
