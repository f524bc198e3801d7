// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <algorithm>

#include "util/check.h"

namespace snell::render {

static glm::dvec3 Values(const ExactSum (&sums)[3]) {
  return {sums[0].Value(), sums[1].Value(), sums[2].Value()};
}

Film::Film(PixelRect rect, std::uint32_t firstSample) : rect_(rect), firstSample_(firstSample) {
  CHECK(!rect.Empty());
  pixels_.resize(std::size_t(rect.Width()) * std::size_t(rect.Height()));
}

image::Image Film::ToImage() const {
  image::Image image(rect_.Width(), rect_.Height());
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Pixel& pixel = pixels_[i];
    if (pixel.count > 0)
      image.pixels[i] = kernel::Spectrum(Values(pixel.sum) / double(pixel.count));
  }
  return image;
}

image::Image Film::HalfImage(bool first) const {
  image::Image image(rect_.Width(), rect_.Height());
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Pixel& pixel = pixels_[i];
    const glm::dvec3 half = Values(pixel.firstHalf);
    const glm::dvec3 sum = first ? half : Values(pixel.sum) - half;
    const std::uint32_t count = first ? pixel.halfCount : pixel.count - pixel.halfCount;
    if (count > 0) image.pixels[i] = kernel::Spectrum(sum / double(count));
  }
  return image;
}

glm::dvec3 Film::Mean(int x, int y) const {
  const Pixel& pixel = At(x, y);
  return pixel.count > 0 ? Values(pixel.sum) / double(pixel.count) : glm::dvec3(0.0);
}

double Film::SampleVariance(int x, int y) const {
  const Pixel& pixel = At(x, y);
  if (pixel.count < 2) return 0;
  const double n = pixel.count;
  const double sum = Brightness(Values(pixel.sum));
  return std::max(0.0, (pixel.squares.Value() - sum * sum / n) / (n - 1));
}

bool Film::Empty() const {
  return std::all_of(pixels_.begin(), pixels_.end(),
                     [](const Pixel& pixel) { return pixel.count == 0; });
}

}  // namespace snell::render
