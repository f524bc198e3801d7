// SPDX-License-Identifier: Apache-2.0
//
// The sample points: Sobol''s sequence from its generator matrices, the (0,2) property of every power-of-two
// prefix after scrambling, independence of seeds, and that integrals converge as they should.
#include "kernel/sobol.h"

#include <gtest/gtest.h>

#include <set>

#include "support/random.h"
#include "support/statistics.h"

namespace snell::kernel {
namespace {

constexpr int SeedCount = 24;

std::uint32_t SeedOf(int i) { return HashCombine(0x1234u, std::uint32_t(i)); }

TEST(Sobol, EqualsItsGeneratorMatrices) {
  // The first dimension is van der Corput's sequence; the second has the primitive polynomial x + 1
  std::uint32_t direction[32];
  direction[0] = 0x80000000u;
  for (int k = 1; k < 32; ++k) direction[k] = direction[k - 1] ^ (direction[k - 1] >> 1);
  test::Random random(21);
  for (std::uint32_t i = 0; i < 100000; ++i) {
    const std::uint32_t index = i < 5000 ? i : std::uint32_t(random.Bits());
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    for (int k = 0; k < 32; ++k) {
      if ((index >> k & 1u) == 0) continue;
      first ^= 0x80000000u >> k;
      second ^= direction[k];
    }
    ASSERT_EQ(ReverseBits(index), first);
    ASSERT_EQ(SobolSecond(ReverseBits(index)), second);
  }
}

// Every elementary interval of area 2⁻ᵐ holds one of the 2ᵐ points from `first` on.
void ExpectStratified(std::uint32_t seed, std::uint32_t first, int m) {
  const std::uint32_t count = 1u << m;
  std::vector<vec2> points(count);
  for (std::uint32_t i = 0; i < count; ++i) points[i] = Sobol2D(first + i, seed);
  for (int bitsX = 0; bitsX <= m; ++bitsX) {
    const int bitsY = m - bitsX;
    std::vector<char> taken(count, 0);
    for (const vec2 p : points) {
      const std::uint32_t x = std::uint32_t(std::ldexp(p.x, bitsX));
      const std::uint32_t y = std::uint32_t(std::ldexp(p.y, bitsY));
      char& cell = taken[x << bitsY | y];
      ASSERT_EQ(cell, 0) << "seed " << seed << ", 2^" << m << " points from " << first
                         << ", intervals 2^-" << bitsX << " × 2^-" << bitsY;
      cell = 1;
    }
  }
}

TEST(Sobol2D, StratifiesEveryPowerOfTwoPrefix) {
  for (int s = 0; s < SeedCount; ++s) {
    for (int m = 0; m <= 12; ++m) ExpectStratified(SeedOf(s), 0, m);
  }
  for (const std::uint32_t seed : {0u, 1u, 0xffffffffu}) ExpectStratified(seed, 0, 12);
}

TEST(Sobol2D, StratifiesEveryAlignedBlock) {
  // As the samples of lights are taken: blocks of equal size, one per camera sample
  for (int s = 0; s < SeedCount; ++s) {
    for (const std::uint32_t block : {1u, 2u, 3u, 7u, 100u, 4095u}) {
      for (const int m : {2, 4, 8}) ExpectStratified(SeedOf(s), block << m, m);
    }
  }
}

TEST(Sobol2D, LiesInTheUnitSquareAndNeverRepeats) {
  for (int s = 0; s < 4; ++s) {
    std::set<std::pair<float, float>> seen;
    for (std::uint32_t i = 0; i < 1u << 16; ++i) {
      const vec2 p = Sobol2D(i, SeedOf(s));
      ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
      ASSERT_TRUE(seen.insert({p.x, p.y}).second);
    }
  }
  EXPECT_EQ(UnitFloat(0xffffffffu), 1 - 0x1p-24f);
}

TEST(Sobol2D, EachPointIsUniformOverTheSeeds) {
  constexpr int Cells = 16;
  const int samples = int(test::Scaled(100000));
  const std::vector<std::uint32_t> indices = {0, 1, 2, 3, 17, 255, 1000};
  const double significance = test::Sidak(0.01, int(2 * indices.size()));
  for (const bool hashed : {false, true}) {
    for (const std::uint32_t index : indices) {
      std::vector<double> observed(Cells * Cells, 0);
      for (int s = 0; s < samples; ++s) {
        const vec2 p = Sobol2D(index, hashed ? SeedOf(s) : std::uint32_t(s));
        observed[std::size_t(int(p.x * Cells) * Cells + int(p.y * Cells))] += 1;
      }
      const std::vector<double> expected(Cells * Cells, double(samples) / (Cells * Cells));
      EXPECT_GT(test::ChiSquarePValue(observed, expected), significance)
          << "index " << index << (hashed ? " hashed seeds" : " seeds in a row");
    }
  }
}

TEST(Sobol2D, SeedsAreUncorrelated) {
  constexpr std::uint32_t Count = 1024;
  double worst = 0;
  double squares = 0;
  int pairs = 0;
  for (int s = 0; s < 300; ++s) {
    // Neighbouring pixels, neighbouring dimensions
    const std::uint32_t a = HashCombine(HashCombine(7u, std::uint32_t(s)), 0u);
    for (const std::uint32_t b : {HashCombine(HashCombine(7u, std::uint32_t(s + 1)), 0u),
                                  HashCombine(HashCombine(7u, std::uint32_t(s)), 1u)}) {
      double xx = 0, yy = 0, xy = 0;
      for (std::uint32_t i = 0; i < Count; ++i) {
        const vec2 p = Sobol2D(i, a), q = Sobol2D(i, b);
        xx += (double(p.x) - 0.5) * (double(q.x) - 0.5);
        yy += (double(p.y) - 0.5) * (double(q.y) - 0.5);
        xy += (double(p.x) - 0.5) * (double(q.y) - 0.5);
      }
      for (const double sum : {xx, yy, xy}) {
        const double correlation = 12 * sum / Count;
        worst = std::max(worst, std::abs(correlation));
        squares += correlation * correlation;
        ++pairs;
      }
    }
  }
  RecordProperty("worst_correlation_1e-4", int(worst * 1e4));
  EXPECT_LT(worst, 0.2);
  EXPECT_LT(std::sqrt(squares / pairs), 1.5 / std::sqrt(double(Count)));
}

TEST(Sobol2D, HasTheMeanAndVarianceOfTheUniformDistribution) {
  for (int s = 0; s < SeedCount; ++s) {
    test::Moments x, y, both;
    for (std::uint32_t i = 0; i < 4096; ++i) {
      const vec2 p = Sobol2D(i, SeedOf(s));
      x.Add(double(p.x));
      y.Add(double(p.y));
      both.Add(double(p.x) * double(p.y));
    }
    EXPECT_NEAR(x.Mean(), 0.5, 1e-4);
    EXPECT_NEAR(y.Mean(), 0.5, 1e-4);
    EXPECT_NEAR(x.Variance(), 1.0 / 12, 1e-4);
    EXPECT_NEAR(y.Variance(), 1.0 / 12, 1e-4);
    EXPECT_NEAR(both.Mean(), 0.25, 1e-3);
  }
}

TEST(Sobol2D, IntegratesWithoutBiasAndFast) {
  // ∫∫ exp(x + y) and the area of a quarter disk, with n points and a thousand seeds
  constexpr std::uint32_t Count = 256;
  const double smoothExact = (std::exp(1.0) - 1) * (std::exp(1.0) - 1);
  test::Moments smooth, edge;
  for (int s = 0; s < 1000; ++s) {
    double sum = 0;
    double inside = 0;
    for (std::uint32_t i = 0; i < Count; ++i) {
      const vec2 p = Sobol2D(i, SeedOf(s));
      sum += std::exp(double(p.x) + double(p.y));
      inside += p.x * p.x + p.y * p.y < 1 ? 1 : 0;
    }
    smooth.Add(sum / Count);
    edge.Add(inside / Count);
  }
  EXPECT_NEAR(smooth.Mean(), smoothExact, 5 * std::sqrt(smooth.Variance() / 1000));
  EXPECT_NEAR(edge.Mean(), 0.7853981633974483, 5 * std::sqrt(edge.Variance() / 1000));

  // Random points would have these variances of their means
  const double smoothRandom =
      (std::pow((std::exp(2.0) - 1) / 2, 2) - smoothExact * smoothExact) / Count;
  const double edgeRandom = 0.7853981633974483 * 0.2146018366025517 / Count;
  RecordProperty("variance_below_random_smooth", int(smoothRandom / smooth.Variance()));
  RecordProperty("variance_below_random_edge", int(edgeRandom / edge.Variance()));
  EXPECT_LT(smooth.Variance(), smoothRandom / 1000);
  EXPECT_LT(edge.Variance(), edgeRandom / 8);
}

TEST(HashUint, IsBijectiveAndChangesHalfTheBits) {
  test::Random random(22);
  double flips = 0;
  constexpr int Trials = 20000;
  for (int i = 0; i < Trials; ++i) {
    const std::uint32_t x = std::uint32_t(random.Bits());
    const int bit = int(random.Index(32));
    flips += std::popcount(HashUint(x) ^ HashUint(x ^ (1u << bit)));
  }
  EXPECT_NEAR(flips / Trials, 16, 0.2);
  std::set<std::uint32_t> seen;
  for (std::uint32_t i = 0; i < 100000; ++i) seen.insert(HashUint(i));
  EXPECT_EQ(seen.size(), 100000u);
}

// The samples of every square of pixels are well distributed together.
TEST(PixelSampleIndex, StratifiesSquaresOfPixels) {
  constexpr uint SamplesLog2 = 3;
  for (const uvec2 corner : {uvec2(0, 0), uvec2(12, 40), uvec2(1020, 516)}) {
    for (uint sizeLog2 = 0; sizeLog2 <= 2; ++sizeLog2) {
      std::set<uint> indices;
      uint seed = 0;
      for (uint y = 0; y < 1u << sizeLog2; ++y)
        for (uint x = 0; x < 1u << sizeLog2; ++x)
          for (uint sample = 0; sample < 1u << SamplesLog2; ++sample) {
            seed = 5;
            const uvec2 pixel = corner / (1u << sizeLog2) * (1u << sizeLog2) + uvec2(x, y);
            indices.insert(PixelSampleIndex(pixel, sample, SamplesLog2, seed));
          }
      const int m = int(2 * sizeLog2 + SamplesLog2);
      ASSERT_EQ(indices.size(), std::size_t(1) << m);
      EXPECT_EQ(*indices.rbegin() - *indices.begin(), (1u << m) - 1);
      ExpectStratified(HashCombine(seed, 7u), *indices.begin(), m);
    }
  }
}

TEST(PixelSampleIndex, GoesOnWithOtherSeeds) {
  uint first = 5, next = 5, far = 5;
  PixelSampleIndex(uvec2(1, 2), 7, 3, first);
  PixelSampleIndex(uvec2(1, 2), 8, 3, next);
  PixelSampleIndex(uvec2(1 + (1 << 14), 2), 7, 3, far);
  EXPECT_NE(first, next);
  EXPECT_NE(first, far);
}

}  // namespace
}  // namespace snell::kernel
