// SPDX-License-Identifier: Apache-2.0
//
// Further channels of a picture, of the same size: what EXR calls layers.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace snell::image {

// "normal" with the channels X, Y, Z is written as normal.X, normal.Y, normal.Z.
struct Layer {
  std::string name;
  std::vector<std::string> channels;
  bool isColor = false;       // light or reflectance, which half floats hold well enough
  std::vector<float> values;  // of the pixels from the top left on, their channels together
};

struct Layers {
  std::vector<Layer> layers;
  Metadata metadata;  // that explains them
};

}  // namespace snell::image
