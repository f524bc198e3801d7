// SPDX-License-Identifier: Apache-2.0
#include "agree/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "kernel/math.h"
#include "util/check.h"

namespace snell::agree {

namespace {

// "(0.5, 0, 1) = 3f000000 00000000 3f800000".
std::string ValueAndBits(kernel::Spectrum s) {
  std::uint32_t bits[3];
  std::memcpy(bits, &s, sizeof bits);
  return fmt::format("({}, {}, {}) = {:08x} {:08x} {:08x}", s.x, s.y, s.z, bits[0], bits[1],
                     bits[2]);
}

}  // namespace

std::string Difference(const char* nameA, const std::vector<kernel::Spectrum>& a, const char* nameB,
                       const std::vector<kernel::Spectrum>& b, std::uint32_t width) {
  CHECK(a.size() == b.size());
  std::size_t count = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::memcmp(&a[i], &b[i], sizeof a[i]) == 0) continue;
    if (count++ == 0) first = i;
  }
  if (count == 0) return "";
  return fmt::format("{} of {} pixels differ, the first at {},{}:\n  {}: {}\n  {}: {}", count,
                     a.size(), first % width, first / width, nameA, ValueAndBits(a[first]), nameB,
                     ValueAndBits(b[first]));
}

std::string Difference(const char* nameA, const std::vector<kernel::AovSample>& a,
                       const char* nameB, const std::vector<kernel::AovSample>& b,
                       std::uint32_t width) {
  // Word by word of the record
  constexpr std::size_t Words = sizeof(kernel::AovSample) / 4;
  CHECK(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::uint32_t wordsA[Words], wordsB[Words];
    std::memcpy(wordsA, &a[i], sizeof wordsA);
    std::memcpy(wordsB, &b[i], sizeof wordsB);
    for (std::size_t word = 0; word < Words; ++word) {
      if (wordsA[word] != wordsB[word])
        return fmt::format("word {} of the AOVs differs at {},{}:\n  {}: {:08x}\n  {}: {:08x}",
                           word, i % width, i / width, nameA, wordsA[word], nameB, wordsB[word]);
    }
  }
  return "";
}

std::string DifferenceBeyondRounding(const std::vector<kernel::Spectrum>& a,
                                     const std::vector<kernel::Spectrum>& b) {
  CHECK(a.size() == b.size() && !a.empty());
  double meanA = 0;
  double meanB = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    meanA += double(kernel::MeanChannel(a[i])) / double(a.size());
    meanB += double(kernel::MeanChannel(b[i])) / double(a.size());
  }
  // A mean that is no number fails as well
  if (!(std::abs(meanA - meanB) <= 1e-3 * std::max(meanA, meanB)))
    return fmt::format("the means are {} and {}", meanA, meanB);

  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const float difference = kernel::MaxChannel(kernel::Abs(a[i] - b[i]));
    if (!(difference <= 0.01f * (kernel::MaxChannel(a[i]) + float(meanA)))) ++count;
  }
  if (count * 100 <= a.size()) return "";
  return fmt::format("{} of {} pixels differ by more than rounding", count, a.size());
}

std::size_t CountNonFinite(const std::vector<kernel::Spectrum>& picture) {
  return std::size_t(std::ranges::count_if(picture, [](kernel::Spectrum s) {
    return !std::isfinite(s.x) || !std::isfinite(s.y) || !std::isfinite(s.z);
  }));
}

}  // namespace snell::agree
