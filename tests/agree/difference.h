// SPDX-License-Identifier: Apache-2.0
//
// Comparing pictures by their bits.
#pragma once

#include <string>
#include <vector>

#include "kernel/aov.h"

namespace snell::agree {

// "" if the pictures, of `width` pixels a row, are the same bit for bit; else how many pixels differ and the
// first of them with its values as `nameA` and `nameB` have it. Zeros of different sign differ.
std::string Difference(const char* nameA, const std::vector<kernel::Spectrum>& a, const char* nameB,
                       const std::vector<kernel::Spectrum>& b, std::uint32_t width);

// The same for what else the samples tell.
std::string Difference(const char* nameA, const std::vector<kernel::AovSample>& a,
                       const char* nameB, const std::vector<kernel::AovSample>& b,
                       std::uint32_t width);

// "" if the pictures are the same but for rounding: means that agree to a thousandth, and at most one pixel in
// a hundred that is off by more than a hundredth of itself and the mean. Else what is wrong.
std::string DifferenceBeyondRounding(const std::vector<kernel::Spectrum>& a,
                                     const std::vector<kernel::Spectrum>& b);

// How many pixels of a picture hold values that are not finite.
std::size_t CountNonFinite(const std::vector<kernel::Spectrum>& picture);

}  // namespace snell::agree
