// SPDX-License-Identifier: Apache-2.0
#include "image/chromaticity.h"

#include <cmath>
#include <glm/matrix.hpp>

namespace snell::image {

// The colour with the given chromaticity and Y = 1.
static glm::dvec3 XyzOf(const glm::dvec2& xy) {
  return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y};
}

// Columns are the primaries at Y = 1.
static glm::dmat3 UnscaledPrimaries(const Chromaticities& space) {
  return glm::dmat3(XyzOf(space.red), XyzOf(space.green), XyzOf(space.blue));
}

bool IsUsable(const Chromaticities& space) {
  for (const glm::dvec2& xy : {space.red, space.green, space.blue, space.white})
    if (!(std::fabs(xy.x) < 10) || !(std::fabs(xy.y) < 10) || std::fabs(xy.y) < 1e-6) return false;
  if (!(std::fabs(glm::determinant(UnscaledPrimaries(space))) > 1e-9)) return false;

  // White must be a mixture of all three primaries
  const glm::dvec3 scale = glm::inverse(UnscaledPrimaries(space)) * XyzOf(space.white);
  return std::fabs(scale.x) > 1e-9 && std::fabs(scale.y) > 1e-9 && std::fabs(scale.z) > 1e-9;
}

glm::dmat3 RgbToXyz(const Chromaticities& space) {
  const glm::dmat3 primaries = UnscaledPrimaries(space);
  const glm::dvec3 scale = glm::inverse(primaries) * XyzOf(space.white);
  return glm::dmat3(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z);
}

// The matrix that takes XYZ under one white to XYZ under another, by scaling cone responses.
static glm::dmat3 Adaptation(const glm::dvec2& from, const glm::dvec2& to) {
  const glm::dmat3 bradford(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367,
                            1.0296);
  const glm::dvec3 ratio = (bradford * XyzOf(to)) / (bradford * XyzOf(from));
  const glm::dmat3 scaling(ratio.x, 0, 0, 0, ratio.y, 0, 0, 0, ratio.z);
  return glm::inverse(bradford) * scaling * bradford;
}

glm::dmat3 XyzToRec709(const glm::dvec2& white) {
  const Chromaticities rec709;
  return glm::inverse(RgbToXyz(rec709)) * Adaptation(white, rec709.white);
}

glm::dmat3 ToRec709(const Chromaticities& space) {
  return XyzToRec709(space.white) * RgbToXyz(space);
}

void Transform(const glm::dmat3& matrix, std::vector<vec3>& pixels) {
  const glm::mat3 m(matrix);
  for (vec3& pixel : pixels) pixel = m * pixel;
}

// Equal within the rounding of chromaticities that are written with four digits.
static bool Near(const glm::dvec2& a, const glm::dvec2& b) {
  return std::fabs(a.x - b.x) < 1e-4 && std::fabs(a.y - b.y) < 1e-4;
}

void ConvertToRec709(const Chromaticities& space, std::vector<vec3>& pixels) {
  const Chromaticities rec709;
  const bool same = Near(space.red, rec709.red) && Near(space.green, rec709.green) &&
                    Near(space.blue, rec709.blue) && Near(space.white, rec709.white);
  if (!same && IsUsable(space)) Transform(ToRec709(space), pixels);
}

}  // namespace snell::image
