// SPDX-License-Identifier: Apache-2.0
//
// Pictures and films as the public interface hands them out.
#pragma once

#include <string>

#include "api/picture.h"
#include "api/render.h"
#include "image/image.h"
#include "render/film.h"

namespace snell {

// As plain floats, before black where the picture is open.
Picture ToPicture(const image::Image& image);
// With its layers.
Picture PictureOf(const render::Film& film);

// The film's picture without noise, if it holds what denoising needs, and the name of what has made it.
struct Denoised {
  Picture picture;
  std::string by;
};
Denoised DenoisedOf(const render::Film& film, Denoiser denoiser);

// Samples per pixel, the mean over all pixels.
double SamplesPerPixel(const render::Film& film);

// A note of the film's origin; "" if it has none of this name.
std::string NoteOf(const render::Film& film, const std::string& name);

}  // namespace snell
