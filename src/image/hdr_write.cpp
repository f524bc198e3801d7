// SPDX-License-Identifier: Apache-2.0
//
// Pictures to Radiance HDR: linear RGB with a shared exponent, rounded to nearest, rows run-length
// encoded by component. Ward, "Real Pixels", Graphics Gems II (1991), §II.5. The header ends with FORMAT
// because some readers stop there.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "image/codec.h"
#include "image/metadata.h"

namespace snell::image {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr float LargestValue = 255.0f * 0x1p119f;  // mantissa 255, exponent 255
constexpr std::size_t ShortestRun = 4;
constexpr std::size_t LongestRun = 127;
constexpr std::size_t LongestLiteral = 128;

// Negative and NaN to 0, infinity to the largest value.
double Representable(float value) {
  return value > 0 ? double(std::min(value, LargestValue)) : 0.0;
}

Rgbe ToRgbe(const vec3& color) {
  const double c[] = {Representable(color.x), Representable(color.y), Representable(color.z)};
  const double largest = std::max({c[0], c[1], c[2]});

  // The exponent under which the largest component rounds to at most 255
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (std::ldexp(largest, 8 - exponent) >= 255.5) ++exponent;
  if (largest == 0 || exponent + 128 < 1) return {0, 0, 0, 0};

  const auto mantissa = [&](double value) {
    return std::uint8_t(std::ldexp(value, 8 - exponent) + 0.5);
  };
  return {mantissa(c[0]), mantissa(c[1]), mantissa(c[2]), std::uint8_t(exponent + 128)};
}

// How many equal bytes follow each other from `x` on, at most a run's length.
std::size_t RunLength(const std::vector<Rgbe>& row, std::size_t component, std::size_t x) {
  const std::size_t end = std::min(row.size(), x + LongestRun);
  std::size_t next = x + 1;
  while (next < end && row[next][component] == row[x][component]) ++next;
  return next - x;
}

// Alternate literals, which end where a run worth its two bytes begins, and runs.
void WriteComponent(const std::vector<Rgbe>& row, std::size_t component, std::string& bytes) {
  for (std::size_t x = 0; x < row.size();) {
    const std::size_t run = RunLength(row, component, x);
    if (run >= ShortestRun) {
      bytes += char(128 + run);
      bytes += char(row[x][component]);
      x += run;
      continue;
    }
    std::size_t end = x + run;
    while (end < row.size() && end - x < LongestLiteral) {
      const std::size_t next = RunLength(row, component, end);
      if (next >= ShortestRun) break;
      end += next;
    }
    end = std::min({end, row.size(), x + LongestLiteral});
    bytes += char(end - x);
    for (; x < end; ++x) bytes += char(row[x][component]);
  }
}

void WriteRow(const std::vector<Rgbe>& row, std::string& bytes) {
  // Lengths that the encoding cannot mark are stored flat
  if (row.size() < 8 || row.size() > 0x7fff) {
    for (const Rgbe& pixel : row) bytes.append(pixel.begin(), pixel.end());
    return;
  }
  for (const std::size_t mark :
       {std::size_t(2), std::size_t(2), row.size() >> 8, row.size() & 0xff})
    bytes += char(mark);
  for (std::size_t component = 0; component < 4; ++component) WriteComponent(row, component, bytes);
}

}  // namespace

std::string EncodeHdr(const Image& image, const WriteOptions& options, const Place&) {
  std::string bytes = "#?RADIANCE\n";
  for (const auto& [key, value] : options.metadata) bytes += "# " + MetadataLine(key, value) + "\n";
  bytes += "PRIMARIES=0.6400 0.3300 0.3000 0.6000 0.1500 0.0600 0.3127 0.3290\n";
  bytes += "FORMAT=32-bit_rle_rgbe\n\n";
  bytes += fmt::format("-Y {} +X {}\n", image.height, image.width);

  std::vector<Rgbe> row(std::size_t(image.width));
  for (int y = 0; y < image.height; ++y) {
    const std::size_t first = image.Index(0, y);
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = ToRgbe(image.Premultiplied(first + x));
    WriteRow(row, bytes);
  }
  return bytes;
}

}  // namespace snell::image
