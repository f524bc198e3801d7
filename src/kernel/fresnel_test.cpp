// SPDX-License-Identifier: Apache-2.0
//
// Reflection, refraction and Fresnel's equations against textbook values and against the equations in
// complex numbers.
#include "kernel/fresnel.h"

#include <gtest/gtest.h>

#include <complex>

#include "support/random.h"

namespace snell::kernel {
namespace {

constexpr double Degree = 3.141592653589793 / 180;

float Reflectance(double angle, double eta) {
  const float cosIncident = float(std::cos(angle));
  return FrDielectric(cosIncident, RefractedCosine(cosIncident, float(eta)), float(eta));
}

struct Amplitudes {
  std::complex<double> perpendicular;
  std::complex<double> parallel;
};

// Fresnel's amplitudes from the complex angle of refraction, by sines and tangents instead of cosines.
Amplitudes ExactAmplitudes(double angle, double eta) {
  const std::complex<double> refracted = std::asin(std::complex<double>(std::sin(angle) / eta));
  const std::complex<double> incident = angle;
  return {-std::sin(incident - refracted) / std::sin(incident + refracted),
          std::tan(incident - refracted) / std::tan(incident + refracted)};
}
double ExactReflectance(double angle, double eta) {
  const Amplitudes a = ExactAmplitudes(angle, eta);
  return 0.5 * (std::norm(a.perpendicular) + std::norm(a.parallel));
}

TEST(FrDielectric, EqualsTheComplexEquations) {
  for (const double eta : {1.0001, 1.1, 1.33, 1.5, 2.417, 4.0, 1 / 1.33, 1 / 1.5, 1 / 2.417}) {
    for (double degrees = 0.5; degrees < 89.9; degrees += 0.5) {
      const double angle = degrees * Degree;
      // Near the critical angle the slope is infinite
      if (std::abs(std::sin(angle) / eta - 1) < 1e-3) continue;
      EXPECT_NEAR(double(Reflectance(angle, eta)), ExactReflectance(angle, eta), 3e-6)
          << eta << " at " << degrees;
    }
  }
}

TEST(FrDielectric, HasItsValueAtNormalIncidence) {
  for (const double eta : {1.0, 1.33, 1.5, 2.417, 1 / 1.5}) {
    const double r = (eta - 1) / (eta + 1);
    EXPECT_NEAR(double(Reflectance(0, eta)), r * r, 1e-7);
  }
  EXPECT_FLOAT_EQ(Reflectance(0, 1.5), 0.04f);
  // Values for crown glass as textbooks tabulate them
  EXPECT_NEAR(Reflectance(30 * Degree, 1.5), 0.0415f, 1e-4f);
  EXPECT_NEAR(Reflectance(60 * Degree, 1.5), 0.0892f, 1e-4f);
  EXPECT_NEAR(Reflectance(80 * Degree, 1.5), 0.3877f, 1e-4f);
}

TEST(FrDielectric, LosesTheParallelPartAtBrewstersAngle) {
  for (const double eta : {1.33, 1.5, 2.417, 1 / 1.5}) {
    // All that is reflected is perpendicular: ((η² − 1) / (η² + 1))², half of it unpolarised
    const double brewster = std::atan(eta);
    const double r = (eta * eta - 1) / (eta * eta + 1);
    EXPECT_NEAR(double(Reflectance(brewster, eta)), 0.5 * r * r, 1e-6);
  }
}

TEST(FrDielectric, IsOneAtGrazingAndBeyondTheCriticalAngle) {
  EXPECT_NEAR(Reflectance(90 * Degree, 1.5), 1.0f, 1e-6f);
  EXPECT_EQ(FrDielectric(0.0f, RefractedCosine(0.0f, 1.5f), 1.5f), 1.0f);
  const double critical = std::asin(1 / 1.5);
  EXPECT_LT(Reflectance(critical - 1e-3, 1 / 1.5), 0.9f);
  for (const double beyond : {1e-5, 1e-3, 0.1, 0.5})
    EXPECT_EQ(Reflectance(critical + beyond, 1 / 1.5), 1.0f);
  EXPECT_EQ(Reflectance(90 * Degree, 1 / 1.5), 1.0f);
}

TEST(FrDielectric, IsTheSameFromBothSides) {
  // F at an angle of incidence equals F at its angle of refraction from the other side
  test::Random random(51);
  for (int i = 0; i < 100000; ++i) {
    const float eta = float(random.Uniform(1.01, 3));
    const float cosIncident = random.UniformFloat();
    const float cosRefracted = RefractedCosine(cosIncident, eta);
    const float back = RefractedCosine(cosRefracted, 1.0f / eta);
    // Near grazing incidence the way back falls off the edge of total reflection
    if (cosIncident < 0.05f) continue;
    EXPECT_NEAR(back, cosIncident, 1e-4f);
    EXPECT_NEAR(FrDielectric(cosIncident, cosRefracted, eta),
                FrDielectric(cosRefracted, back, 1.0f / eta), 2e-4f);
  }
}

TEST(FrDielectric, LiesBetweenZeroAndOne) {
  test::Random random(52);
  for (int i = 0; i < 500000; ++i) {
    const float eta = float(random.LogUniform(0.2, 5));
    const float cosIncident =
        random.Chance(0.1) ? float(random.LogUniform(1e-8, 1)) : random.UniformFloat();
    const float f = FrDielectric(cosIncident, RefractedCosine(cosIncident, eta), eta);
    ASSERT_TRUE(f >= 0 && f <= 1.000001f) << cosIncident << " " << eta;
  }
  // No boundary, no reflection
  for (int i = 1; i <= 10; ++i) {
    const float c = float(i) / 10;
    EXPECT_NEAR(FrDielectric(c, RefractedCosine(c, 1.0f), 1.0f), 0.0f, 1e-9f);
  }
}

TEST(RefractedCosine, ObeysSnellsLaw) {
  for (const double eta : {1.33, 1.5, 2.417, 1 / 1.33, 1 / 1.5}) {
    for (double degrees = 0; degrees < 90; degrees += 0.25) {
      const double sine = std::sin(degrees * Degree) / eta;
      const float cosRefracted = RefractedCosine(float(std::cos(degrees * Degree)), float(eta));
      if (sine > 1 + 1e-6) {
        EXPECT_LT(cosRefracted, 0.0f);
      }
      if (sine < 1 - 1e-3) {
        EXPECT_NEAR(double(cosRefracted), std::sqrt(1 - sine * sine), 1e-5);
      }
    }
  }
  // 30° into glass: asin(sin 30° / 1.5) = 19.4712°
  EXPECT_NEAR(std::acos(RefractedCosine(std::cos(0.5235988f), 1.5f)) / float(Degree), 19.4712f,
              1e-3f);
}

TEST(Refract, BendsInThePlaneOfIncidence) {
  test::Random random(53);
  for (int i = 0; i < 200000; ++i) {
    const glm::dvec3 n = random.Direction();
    glm::dvec3 d = random.Direction();
    if (glm::dot(d, n) > 0) d = -d;
    const double eta = random.LogUniform(0.4, 2.5);
    const double cosIncident = -glm::dot(d, n);
    const float cosRefracted = RefractedCosine(float(cosIncident), float(eta));
    if (cosRefracted < 0.03f) continue;
    const glm::dvec3 t(Refract(vec3(d), vec3(n), float(cosIncident), cosRefracted, float(eta)));

    // Unit length, on the far side, in the plane of d and n, sines in the ratio of the indices
    EXPECT_NEAR(glm::length(t), 1, 1e-5);
    EXPECT_LT(glm::dot(t, n), 0);
    EXPECT_NEAR(glm::dot(t, glm::cross(d, n)), 0, 2e-6);
    EXPECT_NEAR(glm::length(glm::cross(t, n)) * eta, glm::length(glm::cross(d, n)), 1e-5);
    EXPECT_GT(glm::dot(t - n * glm::dot(t, n), d - n * glm::dot(d, n)), -1e-6);
  }
}

TEST(Refract, GoesStraightOnWithoutABoundary) {
  const vec3 d = Normalize(vec3(0.3f, -0.8f, 0.1f));
  const vec3 n(0, 1, 0);
  const vec3 t = Refract(d, n, -d.y, RefractedCosine(-d.y, 1.0f), 1.0f);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(t[axis], d[axis], 1e-6f);
}

TEST(Reflect, KeepsTheTangentAndTurnsTheNormal) {
  test::Random random(54);
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec3 n = random.Direction();
    const glm::dvec3 d = random.Direction();
    const glm::dvec3 r(Reflect(vec3(d), vec3(n)));
    EXPECT_NEAR(glm::length(r), 1, 1e-6);
    EXPECT_NEAR(glm::dot(r, n), -glm::dot(d, n), 1e-6);
    EXPECT_NEAR(glm::length((r - n * glm::dot(r, n)) - (d - n * glm::dot(d, n))), 0, 1e-6);
    // The same on either side of the surface
    EXPECT_EQ(Reflect(vec3(d), vec3(n)), Reflect(vec3(d), -vec3(n)));
  }
}

TEST(FrSchlick, GoesFromItsValueToOne) {
  const Spectrum f0(0.04f, 0.5f, 1.0f);
  const Spectrum normal = FrSchlick(f0, 1.0f);
  const Spectrum grazing = FrSchlick(f0, 0.0f);
  for (int c = 0; c < 3; ++c) {
    EXPECT_FLOAT_EQ(normal[c], f0[c]);
    EXPECT_FLOAT_EQ(grazing[c], 1.0f);
  }
  EXPECT_FLOAT_EQ(FrSchlick(f0, 0.5f).x, 0.04f + 0.96f / 32);
}

}  // namespace
}  // namespace snell::kernel
