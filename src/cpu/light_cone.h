// SPDX-License-Identifier: Apache-2.0
//
// Bounds of where sources of light shine: a cone around their normals, and how far from its normal each still shines
// (Conty Estevez and Kulla 2018, section 4.1).
#pragma once

#include <glm/vec3.hpp>

namespace snell::cpu {

struct LightCone {
  glm::dvec3 axis{0, 0, 1};  // unit
  double thetaO = 0;         // half angle around the normals; π: any
  double thetaE = 0;         // from a normal, at most π/2
  bool twoSided = false;     // the opposite normals count, too

  // The cone around both. Of two-sided sources the side does not matter.
  static LightCone Union(const LightCone& a, const LightCone& b);
  // The directions that it covers, weighted by the cosines of the angles beyond thetaO: the measure M_Ω, steradians.
  double Measure() const;
};

}  // namespace snell::cpu
