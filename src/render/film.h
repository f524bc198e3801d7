// SPDX-License-Identifier: Apache-2.0
//
// The accumulating picture: per pixel the sum of the samples' radiance and their count. Samples are added in
// order of their numbers by whoever owns the pixel, so the sums do not depend on threads or tiles. They are
// of double precision: in single, a million equal samples would be off by percents.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "image/image.h"
#include "kernel/types.h"

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
};

class Film {
 public:
  // Holds the pixels of `rect`, at first without samples.
  explicit Film(PixelRect rect);

  // Add one sample's radiance. Not for several threads on one pixel.
  void Add(int x, int y, kernel::Spectrum L) {
    Pixel& pixel = pixels_[Index(x, y)];
    pixel.sum += glm::dvec3(L);
    ++pixel.count;
  }

  // Means of the samples; pixels without any are black.
  image::Image ToImage() const;

  PixelRect rect() const { return rect_; }
  std::uint32_t SampleCount(int x, int y) const { return pixels_[Index(x, y)].count; }
  std::uint64_t MemoryBytes() const { return pixels_.size() * sizeof(Pixel); }

 private:
  struct Pixel {
    glm::dvec3 sum{0.0};
    std::uint32_t count = 0;
  };
  std::size_t Index(int x, int y) const {
    return std::size_t(y - rect_.y0) * std::size_t(rect_.Width()) + std::size_t(x - rect_.x0);
  }

  PixelRect rect_;
  std::vector<Pixel> pixels_;
};

}  // namespace snell::render
