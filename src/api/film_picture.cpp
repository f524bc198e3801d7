// SPDX-License-Identifier: Apache-2.0
#include "api/film_picture.h"

namespace snell {

Picture PictureOf(const render::Film& film) {
  const image::Image image = film.ToImage();
  Picture picture;
  picture.width = image.width;
  picture.height = image.height;
  picture.rgb.reserve(image.pixels.size() * 3);
  for (const kernel::vec3& pixel : image.pixels)
    picture.rgb.insert(picture.rgb.end(), {pixel.x, pixel.y, pixel.z});
  return picture;
}

double SamplesPerPixel(const render::Film& film) {
  std::uint64_t samples = 0;
  for (const render::Film::Pixel& pixel : film.pixels()) samples += pixel.count;
  return double(samples) / double(film.pixels().size());
}

std::string NoteOf(const render::Film& film, const std::string& name) {
  for (const auto& [key, value] : film.origin().notes)
    if (key == name) return value;
  return "";
}

}  // namespace snell
