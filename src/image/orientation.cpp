// SPDX-License-Identifier: Apache-2.0
#include "image/orientation.h"

#include <cstdint>
#include <utility>

namespace snell::image {

namespace {

// Reads integers of a TIFF structure in its byte order; 0 beyond the end.
class TiffBytes {
 public:
  explicit TiffBytes(std::string_view bytes) : bytes_(bytes), big_(bytes.starts_with("MM")) {}

  std::uint32_t Read(std::size_t offset, int size) const {
    if (offset > bytes_.size() || bytes_.size() - offset < std::size_t(size)) return 0;
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) {
      const std::size_t at = offset + std::size_t(big_ ? i : size - 1 - i);
      value = value << 8 | std::uint8_t(bytes_[at]);
    }
    return value;
  }

 private:
  std::string_view bytes_;
  bool big_;
};

// Exif's numbers 1 to 8 say on which sides the stored row 0 and column 0 are seen.
Orientation FromExifNumber(std::uint32_t number) {
  switch (number) {
    case 2: return {.flipX = true};
    case 3: return {.flipX = true, .flipY = true};
    case 4: return {.flipY = true};
    case 5: return {.transpose = true};
    case 6: return {.flipY = true, .transpose = true};
    case 7: return {.flipX = true, .flipY = true, .transpose = true};
    case 8: return {.flipX = true, .transpose = true};
    default: return {};
  }
}

// The values of `from`, one per stored pixel, in the order of the upright picture.
template <typename T>
std::vector<T> Turned(const std::vector<T>& from, int width, int height, const Orientation& o) {
  std::vector<T> to(from.size());
  const std::size_t w = std::size_t(width), h = std::size_t(height);
  for (std::size_t y = 0; y < h; ++y) {
    for (std::size_t x = 0; x < w; ++x) {
      const std::size_t toX = o.flipX ? w - 1 - x : x;
      const std::size_t toY = o.flipY ? h - 1 - y : y;
      to[o.transpose ? toX * h + toY : toY * w + toX] = from[y * w + x];
    }
  }
  return to;
}

}  // namespace

Orientation ExifOrientation(std::string_view tiff) {
  const TiffBytes bytes(tiff);
  if (!tiff.starts_with("MM") && !tiff.starts_with("II")) return {};
  if (bytes.Read(2, 2) != 42) return {};

  // Search the first directory, whose entries are tag, type (3: 16 bits), count, value
  const std::size_t directory = bytes.Read(4, 4);
  const std::uint32_t entries = bytes.Read(directory, 2);
  for (std::uint32_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + 12 * std::size_t(i);
    if (entry >= tiff.size()) break;
    if (bytes.Read(entry, 2) == 0x0112 && bytes.Read(entry + 2, 2) == 3)
      return FromExifNumber(bytes.Read(entry + 8, 2));
  }
  return {};
}

Image Upright(Image stored, const Orientation& orientation) {
  if (!orientation.flipX && !orientation.flipY && !orientation.transpose) return stored;
  stored.pixels = Turned(stored.pixels, stored.width, stored.height, orientation);
  if (stored.HasAlpha())
    stored.alpha = Turned(stored.alpha, stored.width, stored.height, orientation);
  if (orientation.transpose) std::swap(stored.width, stored.height);
  return stored;
}

}  // namespace snell::image
