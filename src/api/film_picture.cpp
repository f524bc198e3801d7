// SPDX-License-Identifier: Apache-2.0
#include "api/film_picture.h"

namespace snell {

Picture ToPicture(const image::Image& image) {
  Picture picture;
  picture.width = image.width;
  picture.height = image.height;
  picture.rgb.reserve(image.pixels.size() * 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const image::vec3 pixel = image.Premultiplied(i);
    picture.rgb.insert(picture.rgb.end(), {pixel.x, pixel.y, pixel.z});
  }
  return picture;
}

Picture PictureOf(const render::Film& film) { return ToPicture(film.ToImage()); }

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
