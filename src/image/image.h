// SPDX-License-Identifier: Apache-2.0
//
// A picture in memory: linear Rec.709 colour and, if there is any, coverage. What the film hands to the
// writers (write.h), what the readers return (read.h) and what textures are made of.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "kernel/dialect.h"

namespace snell::image {

using kernel::vec3;

// Text that goes with a picture, in order: ("Software", "Snell 0.1"). Keys are 1–79 printable ASCII
// characters, values UTF-8.
using Metadata = std::vector<std::pair<std::string, std::string>>;

// Rows from top to bottom, each from left to right. `alpha` is empty or has one entry per pixel; then
// colours are either multiplied by it (`premultiplied`; how renderers and EXR count) or not (PNG, glTF).
struct Image {
  Image() = default;
  Image(int imageWidth, int imageHeight);  // black, without alpha

  std::size_t Index(int x, int y) const {
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
  }
  vec3& At(int x, int y) { return pixels[Index(x, y)]; }
  const vec3& At(int x, int y) const { return pixels[Index(x, y)]; }
  bool HasAlpha() const { return !alpha.empty(); }

  // The colour of a pixel multiplied by its alpha, or divided by it; black where that is impossible.
  vec3 Premultiplied(std::size_t index) const;
  vec3 Straight(std::size_t index) const;

  int width = 0;
  int height = 0;
  std::vector<vec3> pixels;
  std::vector<float> alpha;
  bool premultiplied = false;
};

}  // namespace snell::image
