// SPDX-License-Identifier: Apache-2.0
//
// Weights of non-local means for rendered pictures (Rousselle, Knaus and Zwicker 2012, "Adaptive rendering with non-local
// means filtering", section 4): how alike the patches around two pixels are, in units of what their noise explains.
#pragma once

#include <vector>

#include "render/film.h"

namespace snell::render {

// Channels of a picture, each with a margin all around in which the border is repeated.
class Planes {
 public:
  Planes(int width, int height, int count, int margin);

  // Write the inner pixels, then repeat the border.
  float& At(int plane, int x, int y) { return values_[Place(plane, x, y)]; }
  void FillMargins();

  // A row; x may reach into the margins, and so may y.
  const float* Row(int plane, int y) const { return &values_[Place(plane, 0, y)]; }

  int width() const { return width_; }
  int height() const { return height_; }
  int count() const { return count_; }
  int margin() const { return margin_; }

 private:
  std::size_t Place(int plane, int x, int y) const {
    return (std::size_t(plane) * std::size_t(height_ + 2 * margin_) + std::size_t(y + margin_)) *
               std::size_t(width_ + 2 * margin_) +
           std::size_t(x + margin_);
  }

  int width_;
  int height_;
  int count_;
  int margin_;
  std::vector<float> values_;
};

struct NlMeans {
  int window = 8;      // pixels to each side that are looked at
  int patch = 3;       // pixels to each side of a patch
  float strength = 1;  // larger: more differs by noise alone

  int Offsets() const { return (2 * window + 1) * (2 * window + 1); }
  int Margin() const { return window + patch; }
};

// Weights between the pixels of `tile` and their neighbours, row by row of the window: [pixel of the tile][offset].
// Neighbours outside the picture weigh nothing, a pixel itself 1. Both have margins of settings.Margin().
void PatchWeights(const Planes& image, const Planes& variance, const NlMeans& settings,
                  PixelRect tile, std::vector<float>& weights);

}  // namespace snell::render
