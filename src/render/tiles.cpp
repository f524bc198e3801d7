// SPDX-License-Identifier: Apache-2.0
#include "render/tiles.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace snell::render {

// Position on the Hilbert curve of an n × n grid, n a power of two.
static std::uint64_t HilbertIndex(std::uint32_t n, std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t s = n / 2; s > 0; s /= 2) {
    const std::uint32_t rx = (x & s) ? 1 : 0;
    const std::uint32_t ry = (y & s) ? 1 : 0;
    index += std::uint64_t(s) * s * ((3 * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = n - 1 - x;
        y = n - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

std::vector<PixelRect> TilesInOrder(PixelRect rect, int size) {
  const std::uint32_t columns = std::uint32_t((rect.Width() + size - 1) / size);
  const std::uint32_t rows = std::uint32_t((rect.Height() + size - 1) / size);
  std::uint32_t grid = 1;
  while (grid < std::max(columns, rows)) grid *= 2;

  std::vector<std::pair<std::uint64_t, PixelRect>> keyed;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const int x = rect.x0 + int(column) * size;
      const int y = rect.y0 + int(row) * size;
      keyed.push_back({HilbertIndex(grid, column, row),
                       {x, y, std::min(x + size, rect.x1), std::min(y + size, rect.y1)}});
    }
  }
  std::sort(keyed.begin(), keyed.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<PixelRect> tiles;
  for (const auto& [key, tile] : keyed) tiles.push_back(tile);
  return tiles;
}

}  // namespace snell::render
