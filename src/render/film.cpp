// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include "util/check.h"

namespace snell::render {

Film::Film(PixelRect rect) : rect_(rect) {
  CHECK(!rect.Empty());
  pixels_.resize(std::size_t(rect.Width()) * std::size_t(rect.Height()));
}

image::Image Film::ToImage() const {
  image::Image image(rect_.Width(), rect_.Height());
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Pixel& pixel = pixels_[i];
    if (pixel.count > 0) image.pixels[i] = kernel::Spectrum(pixel.sum / double(pixel.count));
  }
  return image;
}

}  // namespace snell::render
