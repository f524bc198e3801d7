// SPDX-License-Identifier: Apache-2.0
#include "util/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace snell {

// Optimal string alignment distance: insertions, deletions, substitutions, swaps of neighbours.
static std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, substitute});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
    std::swap(beforeLast, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::string NearestWord(std::string_view word, const std::vector<std::string>& candidates) {
  std::string nearest;
  std::size_t best = word.size() / 3 + 2;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = EditDistance(word, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string nearest = NearestWord(word, candidates);
  return nearest.empty() ? "" : fmt::format("did you mean '{}'?", nearest);
}

std::string WithCommas(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (int place = int(digits.size()) - 3; place > 0; place -= 3)
    digits.insert(std::size_t(place), ",");
  return digits;
}

std::string ByteSize(std::uint64_t bytes) {
  static constexpr const char* Units[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  double size = double(bytes);
  int unit = 0;
  // What would be written as 1024.0 is one of the next unit
  while (size >= (unit == 0 ? 1024 : 1023.95) && unit < 4) {
    size /= 1024;
    ++unit;
  }
  return unit == 0 ? fmt::format("{} B", bytes) : fmt::format("{:.1f} {}", size, Units[unit]);
}

std::string Duration(double seconds) {
  if (seconds < 9.995) return fmt::format("{:.2f} s", seconds);
  if (seconds < 59.95) return fmt::format("{:.1f} s", seconds);
  const std::uint64_t whole = std::uint64_t(std::llround(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string Plural(std::uint64_t count, std::string_view noun) {
  const auto endsWith = [&](std::string_view ending) { return noun.ends_with(ending); };
  const bool sibilant = endsWith("s") || endsWith("x") || endsWith("ch") || endsWith("sh");
  return fmt::format("{} {}{}", WithCommas(count), noun, count == 1 ? "" : sibilant ? "es" : "s");
}

}  // namespace snell
