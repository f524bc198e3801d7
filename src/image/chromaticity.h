// SPDX-License-Identifier: Apache-2.0
//
// RGB colour spaces by the chromaticities of their primaries and white, for pictures whose file says
// that they are not in Rec.709. White maps to white: different whites are adapted by the linear
// Bradford transform (Lam 1985; Hunt, "The Reproduction of Colour", 6th ed., §35.8).
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "image/image.h"

namespace snell::image {

// CIE 1931 xy coordinates. The defaults are Rec.709's and sRGB's (D65).
struct Chromaticities {
  glm::dvec2 red{0.64, 0.33};
  glm::dvec2 green{0.30, 0.60};
  glm::dvec2 blue{0.15, 0.06};
  glm::dvec2 white{0.3127, 0.3290};
};

// False if no colour space has such chromaticities, as when they are all 0 (files that mean "unknown").
bool IsUsable(const Chromaticities& space);

// Linear RGB of the space to CIE XYZ, with Y = 1 for white. The space must be usable.
glm::dmat3 RgbToXyz(const Chromaticities& space);

// Linear RGB of the space to linear Rec.709, white to white. The space must be usable.
glm::dmat3 ToRec709(const Chromaticities& space);

// CIE XYZ relative to the given white to linear Rec.709.
glm::dmat3 XyzToRec709(const glm::dvec2& white);

// Convert pixels in place; does nothing if the space is unusable or Rec.709 to four digits.
void ConvertToRec709(const Chromaticities& space, std::vector<vec3>& pixels);

// Multiply every pixel by a matrix.
void Transform(const glm::dmat3& matrix, std::vector<vec3>& pixels);

}  // namespace snell::image
