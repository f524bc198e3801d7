// SPDX-License-Identifier: Apache-2.0
//
// χ² tests of the maps from the unit square to disk, triangle and cone, and that they keep strata.
#include "kernel/sampling.h"

#include <gtest/gtest.h>

#include <numbers>

#include "kernel/sobol.h"
#include "support/random.h"
#include "support/statistics.h"

namespace snell::kernel {
namespace {

constexpr int Rows = 20;
constexpr int Columns = 40;
constexpr int TestCount = 11;

// Draw a million points; `cellOf` says in which of Rows × Columns cells of equal probability each lies, as two
// fractions in [0, 1).
template <class CellOf>
void ExpectUniform(std::uint64_t seed, const CellOf& cellOf) {
  test::Random random(seed);
  const std::uint64_t count = test::Scaled(1000000);
  std::vector<double> observed(Rows * Columns, 0);
  for (std::uint64_t i = 0; i < count; ++i) {
    const vec2 u(random.UniformFloat(), random.UniformFloat());
    const glm::dvec2 cell = cellOf(u);
    const int row = std::clamp(int(cell.x * Rows), 0, Rows - 1);
    const int column = std::clamp(int(cell.y * Columns), 0, Columns - 1);
    observed[std::size_t(row * Columns + column)] += 1;
  }
  const std::vector<double> expected(Rows * Columns, double(count) / (Rows * Columns));
  EXPECT_GT(test::ChiSquarePValue(observed, expected), test::Sidak(0.01, TestCount));
}

// The fractions of a point by radius² and angle.
glm::dvec2 DiskCell(double x, double y) {
  return {x * x + y * y, 0.5 + std::atan2(y, x) / 6.283185307179586};
}

// The fractions of a triangle's point: by area nearer to v0, and along the cut.
glm::dvec2 TriangleCell(vec2 b) {
  const double sum = double(b.x) + double(b.y);
  return {sum * sum, sum > 0 ? double(b.x) / sum : 0};
}

TEST(SampleUniformDisk, IsUniform) {
  ExpectUniform(31, [](vec2 u) {
    const vec2 p = SampleUniformDisk(u);
    EXPECT_LE(double(p.x) * double(p.x) + double(p.y) * double(p.y), 1 + 1e-6);
    return DiskCell(double(p.x), double(p.y));
  });
}

TEST(SampleUniformDisk, KnowsCentreAndCorners) {
  EXPECT_EQ(SampleUniformDisk(vec2(0.5f, 0.5f)), vec2(0.0f, 0.0f));
  for (const vec2 u : {vec2(0, 0), vec2(1, 0), vec2(0, 1), vec2(1, 1)}) {
    const vec2 p = SampleUniformDisk(u);
    EXPECT_NEAR(p.x, u.x > 0 ? 0.70710678f : -0.70710678f, 1e-6f);
    EXPECT_NEAR(p.y, u.y > 0 ? 0.70710678f : -0.70710678f, 1e-6f);
  }
  EXPECT_NEAR(SampleUniformDisk(vec2(1.0f, 0.5f)).x, 1.0f, 1e-6f);
  EXPECT_NEAR(SampleUniformDisk(vec2(0.5f, 0.0f)).y, -1.0f, 1e-6f);
}

TEST(SampleUniformTriangle, IsUniform) {
  ExpectUniform(32, [](vec2 u) {
    const vec2 b = SampleUniformTriangle(u);
    EXPECT_TRUE(b.x >= 0 && b.y >= 0 && b.x + b.y <= 1);
    return TriangleCell(b);
  });
}

// The fractions of a point of a polygon whose first corner is at `angle`: by area nearer to the middle, and along its
// edges.
glm::dvec2 PolygonCell(vec2 p, int corners, double angle) {
  const double sector = 2 * std::numbers::pi / corners;
  double turned = std::fmod(std::atan2(double(p.y), double(p.x)) - angle, 2 * std::numbers::pi);
  if (turned < 0) turned += 2 * std::numbers::pi;
  const double index = std::min(std::floor(turned / sector), double(corners - 1));
  const double fromApothem = turned - (index + 0.5) * sector;
  const double apothem = std::cos(sector / 2);
  const double height = std::hypot(double(p.x), double(p.y)) * std::cos(fromApothem) / apothem;
  const double along = 0.5 + 0.5 * std::tan(fromApothem) / std::tan(sector / 2);
  EXPECT_LE(height, 1 + 1e-5);
  return {height * height, (index + along) / corners};
}

class Polygon : public testing::TestWithParam<int> {};

TEST_P(Polygon, IsUniform) {
  ExpectUniform(34, [](vec2 u) {
    return PolygonCell(SampleUniformPolygon(uint(GetParam()), 0.3f, u), GetParam(), 0.3);
  });
}

INSTANTIATE_TEST_SUITE_P(Sampling, Polygon, testing::Values(3, 5, 8));

class Cone : public testing::TestWithParam<double> {};

TEST_P(Cone, IsUniform) {
  const double oneMinusCos = GetParam();
  ExpectUniform(33, [&](vec2 u) {
    const vec3 w = SampleUniformCone(u, float(oneMinusCos));
    const glm::dvec3 d(w);
    EXPECT_NEAR(glm::dot(d, d), 1, 1e-6);
    // Near the axis the digits are in x and y
    const double sine2 = d.x * d.x + d.y * d.y;
    const double height = d.z > 0 ? sine2 / (1 + std::sqrt(std::max(0.0, 1 - sine2))) : 1 - d.z;
    EXPECT_LE(height, double(float(oneMinusCos)) * (1 + 1e-5) + 1e-12);
    return glm::dvec2(height / oneMinusCos, DiskCell(d.x, d.y).y);
  });
}

INSTANTIATE_TEST_SUITE_P(Sampling, Cone, testing::Values(1e-9, 1e-4, 0.2, 1.0, 2.0));

// How far the counts of cells of equal probability are from even, relative to random points.
template <class CellOf>
double Unevenness(const CellOf& cellOf) {
  constexpr std::uint32_t Count = 4096;
  constexpr int Cells = 16;
  double squares = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::vector<double> counts(Cells * Cells, 0);
    for (std::uint32_t i = 0; i < Count; ++i) {
      const glm::dvec2 cell = cellOf(Sobol2D(i, HashUint(seed)));
      const int row = std::clamp(int(cell.x * Cells), 0, Cells - 1);
      const int column = std::clamp(int(cell.y * Cells), 0, Cells - 1);
      counts[std::size_t(row * Cells + column)] += 1;
    }
    const double mean = double(Count) / (Cells * Cells);
    for (const double c : counts) squares += (c - mean) * (c - mean) / mean;
  }
  return std::sqrt(squares / (20 * Cells * Cells));
}

TEST(Sampling, KeepsStrata) {
  EXPECT_LT(Unevenness([](vec2 u) {
              const vec2 p = SampleUniformDisk(u);
              return DiskCell(double(p.x), double(p.y));
            }),
            0.4);
  EXPECT_LT(Unevenness([](vec2 u) { return TriangleCell(SampleUniformTriangle(u)); }), 0.4);
  EXPECT_LT(Unevenness([](vec2 u) {
              const vec3 w = SampleUniformCone(u, 0.5f);
              return glm::dvec2((1 - double(w.z)) / 0.5, DiskCell(double(w.x), double(w.y)).y);
            }),
            0.4);
}

TEST(Sampling, IsContinuous) {
  // Neighbouring inputs give neighbouring outputs, across the seams of the maps too
  constexpr int N = 400;
  constexpr float Step = 1.0f / N;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      const vec2 u(float(i) * Step, float(j) * Step);
      for (const vec2 next : {u + vec2(Step, 0), u + vec2(0, Step)}) {
        const vec2 a = SampleUniformDisk(u), b = SampleUniformDisk(next);
        ASSERT_LT(std::hypot(a.x - b.x, a.y - b.y), 4 * Step);
        const vec2 c = SampleUniformTriangle(u), d = SampleUniformTriangle(next);
        ASSERT_LT(std::hypot(c.x - d.x, c.y - d.y), 2 * Step);
      }
    }
  }
}

}  // namespace
}  // namespace snell::kernel
