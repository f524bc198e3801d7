// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/spectra.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/mesh/text.h"

namespace snell::io {

double PbrtTable::At(double wavelength) const {
  const auto above = std::ranges::upper_bound(wavelengths, wavelength);
  const std::size_t i = std::size_t(above - wavelengths.begin());
  if (i == 0) return values.front();
  if (i == values.size()) return values.back();
  const double t = (wavelength - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
  return values[i - 1] + t * (values[i] - values[i - 1]);
}

PbrtTable MakeTable(const std::vector<double>& numbers, const Place& place) {
  PbrtTable table;
  if (numbers.empty() || numbers.size() % 2 != 0)
    throw Error("a spectrum needs pairs of a wavelength and a value", place);
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (i > 0 && !(numbers[i] > numbers[i - 2]))
      throw Error("the wavelengths of a spectrum must rise", place);
    table.wavelengths.push_back(numbers[i]);
    table.values.push_back(numbers[i + 1]);
  }
  return table;
}

PbrtTable ParseTable(std::string_view text, const std::string& file) {
  std::vector<double> numbers;
  TextScanner scanner(text);
  for (std::string_view word; !(word = scanner.Word()).empty();) {
    if (word.starts_with('#')) {
      scanner.RestOfLine();
      continue;
    }
    double value = 0;
    if (!ParseNumber(word, value) || !std::isfinite(value))
      throw Error(fmt::format("expected a number, found {}", Quoted(word)), {file, scanner.Line()});
    numbers.push_back(value);
  }
  return MakeTable(numbers, {file});
}

}  // namespace snell::io
