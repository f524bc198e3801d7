// SPDX-License-Identifier: Apache-2.0
//
// The pixel filters' densities integrate to one, and their samples have these densities.
#include "kernel/pixel_filter.h"

#include <gtest/gtest.h>

#include "support/numeric.h"
#include "support/random.h"
#include "support/statistics.h"

namespace snell::kernel {
namespace {

constexpr uint Kinds[] = {FILTER_BOX, FILTER_TENT, FILTER_GAUSSIAN, FILTER_BLACKMAN_HARRIS};

// The filters' definitions once more, in double precision.
double Density(uint kind, double x) {
  const double a = 3.141592653589793 * x;
  switch (kind) {
    case FILTER_BOX: return 0.5;
    case FILTER_TENT: return 1 - std::abs(x);
    case FILTER_GAUSSIAN: {
      const double mass = std::erf(3 / std::sqrt(2.0));
      return std::exp(-4.5 * x * x) * 3 / std::sqrt(6.283185307179586) / mass;
    }
  }
  return (0.35875 + 0.48829 * std::cos(a) + 0.14128 * std::cos(2 * a) + 0.01168 * std::cos(3 * a)) /
         (2 * 0.35875);
}

class PixelFilter : public testing::TestWithParam<uint> {};

TEST_P(PixelFilter, IsNormalizedAndSymmetric) {
  const uint kind = GetParam();
  const auto density = [&](double x) { return double(EvalPixelFilter(kind, float(x))); };
  EXPECT_NEAR(test::Integrate(-1, 1, 400, density), 1, 1e-6);
  for (int i = 0; i <= 1000; ++i) {
    const float x = float(i) / 1000;
    EXPECT_NEAR(EvalPixelFilter(kind, x), EvalPixelFilter(kind, -x), 2e-7f);
    EXPECT_NEAR(density(double(x)), Density(kind, double(x)), 1e-6);
    EXPECT_GE(EvalPixelFilter(kind, x), 0.0f);
  }
  EXPECT_EQ(EvalPixelFilter(kind, 1.0001f), 0.0f);
}

TEST_P(PixelFilter, SamplesInvertTheDistribution) {
  const uint kind = GetParam();
  double worst = 0;
  float last = -2;
  for (std::uint32_t i = 0; i <= 4096; ++i) {
    const float u = i < 4096 ? float(i) / 4096 : 1 - 0x1p-24f;
    const float x = SamplePixelFilter1D(kind, u);
    ASSERT_TRUE(x >= -1 && x <= 1) << u;
    EXPECT_GE(x, last) << u;
    last = x;
    // The distribution function at x, by symmetry the smaller tail
    const double end = std::abs(double(x));
    const double tail = test::Integrate(end, 1, 60, [&](double t) { return Density(kind, t); });
    const double expected = x < 0 ? double(u) : 1 - double(u);
    worst = std::max(worst, std::abs(tail - expected));
  }
  RecordProperty("max_error_of_distribution_1e-9", int(worst * 1e9));
  EXPECT_LT(worst, 3e-7);
}

TEST_P(PixelFilter, SamplesPassTheChiSquareTest) {
  constexpr int Bins = 200;
  const uint kind = GetParam();
  const std::uint64_t count = test::Scaled(1000000);
  test::Random random(41);
  std::vector<double> observed(Bins, 0);
  for (std::uint64_t i = 0; i < count; ++i) {
    const float x = SamplePixelFilter1D(kind, random.UniformFloat());
    observed[std::size_t(std::clamp(int((double(x) + 1) * Bins / 2), 0, Bins - 1))] += 1;
  }
  std::vector<double> expected(Bins);
  for (int bin = 0; bin < Bins; ++bin) {
    const auto density = [&](double x) { return double(EvalPixelFilter(kind, float(x))); };
    expected[std::size_t(bin)] =
        double(count) *
        test::Integrate(bin * 2.0 / Bins - 1, (bin + 1) * 2.0 / Bins - 1, 4, density);
  }
  EXPECT_GT(test::ChiSquarePValue(observed, expected), test::Sidak(0.01, 4));
}

TEST_P(PixelFilter, ScalesWithTheRadius) {
  const vec2 unit = SamplePixelFilter(GetParam(), 1.0f, vec2(0.3f, 0.8f));
  const vec2 wide = SamplePixelFilter(GetParam(), 2.5f, vec2(0.3f, 0.8f));
  EXPECT_FLOAT_EQ(wide.x, 2.5f * unit.x);
  EXPECT_FLOAT_EQ(wide.y, 2.5f * unit.y);
  EXPECT_LT(unit.x, 0.0f);
  EXPECT_GT(unit.y, 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Filters, PixelFilter, testing::ValuesIn(Kinds));

}  // namespace
}  // namespace snell::kernel
