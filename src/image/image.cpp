// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include "util/check.h"

namespace snell::image {

Image::Image(int imageWidth, int imageHeight) : width(imageWidth), height(imageHeight) {
  CHECK(width > 0 && height > 0);
  pixels.resize(std::size_t(width) * std::size_t(height), vec3(0.0f));
}

vec3 Image::Premultiplied(std::size_t index) const {
  if (alpha.empty() || premultiplied) return pixels[index];
  return pixels[index] * alpha[index];
}

vec3 Image::Straight(std::size_t index) const {
  if (alpha.empty() || !premultiplied) return pixels[index];
  return alpha[index] > 0 ? pixels[index] / alpha[index] : vec3(0.0f);
}

}  // namespace snell::image
