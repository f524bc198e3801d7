// SPDX-License-Identifier: Apache-2.0
//
// The referee: every ray against every triangle in double precision (Möller and Trumbore 1997), with bounds of
// what single precision may make of it.
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "rays/contestant.h"

namespace snell::bench {

// What a ray meets at 0 < t ≤ tMax.
struct Truth {
  // A triangle that the ray hits or passes so closely that rounding may decide.
  struct Candidate {
    double lower, upper;  // of t, by the same rounding
    bool certain;         // whatever the rounding
  };
  double nearest = std::numeric_limits<double>::infinity();  // without any rounding
  std::vector<Candidate> candidates;

  // Whether a nearest hit at t, or none if t is infinite, differs by no more than rounding.
  bool Allows(float t) const;
};

class BruteForce {
 public:
  // The scene must outlive this.
  explicit BruteForce(const Scene& scene);
  Truth Trace(const Query& query) const;

 private:
  void TestMesh(glm::dvec3 o, glm::dvec3 d, double tMax, double blur, Truth& truth) const;

  const Scene& scene_;
  glm::dvec3 center_;  // of a sphere around the mesh
  double radius_ = 0;
};

}  // namespace snell::bench
