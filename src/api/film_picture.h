// SPDX-License-Identifier: Apache-2.0
//
// Films as the public interface hands them out.
#pragma once

#include <string>

#include "api/picture.h"
#include "render/film.h"

namespace snell {

// The picture as plain floats.
Picture PictureOf(const render::Film& film);

// Samples per pixel, the mean over all pixels.
double SamplesPerPixel(const render::Film& film);

// A note of the film's origin; "" if it has none of this name.
std::string NoteOf(const render::Film& film, const std::string& name);

}  // namespace snell
