// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: adding up films that were rendered apart. Installed as <snell/api/merge.h>.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "picture.h"
#include "render.h"

namespace snell {

struct MergeResult {
  Picture picture;                  // with the films' layers
  std::optional<Picture> denoised;  // if that was asked for,
  std::string denoiser;             // and by what
  std::string scene;                // its name
  float exposure = 0;               // that the scene asks for,
  std::string view;                 // as is this
  double samplesPerPixel = 0;       // the mean over the pixels
  std::uint64_t emptyPixels = 0;    // that no film has samples of; they are black
  bool uneven = false;              // some pixels have more samples than others
};

// Add up films of one picture: ranges of samples, parts of the picture, or both. The result is that of one render,
// to the bit. Saves the sum as a film, too, if `output` is not empty. Throws Error if films do not go together, or are to
// be denoised and hold nothing for that.
SNELL_EXPORT MergeResult MergeFilms(const std::vector<std::filesystem::path>& films,
                                    const std::filesystem::path& output = {},
                                    Denoiser denoiser = Denoiser::None);

}  // namespace snell
