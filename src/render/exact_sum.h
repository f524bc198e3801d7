// SPDX-License-Identifier: Apache-2.0
//
// A sum that does not depend on the order of what is added, so that samples rendered in any order, by any
// number of machines, add up to the same bits. It is an integer of 128 bits in units of 2⁻⁵⁶: what is added is
// rounded once to this unit (1.4e-17) and held within ±2³⁸ (2.7e11); 2³² such terms cannot overflow.
// docs/decisions/012-exact-film.md compares this with other ways.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace snell::render {

class ExactSum {
 public:
  static constexpr double Largest = 0x1p38;

  // `value` is a number, not NaN.
  void Add(double value) {
    const double scaled = std::clamp(value, -Largest, Largest) * 0x1p56;
    // A double of 2⁶² or more is whole already
    sum_ += std::abs(scaled) < 0x1p62 ? Integer(std::llrint(scaled)) : Integer(scaled);
  }
  void Add(const ExactSum& other) { sum_ += other.sum_; }

  // Whether so many terms can have added up to this.
  bool MayHave(std::uint32_t terms) const {
    const Integer most = (Integer(1) << 94) * terms;
    return -most <= sum_ && sum_ <= most;
  }

  double Value() const { return double(sum_) * 0x1p-56; }
  bool operator==(const ExactSum&) const = default;

 private:
  __extension__ using Integer = __int128;
  Integer sum_ = 0;
};

static_assert(sizeof(ExactSum) == 16, "film files hold it as it lies in memory");

}  // namespace snell::render
