// SPDX-License-Identifier: Apache-2.0
//
// The solid angle against that of two triangles (van Oosterom and Strackee 1983), and samples' uniformity over it.
#include "kernel/spherical_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/light.h"
#include "kernel/sobol.h"
#include "support/polygon_light.h"
#include "support/random.h"

namespace snell::kernel {
namespace {

double TriangleSolidAngle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double numerator = glm::dot(a, glm::cross(b, c));
  return 2 * std::atan2(numerator, la * lb * lc + glm::dot(a, b) * lc + glm::dot(a, c) * lb +
                                       glm::dot(b, c) * la);
}
double SolidAngle(glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v) {
  return std::abs(TriangleSolidAngle(corner, corner + u, corner + u + v) +
                  TriangleSolidAngle(corner, corner + u + v, corner + v));
}

struct Rectangle {
  glm::dvec3 corner, u, v;  // as seen from the origin
};

Rectangle RandomRectangle(test::Random& random, bool close) {
  const glm::dvec3 u = random.InCube(), v = glm::cross(u, random.InCube());
  if (!close) return {random.InCube() * 3.0, u, v};
  const glm::dvec3 above = glm::normalize(glm::cross(u, v)) * random.LogUniform(1e-2, 0.1);
  return {above - u * random.Uniform() - v * random.Uniform(), u, v};
}

TEST(SphericalRectangle, HasItsSolidAngle) {
  test::Random random(211);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const Rectangle r = RandomRectangle(random, i % 3 == 0);
    const double expected = SolidAngle(r.corner, r.u, r.v);
    const SphericalRectangle seen =
        SphericalRectangleAt(vec3(0.0f), vec3(r.corner), vec3(r.u), vec3(r.v));
    if (seen.solidAngle == 0.0f) {
      EXPECT_LT(expected, 1.001 * double(LeastSphericalRectangle));
      continue;
    }
    ++found;
    EXPECT_NEAR(double(seen.solidAngle) / expected, 1, 1e-3);
  }
  EXPECT_GT(found, 9000);
}

TEST(SphericalRectangle, SamplesItsSolidAngleEvenly) {
  test::Random random(212);
  for (int i = 0; i < 30; ++i) {
    const Rectangle r = RandomRectangle(random, i % 2 == 0);
    const SphericalRectangle seen =
        SphericalRectangleAt(vec3(0.0f), vec3(r.corner), vec3(r.u), vec3(r.v));
    if (seen.solidAngle == 0.0f) continue;
    // Shares of the samples in a grid of parts, by the parts' own solid angles
    constexpr int Cells = 4;
    constexpr uint Samples = 1u << 14;
    int counts[Cells][Cells] = {};
    for (uint s = 0; s < Samples; ++s) {
      const glm::dvec3 point(SampleSphericalRectangle(seen, Sobol2D(s, 0x77u)));
      const double u = glm::dot(point - r.corner, r.u) / glm::dot(r.u, r.u);
      const double v = glm::dot(point - r.corner, r.v) / glm::dot(r.v, r.v);
      ASSERT_GT(std::min(u, v), -1e-4);
      ASSERT_LT(std::max(u, v), 1.0001);
      ++counts[std::clamp(int(u * Cells), 0, Cells - 1)][std::clamp(int(v * Cells), 0, Cells - 1)];
    }
    for (int a = 0; a < Cells; ++a)
      for (int b = 0; b < Cells; ++b) {
        const double share =
            SolidAngle(r.corner + r.u * (double(a) / Cells) + r.v * (double(b) / Cells),
                       r.u / double(Cells), r.v / double(Cells)) /
            SolidAngle(r.corner, r.u, r.v);
        EXPECT_NEAR(double(counts[a][b]) / Samples, share, 3e-3) << i;
      }
  }
}

// A lamp that is near gives its irradiance, and samples have the density that is claimed.
TEST(SphericalRectangle, MakesLampsObeyLambertsFormula) {
  test::Random random(213);
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 u(random.Uniform() + 0.2, 0, 0), v(0, 0, random.Uniform() + 0.2);
    const glm::dvec3 corner(-random.Uniform(), 0.05 + 0.5 * random.Uniform(), -random.Uniform());
    Light light = {};
    light.kind = LIGHT_RECTANGLE;
    light.falloff = FALLOFF_INVERSE_SQUARE;
    light.emission = Spectrum(1.0f);
    light.position = vec3(corner);
    light.edgeU = vec3(u);
    light.edgeV = vec3(v);
    light.direction = vec3(0, -1, 0);
    light.area = float(u.x * v.z);
    const glm::dvec3 n(0, 1, 0);
    double sum = 0;
    constexpr uint Samples = 1u << 12;
    for (uint s = 0; s < Samples; ++s) {
      const LightLiSample li = SampleLi(light, vec3(0.0f), Sobol2D(s, 0x52u));
      sum += double(li.irradiance.x) * glm::dot(glm::dvec3(li.wi), n);
      EXPECT_NEAR(double(li.irradiance.x * PdfLi(light, vec3(0.0f), li.wi, li.distance)), 1, 2e-2);
    }
    const double expected = std::abs(
        test::PolygonIrradiance({0, 0, 0}, n, {corner, corner + u, corner + u + v, corner + v}));
    EXPECT_NEAR(sum / Samples / expected, 1, 2e-3) << i;
  }
}

}  // namespace
}  // namespace snell::kernel
