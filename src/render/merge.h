// SPDX-License-Identifier: Apache-2.0
//
// Films that hold different samples of one picture, added up: ranges of samples, parts of the picture, or both. The
// sums are exact, so the result is that of one render, to the bit.
#pragma once

#include <string>
#include <vector>

#include "render/film.h"

namespace snell::render {

// Which samples a film holds; several blocks if it was merged from films that do not fit together without a gap.
std::vector<SampleBlock> BlocksOf(const Film& film);

// Add the films up, in a rectangle around all of them. `names` are theirs, for messages. Throws Error if two hold
// the same sample of a pixel or come from different scenes or settings. There is at least one film.
Film MergeFilms(std::vector<Film> films, const std::vector<std::string>& names);

}  // namespace snell::render
