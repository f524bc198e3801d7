// SPDX-License-Identifier: Apache-2.0
//
// Pearson's χ² test of counts against expectations, with cells of few expected counts pooled; the incomplete gamma
// function behind its p-value by series and continued fraction (Press et al. 2007, Numerical Recipes, section 6.2);
// Šidák's correction for many tests at once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace snell::selftest {

// Q(a, x) = Γ(a, x) / Γ(a), the upper tail.
inline double UpperGamma(double a, double x) {
  if (x <= 0) return 1;
  const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a;
    double sum = term;
    for (int n = 1; n < 10000 && std::abs(term) > 1e-16 * std::abs(sum); ++n) {
      term *= x / (a + n);
      sum += term;
    }
    return 1 - sum * front;
  }
  double b = x + 1 - a;
  double c = 1e300;
  double d = 1 / b;
  double h = d;
  for (int n = 1; n < 10000; ++n) {
    const double an = -double(n) * (n - a);
    b += 2;
    d = 1 / (an * d + b);
    c = b + an / c;
    h *= d * c;
    if (std::abs(d * c - 1) < 1e-16) break;
  }
  return front * h;
}

// The significance of each of `count` independent tests that all together reject a true hypothesis with
// probability `alpha`.
inline double Sidak(double alpha, int count) { return 1 - std::pow(1 - alpha, 1.0 / count); }

// The probability of counts at least as far from the expectations, if these are true.
inline double ChiSquarePValue(const std::vector<double>& observed,
                              const std::vector<double>& expected) {
  // Take the cells by rising expectation and pool until each group expects five
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  double statistic = 0;
  double pooledObserved = 0;
  double pooledExpected = 0;
  int groups = 0;
  for (const std::size_t cell : order) {
    pooledObserved += observed[cell];
    pooledExpected += expected[cell];
    if (pooledExpected < 5) continue;
    statistic +=
        (pooledObserved - pooledExpected) * (pooledObserved - pooledExpected) / pooledExpected;
    ++groups;
    pooledObserved = pooledExpected = 0;
  }
  // Counts where next to none are expected
  if (pooledObserved > 5 * pooledExpected + 20) return 0;
  return groups < 2 ? 1 : UpperGamma(0.5 * (groups - 1), 0.5 * statistic);
}

}  // namespace snell::selftest
