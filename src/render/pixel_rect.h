// SPDX-License-Identifier: Apache-2.0
//
// A part of a picture.
#pragma once

#include <cstddef>

namespace snell::render {

// A rectangle of pixels: [x0, x1) × [y0, y1), the origin at the top left.
struct PixelRect {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  int Width() const { return x1 - x0; }
  int Height() const { return y1 - y0; }
  bool Empty() const { return x1 <= x0 || y1 <= y0; }
  // The place of a pixel in rows from the top.
  std::size_t Index(int x, int y) const {
    return std::size_t(y - y0) * std::size_t(Width()) + std::size_t(x - x0);
  }
  bool operator==(const PixelRect&) const = default;
};

}  // namespace snell::render
