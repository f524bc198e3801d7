// SPDX-License-Identifier: Apache-2.0
#include "selftest/densities.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "kernel/sobol.h"
#include "selftest/statistics.h"

namespace snell::selftest {

using kernel::Dot;

namespace {

constexpr int Cells = 32;  // along both sides
constexpr int Fine = 24;   // points per cell's side, for the density
constexpr uint Samples = 100000;

std::size_t CellOf(vec2 p) {
  const int x = std::clamp(int(p.x * Cells), 0, Cells - 1);
  const int y = std::clamp(int(p.y * Cells), 0, Cells - 1);
  return std::size_t(y * Cells + x);
}

}  // namespace

vec2 RandomPoint(uint index, uint seed) { return kernel::IndependentSample2D(index, seed); }

double PValueOnSquare(const PointSampler& sample, const std::function<double(vec2)>& density) {
  // One cell more counts what falls nowhere
  std::vector<double> observed(Cells * Cells + 1, 0), expected(Cells * Cells + 1, 0);
  for (uint i = 0; i < Samples; ++i) {
    const std::optional<vec2> p = sample(i);
    observed[p ? CellOf(*p) : observed.size() - 1] += 1;
  }
  constexpr int Steps = Cells * Fine;
  tbb::parallel_for(0, Cells, [&](int row) {
    for (int y = row * Fine; y < (row + 1) * Fine; ++y) {
      for (int x = 0; x < Steps; ++x) {
        const vec2 p((float(x) + 0.5f) / Steps, (float(y) + 0.5f) / Steps);
        expected[std::size_t(row * Cells + x / Fine)] +=
            density(p) * Samples / (double(Steps) * Steps);
      }
    }
  });
  const double everywhere = std::accumulate(expected.begin(), expected.end(), 0.0) / Samples;
  // A density of more than 1 is wrong however the samples fall; less is what falls nowhere
  if (everywhere > 1.01) return 0;
  if (observed.back() == 0 && everywhere > 0.99) {
    observed.pop_back();
    expected.pop_back();
  } else {
    expected.back() = std::max(1 - everywhere, 0.0) * Samples;
  }
  return ChiSquarePValue(observed, expected);
}

double PValueOfDirections(const Cone& cone, const DirectionSampler& sample,
                          const std::function<double(vec3)>& density) {
  vec3 x, y;
  kernel::CoordinateSystem(cone.axis, x, y);
  const float height = 1 - cone.leastCosine;
  const auto toSquare = [&](vec3 w) {
    const float azimuth = kernel::Atan2(Dot(w, y), Dot(w, x));
    return vec2(std::sqrt(std::max((1 - Dot(w, cone.axis)) / height, 0.0f)),
                azimuth * kernel::Inv2Pi + 0.5f);
  };
  const auto fromSquare = [&](vec2 p) {
    const float cosine = 1 - height * p.x * p.x;
    const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0f));
    const float azimuth = 2 * kernel::Pi * (p.y - 0.5f);
    return x * (sine * std::cos(azimuth)) + y * (sine * std::sin(azimuth)) + cone.axis * cosine;
  };
  const double solidAngle = 2 * double(kernel::Pi) * double(height);
  return PValueOnSquare(
      [&](uint index) -> std::optional<vec2> {
        const std::optional<vec3> w = sample(index);
        if (!w) return std::nullopt;
        return toSquare(*w);
      },
      [&](vec2 p) { return density(fromSquare(p)) * solidAngle * 2 * double(p.x); });
}

}  // namespace snell::selftest
