// SPDX-License-Identifier: Apache-2.0
#include "api/film_picture.h"

#include "render/denoise.h"
#include "render/oidn.h"

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

Picture PictureOf(const render::Film& film) {
  Picture picture = ToPicture(film.ToImage());
  if (!film.aovs()) return picture;
  image::Layers layers = film.aovs()->ToLayers();
  for (image::Layer& layer : layers.layers)
    picture.layers.push_back(
        {std::move(layer.name), std::move(layer.channels), layer.isColor, std::move(layer.values)});
  picture.layerMetadata = std::move(layers.metadata);
  return picture;
}

Denoised DenoisedOf(const render::Film& film, Denoiser denoiser) {
  const render::DenoiseInput input = film.aovs()->ToDenoiseInput();
  const bool byOidn =
      denoiser == Denoiser::Oidn || (denoiser == Denoiser::Automatic && render::HasOidn());
  if (byOidn) return {ToPicture(render::DenoiseByOidn(input)), "Open Image Denoise"};
  return {ToPicture(render::DenoiseByRegression(input)), "nfor"};
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
