// SPDX-License-Identifier: Apache-2.0
//
// Statistical tests of the selftest's room, and the moments of a sample.
#pragma once

#include "selftest/statistics.h"

namespace snell::test {

using selftest::ChiSquarePValue;
using selftest::Sidak;

struct Moments {
  double sum = 0;
  double squares = 0;
  double count = 0;

  void Add(double x) {
    sum += x;
    squares += x * x;
    count += 1;
  }
  double Mean() const { return sum / count; }
  double Variance() const { return squares / count - Mean() * Mean(); }
};

}  // namespace snell::test
