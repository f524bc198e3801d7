// SPDX-License-Identifier: Apache-2.0
//
// Films as files (.snell-film): what a render saves while it runs, goes on with, and what is merged. The layout, all
// numbers with the lowest byte first:
//
//   8 bytes   "snelfilm"
//   u32       version of the format: 1, or 2 with AOVs
//   u32       size of the header in bytes
//   header    text, a line for each property: "rect 0 0 800 600", "sample.camera …" (docs/long-renders.md)
//   u64       checksum of all before (util/hash.h)
//   pixels    128 bytes each, rows from top to bottom: Film::Pixel
//   u64       checksum of the pixels
//   AOVs      if there are any: as aov_file.cpp writes them; the header tells their size in bytes
//   u64       checksum of the AOVs
//
// Pictures in EXR could not hold this: it has no numbers of more than 32 bits.
#pragma once

#include <filesystem>

#include "render/film.h"

namespace snell::render {

inline constexpr const char* FilmExtension = "snell-film";

// Write atomically: whoever reads the file, at any moment, sees the film before or after. Throws Error.
void SaveFilm(const Film& film, const std::filesystem::path& path);

// Any file gives a film or one Error that says what is wrong with it; no memory is taken before the file has been
// found to be large enough.
Film LoadFilm(const std::filesystem::path& path);

// What differs between where two films' samples come from, in words; "" if nothing does.
std::string Difference(const FilmOrigin& a, const FilmOrigin& b);
// The same of their AOVs.
std::string AovDifference(const std::optional<AovFilm>& a, const std::optional<AovFilm>& b);

}  // namespace snell::render
