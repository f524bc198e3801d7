// SPDX-License-Identifier: Apache-2.0
//
// The classic shader terms at geometries with known values, and the energy of their normalized lobes.
#include "kernel/classic.h"

#include <gtest/gtest.h>

#include "support/numeric.h"
#include "support/random.h"

namespace snell::kernel {
namespace {

constexpr double Pi64 = 3.141592653589793;
constexpr double Degree = Pi64 / 180;
const vec3 N(0, 1, 0);

// The direction at an angle from the normal, in the plane of x and y.
vec3 At(double degrees) {
  return {float(std::sin(degrees * Degree)), float(std::cos(degrees * Degree)), 0.0f};
}

TEST(EvalTerm, DiffuseIsLambertsLaw) {
  for (const double degrees : {0.0, 30.0, 45.0, 60.0, 89.0}) {
    for (const double viewer : {0.0, 70.0}) {
      EXPECT_NEAR(double(EvalTerm(TERM_DIFFUSE, false, 0, N, At(viewer), At(degrees))),
                  std::cos(degrees * Degree) / Pi64, 1e-7);
    }
  }
  EXPECT_EQ(EvalTerm(TERM_DIFFUSE, false, 0, N, At(0), At(90.1)), 0.0f);
  EXPECT_EQ(EvalTerm(TERM_DIFFUSE, false, 0, N, At(0), At(180)), 0.0f);
}

TEST(EvalTerm, PhongIsAPowerOfTheMirrorAngle) {
  // Light at 30°: its mirror direction is at −30°, a viewer at −30° − α sees cosⁿ α
  for (const float exponent : {1.0f, 10.0f, 50.0f, 1000.0f}) {
    for (const double alpha : {0.0, 5.0, 20.0, 60.0}) {
      const double expected = std::pow(std::cos(alpha * Degree), double(exponent)) / Pi64;
      EXPECT_NEAR(double(EvalTerm(TERM_PHONG, false, exponent, N, At(-30 + alpha), At(30))),
                  expected, 1e-4 * expected + 1e-9);
      EXPECT_NEAR(double(EvalTerm(TERM_PHONG, true, exponent, N, At(-30 + alpha), At(30))),
                  expected * (double(exponent) + 2) / 2 * std::cos(30 * Degree),
                  1e-4 * expected * double(exponent) + 1e-9);
    }
  }
  EXPECT_EQ(EvalTerm(TERM_PHONG, false, 10, N, At(80), At(60)), 0.0f);  // 140° from the mirror
}

TEST(EvalTerm, BlinnIsAPowerOfTheHalfAngle) {
  for (const float exponent : {1.0f, 10.0f, 200.0f}) {
    for (const double alpha : {0.0, 10.0, 40.0}) {
      const double expected = std::pow(std::cos(alpha / 2 * Degree), double(exponent)) / Pi64;
      EXPECT_NEAR(double(EvalTerm(TERM_BLINN, false, exponent, N, At(-30 + alpha), At(30))),
                  expected, 1e-4 * expected);
    }
  }
}

TEST(EvalTerm, IsSymmetricAndNothingFromBelow) {
  test::Random random(71);
  for (int i = 0; i < 100000; ++i) {
    const vec3 n(random.Direction());
    const vec3 wo(random.DirectionAbove(glm::dvec3(n)));
    const vec3 wi(random.Direction());
    for (const uint kind : {TERM_DIFFUSE, TERM_PHONG, TERM_BLINN}) {
      const float f = EvalTerm(kind, false, 20, n, wo, wi);
      ASSERT_TRUE(f >= 0 && f <= InvPi * 1.00001f);
      if (Dot(n, wi) <= 0) {
        ASSERT_EQ(f, 0.0f);
      }
      // The lobes themselves do not change when light and viewer change places
      if (Dot(n, wi) > 0.01f && Dot(n, wo) > 0.01f && kind != TERM_DIFFUSE) {
        ASSERT_NEAR(f, EvalTerm(kind, false, 20, n, wi, wo), 3e-6f);
      }
    }
  }
}

// What share of the light from all directions, or towards all directions, a term sends to wo.
double Albedo(uint kind, float exponent, vec3 wo) {
  return test::Integrate(0, 1, 400, [&](double t) {
    // Even steps of the angle near the mirror direction would be better still; squares do
    const double theta = t * Pi64 / 2;
    return test::Integrate(0, Pi64, 40, [&](double phi) {
      const vec3 wi(float(std::sin(theta) * std::cos(phi)), float(std::cos(theta)),
                    float(std::sin(theta) * std::sin(phi)));
      return Pi64 * std::sin(theta) * double(EvalTerm(kind, true, exponent, N, wo, wi));
    });
  });
}

TEST(EvalTerm, NormalizedLobesConserveEnergy) {
  for (const uint kind : {TERM_PHONG, TERM_BLINN}) {
    for (const float exponent : {0.0f, 1.0f, 8.0f, 32.0f, 300.0f}) {
      for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        EXPECT_LE(Albedo(kind, exponent, At(degrees)), 1 + 1e-3)
            << kind << ", exponent " << exponent << ", " << degrees << "°";
      }
      EXPECT_NEAR(Albedo(kind, exponent, At(0)), 1, 1e-3) << kind << ", exponent " << exponent;
    }
  }
}

TEST(EvalTerm, LambertsAlbedoIsOne) { EXPECT_NEAR(Albedo(TERM_DIFFUSE, 0, At(50)), 1, 1e-6); }

}  // namespace
}  // namespace snell::kernel
