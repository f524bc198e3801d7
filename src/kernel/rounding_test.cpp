// SPDX-License-Identifier: Apache-2.0
//
// What the robustness of intersections stands on: the exact sign of a difference of products, the next
// floats, frames, and ray starts outside their error boxes.
#include <gtest/gtest.h>

#include <limits>

#include "kernel/math.h"
#include "kernel/ray.h"
#include "support/random.h"

namespace snell::kernel {
namespace {

int Sign(long double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

// Products of two floats have 48 digits and fit a double; the sign of their comparison is then exact.
int ExactSign(float a, float b, float c, float d) {
  const double ab = double(a) * double(b);
  const double cd = double(c) * double(d);
  return ab > cd ? 1 : (ab < cd ? -1 : 0);
}

TEST(DifferenceOfProductsSign, IsExactForNearlyEqualProducts) {
  test::Random random(11);
  int undecided = 0;
  for (std::uint64_t i = 0; i < test::Scaled(1000000); ++i) {
    // Make c·d equal a·b up to a few units in the last place
    const float a = float(random.Uniform(1, 2)) * (random.Chance(0.5) ? 1.0f : -1.0f);
    const float b = float(random.LogUniform(1e-6, 1e6));
    const float c = float(random.LogUniform(1e-6, 1e6));
    float d = float(double(a) * double(b) / double(c));
    for (std::uint32_t k = random.Index(3); k > 0; --k)
      d = std::nextafterf(d, random.Chance(0.5) ? 1e30f : -1e30f);
    if (a * b == c * d) ++undecided;
    ASSERT_EQ(DifferenceOfProductsSign(a, b, c, d), float(ExactSign(a, b, c, d)))
        << a << " " << b << " " << c << " " << d;
    ASSERT_EQ(DifferenceOfProductsSign(c, d, a, b), -float(ExactSign(a, b, c, d)));
    ASSERT_EQ(DifferenceOfProductsSign(a, b, a, b), 0.0f);
    ASSERT_EQ(DifferenceOfProductsSign(a, b, b, a), 0.0f);
  }
  EXPECT_GT(undecided, 100000);  // the test asked what rounding cannot tell
}

TEST(DifferenceOfProductsSign, IsExactForIntegers) {
  test::Random random(12);
  for (int i = 0; i < 200000; ++i) {
    const std::int64_t a = random.Index(1u << 24), b = random.Index(1u << 24);
    const std::int64_t c = a + std::int64_t(random.Index(3)) - 1;
    const std::int64_t d = b + std::int64_t(random.Index(3)) - 1;
    const __int128 difference = __int128(a) * b - __int128(c) * d;
    const int sign = difference > 0 ? 1 : (difference < 0 ? -1 : 0);
    ASSERT_EQ(DifferenceOfProductsSign(float(a), float(b), float(c), float(d)), float(sign));
  }
}

TEST(DifferenceOfProductsSign, IsExactAtScenesScales) {
  test::Random random(13);
  for (int i = 0; i < 300000; ++i) {
    const double scale = random.LogUniform(1e-14, 1e14);
    const float a = float(random.Uniform(-scale, scale)), b = float(random.Uniform(-scale, scale));
    float c = std::nextafterf(a, float(random.Uniform(-1, 1)));
    float d = std::nextafterf(b, float(random.Uniform(-1, 1)));
    if (a == 0 || b == 0 || c == 0 || d == 0) continue;
    ASSERT_EQ(DifferenceOfProductsSign(a, b, c, d), float(ExactSign(a, b, c, d)));
  }
}

TEST(ProductError, IsWhatAProductLoses) {
  test::Random random(14);
  for (int i = 0; i < 300000; ++i) {
    const float a = float(random.LogUniform(1e-9, 1e9)), b = float(random.Uniform(-1e9, 1e9));
    const double lost = double(a) * double(b) - double(a * b);
    ASSERT_EQ(double(ProductError(a, b, a * b)), lost);
  }
}

TEST(NextFloat, GoesToTheNeighbour) {
  test::Random random(15);
  constexpr float Smallest = std::numeric_limits<float>::min();
  constexpr float Inf = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 1000000; ++i) {
    const float x = random.AnyFloat();
    if (std::abs(x) <= Smallest || std::abs(x) == std::numeric_limits<float>::max()) continue;
    ASSERT_EQ(NextFloatUp(x), std::nextafterf(x, Inf));
    ASSERT_EQ(NextFloatDown(x), std::nextafterf(x, -Inf));
  }
  EXPECT_EQ(NextFloatUp(0.0f), Smallest);
  EXPECT_EQ(NextFloatUp(-0.0f), Smallest);
  EXPECT_EQ(NextFloatDown(0.0f), -Smallest);
  EXPECT_EQ(NextFloatUp(Smallest), std::nextafterf(Smallest, 1.0f));
  // Denormals may be flushed to zero and are never results
  EXPECT_EQ(NextFloatUp(-Smallest), 0.0f);
  EXPECT_EQ(NextFloatDown(Smallest), 0.0f);
}

TEST(Gamma, BoundsTheErrorOfSums) {
  EXPECT_GT(Gamma(1.0f), UnitRoundoff);
  test::Random random(16);
  for (int i = 0; i < 100000; ++i) {
    // (1 + δ)ⁿ − 1 ≤ γₙ for the worst sign of every rounding
    float sum = random.UniformFloat();
    double exact = double(sum);
    for (int k = 0; k < 8; ++k) {
      const float x = random.UniformFloat();
      sum += x;
      exact += double(x);
    }
    ASSERT_LE(std::abs(double(sum) - exact), double(Gamma(8.0f)) * exact);
  }
}

TEST(CoordinateSystem, IsARightHandedOrthonormalFrame) {
  test::Random random(17);
  double worst = 0;
  const auto check = [&](vec3 n) {
    vec3 s;
    vec3 t;
    CoordinateSystem(n, s, t);
    const glm::dvec3 dn(n), ds(s), dt(t);
    for (const double error :
         {glm::length(ds) - 1, glm::length(dt) - 1, glm::dot(ds, dt), glm::dot(ds, dn),
          glm::dot(dt, dn), glm::length(glm::cross(ds, dt) - dn)})
      worst = std::max(worst, std::abs(error));
  };
  for (int i = 0; i < 1000000; ++i) check(vec3(random.Direction()));
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0f, -1.0f}) {
      vec3 n(0.0f);
      n[axis] = sign;
      check(n);
      // Next to the axis too, where the frame turns fastest
      n[(axis + 1) % 3] = 1e-7f;
      check(Normalize(n));
    }
  }
  check(vec3(1.0f, 0.0f, -0.0f));
  check(vec3(0.6f, 0.8f, -1e-30f));
  RecordProperty("max_error_1e-9", int(worst * 1e9));
  EXPECT_LE(worst, 5e-7);
}

TEST(OffsetRayOrigin, LeavesTheErrorBoxOnTheRaysSide) {
  test::Random random(18);
  for (int i = 0; i < 500000; ++i) {
    const double scale = random.LogUniform(1e-4, 1e7);
    const vec3 p(random.InCube() * scale);
    const vec3 pError = Abs(p) * Gamma(random.Chance(0.5) ? 3.0f : 20.0f);
    const vec3 n(random.Direction());
    const vec3 w(random.Direction());
    const vec3 o = OffsetRayOrigin(p, pError, n, w);
    // Every corner of the box lies behind the start
    const double side = Dot(w, n) < 0 ? -1.0 : 1.0;
    const glm::dvec3 reach = glm::abs(glm::dvec3(n)) * glm::dvec3(pError);
    const double height = side * glm::dot(glm::dvec3(o) - glm::dvec3(p), glm::dvec3(n));
    ASSERT_GE(height, (reach.x + reach.y + reach.z) * (1 - 1e-6));
    ASSERT_GT(Sign(height), 0);
  }
}

}  // namespace
}  // namespace snell::kernel
