// SPDX-License-Identifier: Apache-2.0
//
// The files that a render writes. What can be known about them is checked before the render; what goes wrong
// after it costs nobody a picture: each file is written on its own, and one that cannot be written where it
// was asked for is rescued to the current or the temporary folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "api/snell.h"

namespace snell::cli {

struct Output {
  std::filesystem::path path;
  PictureOptions options;
  bool denoised = false;  // the picture without noise
};

// Where a picture is, and what went wrong on the way.
struct Written {
  std::filesystem::path path;           // empty if it could be written nowhere
  std::vector<Diagnostic> faults = {};  // of its own place and of those tried after it
};

Written WriteOrRescue(const Output& output, const Picture& picture);
// Print what went wrong with a file and what became of the picture, if anything did.
void PrintFaults(const Output& output, const Written& written);

// Pictures of the layers that can be shown, for formats that have no room for layers: "a.albedo.png" beside "a.png".
// Normals from −1 to 1 and the depths that there are become black to white. None for an EXR.
struct LayerPicture {
  Output output;
  Picture picture;
};
std::vector<LayerPicture> LayerPictures(const Output& output, const Picture& picture);

// A text file, atomically; "-" is the standard output. Pipes and devices are written to as they are.
void CheckTextWritable(const std::string& name);
void WriteText(const std::string& name, std::string_view text);

}  // namespace snell::cli
