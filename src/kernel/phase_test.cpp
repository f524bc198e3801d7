// SPDX-License-Identifier: Apache-2.0
//
// The phase function: its samples fall as its density says (χ²), the density integrates to 1, and its mean cosine is
// its parameter.
#include "kernel/phase.h"

#include <gtest/gtest.h>

#include "support/random.h"
#include "support/statistics.h"

namespace snell::kernel {
namespace {

constexpr float Anisotropies[] = {-0.9f, -0.4f, 0.0f, 0.0005f, 0.3f, 0.7f, 0.95f};

// Directions by the midpoint rule: cells of cosine to −wo and angle around it.
constexpr int Rows = 30;
constexpr int Columns = 16;

vec3 At(vec3 wo, double cosine, double phi) {
  const double sine = std::sqrt(1 - cosine * cosine);
  vec3 x, y;
  CoordinateSystem(-wo, x, y);
  return x * float(sine * std::cos(phi)) + y * float(sine * std::sin(phi)) - wo * float(cosine);
}

TEST(SamplePhase, FallsAsTheDensitySays) {
  test::Random random(71);
  const vec3 wo = Normalize(vec3(0.3f, -0.8f, 0.5f));
  for (const float g : Anisotropies) {
    const std::uint64_t count = test::Scaled(1000000);
    constexpr int Fine = 2048;
    std::vector<double> expected(Rows * Columns, 0), observed(Rows * Columns, 0);
    double all = 0, mean = 0;
    for (int i = 0; i < Rows * Fine; ++i) {
      const double cosine = 2 * (i + 0.5) / (Rows * Fine) - 1;
      const double share =
          double(EvalPhase(g, wo, At(wo, cosine, 1))) * 12.566370614359172 / (Rows * Fine);
      all += share;
      mean += share * cosine;
      for (int column = 0; column < Columns; ++column)
        expected[std::size_t(i / Fine * Columns + column)] += share * double(count) / Columns;
    }
    EXPECT_NEAR(all, 1, 2e-3) << g;
    EXPECT_NEAR(mean, double(g), 2e-3) << g;

    vec3 x, y;
    CoordinateSystem(-wo, x, y);
    for (std::uint64_t i = 0; i < count; ++i) {
      const vec3 wi = SamplePhase(g, wo, vec2(random.UniformFloat(), random.UniformFloat()));
      ASSERT_NEAR(Length(wi), 1, 1e-6);
      const int row = std::clamp(int((1 - Dot(wo, wi)) / 2 * Rows), 0, Rows - 1);
      const float phi = std::atan2(Dot(wi, y), Dot(wi, x)) / (2 * Pi) + 0.5f;
      const int column = std::clamp(int(phi * Columns), 0, Columns - 1);
      observed[std::size_t(row * Columns + column)] += 1;
    }
    EXPECT_GT(test::ChiSquarePValue(observed, expected),
              test::Sidak(0.01, int(std::size(Anisotropies))))
        << g;
  }
}

}  // namespace
}  // namespace snell::kernel
