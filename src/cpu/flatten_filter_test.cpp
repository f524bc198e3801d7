// SPDX-License-Identifier: Apache-2.0
//
// The pixel filters: their distributions against their definitions, and the kernel's samples against the
// distributions.
#include "cpu/flatten_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "kernel/values.h"
#include "support/numeric.h"
#include "support/random.h"
#include "support/statistics.h"

namespace snell::cpu {
namespace {

using namespace kernel;
using scene::PixelFilter;

constexpr PixelFilter Filters[] = {PixelFilter::Box, PixelFilter::Tent, PixelFilter::Gaussian,
                                   PixelFilter::BlackmanHarris};

// The filters' definitions: density at x ∈ [−1, 1].
double Density(PixelFilter filter, double x) {
  const double a = std::numbers::pi * x;
  switch (filter) {
    case PixelFilter::Box: return 0.5;
    case PixelFilter::Tent: return 1 - std::abs(x);
    case PixelFilter::Gaussian:
      return std::exp(-4.5 * x * x) * 3 / std::sqrt(2 * std::numbers::pi) /
             std::erf(3 / std::numbers::sqrt2);
    case PixelFilter::BlackmanHarris: break;
  }
  return (0.35875 + 0.48829 * std::cos(a) + 0.14128 * std::cos(2 * a) + 0.01168 * std::cos(3 * a)) /
         (2 * 0.35875);
}

// The part of the kernel that samples the filter, with a table of its own.
struct FilterKernel {
  RenderParams params = {};

  explicit FilterKernel(PixelFilter filter, float radius = 1) {
    FlattenFilter(filter, radius, params);
  }

#include "kernel/scene_filter.h"
};

class Filter : public testing::TestWithParam<PixelFilter> {};

TEST_P(Filter, DistributionIntegratesTheDensity) {
  const auto density = [](double x) { return Density(GetParam(), x); };
  EXPECT_NEAR(test::Integrate(-1, 1, 400, density), 1, 1e-6);
  for (int i = -20; i <= 20; ++i)
    EXPECT_NEAR(FilterDistribution(GetParam(), i / 20.0),
                test::Integrate(-1, i / 20.0, 200, density), 1e-6);
}

TEST_P(Filter, SamplesInvertTheDistribution) {
  FilterKernel kernel(GetParam());
  double worst = 0;
  float last = -2;
  for (std::uint32_t i = 0; i <= 65536; ++i) {
    const float u = i < 65536 ? float(i) / 65536 : 1 - 0x1p-24f;
    const float x = kernel.FilterQuantile(u);
    ASSERT_TRUE(x >= -1 && x <= 1) << u;
    ASSERT_GE(x, last) << u;
    last = x;
    worst = std::max(worst, std::abs(FilterDistribution(GetParam(), double(x)) - double(u)));
  }
  RecordProperty("max_error_of_distribution_1e-9", int(worst * 1e9));
  EXPECT_LT(worst, 2e-5);
  EXPECT_EQ(kernel.FilterQuantile(0.5f), 0.0f);
}

TEST_P(Filter, TailsAreResolved) {
  FilterKernel kernel(GetParam());
  for (int exponent = -23; exponent < -1; ++exponent) {
    for (const float mantissa : {1.0f, 1.01f, 1.5f, 1.99f}) {
      const float u = std::ldexp(mantissa, exponent);
      const double below = FilterDistribution(GetParam(), double(kernel.FilterQuantile(u)));
      EXPECT_NEAR(below / double(u), 1, exponent < -20 ? 0.3 : 0.02) << u;
    }
  }
}

TEST_P(Filter, SamplesPassTheChiSquareTest) {
  constexpr int Bins = 200;
  FilterKernel kernel(GetParam());
  const std::uint64_t count = test::Scaled(1000000);
  test::Random random(41);
  std::vector<double> observed(Bins, 0);
  for (std::uint64_t i = 0; i < count; ++i) {
    const float x = kernel.FilterQuantile(random.UniformFloat());
    observed[std::size_t(std::clamp(int((double(x) + 1) * Bins / 2), 0, Bins - 1))] += 1;
  }
  std::vector<double> expected(Bins);
  for (int bin = 0; bin < Bins; ++bin) {
    const double lower = FilterDistribution(GetParam(), bin * 2.0 / Bins - 1);
    const double upper = FilterDistribution(GetParam(), (bin + 1) * 2.0 / Bins - 1);
    expected[std::size_t(bin)] = double(count) * (upper - lower);
  }
  EXPECT_GT(test::ChiSquarePValue(observed, expected), test::Sidak(0.01, 4));
}

TEST_P(Filter, ScalesWithTheRadius) {
  FilterKernel unit(GetParam()), wide(GetParam(), 2.5f);
  const vec2 u(0.3f, 0.8f);
  EXPECT_FLOAT_EQ(wide.SamplePixelFilter(u).x, 2.5f * unit.SamplePixelFilter(u).x);
  EXPECT_FLOAT_EQ(wide.SamplePixelFilter(u).y, 2.5f * unit.SamplePixelFilter(u).y);
  EXPECT_LT(unit.SamplePixelFilter(u).x, 0.0f);
  EXPECT_GT(unit.SamplePixelFilter(u).y, 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Filters, Filter, testing::ValuesIn(Filters));

}  // namespace
}  // namespace snell::cpu
