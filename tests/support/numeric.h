// SPDX-License-Identifier: Apache-2.0
//
// Numerical yardsticks: errors in units of the last place, quadrature by Gauss and Legendre's rule, and the
// real roots of polynomials.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace snell::test {

// The distance of `value` from `exact` in units of the last place of a float of exact's size.
inline double UlpError(float value, double exact) {
  if (!std::isfinite(value)) return 1e30;
  const int exponent = std::max(std::ilogb(exact == 0 ? 1e-300 : exact), -126);
  return std::abs(double(value) - exact) / std::ldexp(1.0, exponent - 23);
}

// ∫ f over [a, b]: `pieces` equal intervals with five points each.
template <class F>
double Integrate(double a, double b, int pieces, const F& f) {
  static constexpr double Node[5] = {-0.9061798459386640, -0.5384693101056831, 0,
                                     0.5384693101056831, 0.9061798459386640};
  static constexpr double Weight[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                       0.4786286704993665, 0.2369268850561891};
  const double half = (b - a) / (2 * pieces);
  double sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const double middle = a + (2 * i + 1) * half;
    for (int k = 0; k < 5; ++k) sum += Weight[k] * f(middle + half * Node[k]);
  }
  return sum * half;
}

// The real roots, in rising order, of c[0] + c[1]·t + … within [lower, upper]: between two roots of the
// derivative there is at most one, which bisection finds. Roots of even multiplicity may be missed.
inline std::vector<long double> RealRoots(const std::vector<long double>& c, long double lower,
                                          long double upper) {
  if (c.size() < 2) return {};
  const auto value = [&](long double t) {
    long double sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
    return sum;
  };
  std::vector<long double> derivative;
  for (std::size_t i = 1; i < c.size(); ++i) derivative.push_back(c[i] * static_cast<int>(i));
  std::vector<long double> knots = RealRoots(derivative, lower, upper);
  knots.insert(knots.begin(), lower);
  knots.push_back(upper);
  std::vector<long double> roots;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    long double a = knots[i];
    long double b = knots[i + 1];
    const bool positive = value(a) > 0;
    if (positive == (value(b) > 0)) continue;
    for (int step = 0; step < 80; ++step) {
      const long double middle = (a + b) / 2;
      if (middle == a || middle == b) break;
      ((value(middle) > 0) == positive ? a : b) = middle;
    }
    roots.push_back((a + b) / 2);
  }
  return roots;
}

}  // namespace snell::test
