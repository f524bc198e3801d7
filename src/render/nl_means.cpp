// SPDX-License-Identifier: Apache-2.0
#include "render/nl_means.h"

#include <algorithm>

#include "util/check.h"

namespace snell::render {

Planes::Planes(int width, int height, int count, int margin)
    : width_(width),
      height_(height),
      count_(count),
      margin_(margin),
      values_(std::size_t(count) * std::size_t(height + 2 * margin) *
              std::size_t(width + 2 * margin)) {}

void Planes::FillMargins() {
  for (int plane = 0; plane < count_; ++plane) {
    for (int y = -margin_; y < height_ + margin_; ++y) {
      for (int x = -margin_; x < width_ + margin_; ++x) {
        const bool isInner = x >= 0 && x < width_ && y >= 0 && y < height_;
        if (isInner) {
          x = width_ - 1;
          continue;
        }
        At(plane, x, y) = At(plane, std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1));
      }
    }
  }
}

namespace {

// exp(−d), or nearly: 0 from d = 16 on.
float Weight(float d) {
  float w = std::max(1 - d * (1.0f / 16), 0.0f);
  w *= w;
  w *= w;
  w *= w;
  return w * w;
}

// The squared difference of two pixels beyond what noise explains, over what it explains, summed over the channels, for
// a row of pixels and their neighbours.
void RowDistance(const Planes& image, const Planes& variance, float k2, int y, int dx, int dy,
                 int x0, int count, float* distance) {
  std::fill_n(distance, count, 0.0f);
  const float scale = 1.0f / float(image.count());
  for (int plane = 0; plane < image.count(); ++plane) {
    const float* const a = image.Row(plane, y) + x0;
    const float* const b = image.Row(plane, y + dy) + x0 + dx;
    const float* const va = variance.Row(plane, y) + x0;
    const float* const vb = variance.Row(plane, y + dy) + x0 + dx;
    for (int i = 0; i < count; ++i) {
      const float difference = a[i] - b[i];
      const float expected = va[i] + std::min(va[i], vb[i]);
      const float least = 1e-10f + 1e-6f * (a[i] * a[i] + b[i] * b[i]);
      distance[i] += (difference * difference - expected) / (least + k2 * (va[i] + vb[i])) * scale;
    }
  }
}

}  // namespace

void PatchWeights(const Planes& image, const Planes& variance, const NlMeans& settings,
                  PixelRect tile, std::vector<float>& weights) {
  CHECK(image.margin() >= settings.Margin() && variance.margin() >= settings.Margin());
  const int patch = settings.patch;
  const int width = tile.Width(), height = tile.Height();
  const int wide = width + 2 * patch;
  const float k2 = settings.strength * settings.strength;
  const float norm = 1.0f / float((2 * patch + 1) * (2 * patch + 1));
  const std::size_t offsets = std::size_t(settings.Offsets());
  weights.resize(offsets * std::size_t(width) * std::size_t(height));
  std::vector<float> row(std::size_t(wide), 0.0f);
  std::vector<float> sums(std::size_t(width) * std::size_t(height + 2 * patch));

  std::size_t offset = 0;
  for (int dy = -settings.window; dy <= settings.window; ++dy) {
    for (int dx = -settings.window; dx <= settings.window; ++dx, ++offset) {
      // Sum up the distances over patches: along rows, then down the columns
      for (int y = -patch; y < height + patch; ++y) {
        RowDistance(image, variance, k2, tile.y0 + y, dx, dy, tile.x0 - patch, wide, row.data());
        float* const sum = &sums[std::size_t(y + patch) * std::size_t(width)];
        for (int x = 0; x < width; ++x) {
          float s = 0;
          for (int i = 0; i <= 2 * patch; ++i) s += row[std::size_t(x + i)];
          sum[x] = s;
        }
      }
      for (int y = 0; y < height; ++y) {
        const int qy = tile.y0 + y + dy;
        for (int x = 0; x < width; ++x) {
          const int qx = tile.x0 + x + dx;
          float s = 0;
          for (int i = 0; i <= 2 * patch; ++i) s += sums[std::size_t((y + i) * width + x)];
          const bool isInside = qx >= 0 && qx < image.width() && qy >= 0 && qy < image.height();
          weights[std::size_t(y * width + x) * offsets + offset] =
              isInside ? Weight(std::max(s * norm, 0.0f)) : 0.0f;
        }
      }
    }
  }
}

}  // namespace snell::render
