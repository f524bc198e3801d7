// SPDX-License-Identifier: Apache-2.0
#include "gpu/work.h"

#include <algorithm>

#include "render/tiles.h"

namespace snell::gpu {

namespace {

// Every other bit of a number, beginning with the lowest.
int EvenBits(std::uint32_t i) { return int((i & 1) | (i >> 1 & 2) | (i >> 2 & 4) | (i >> 3 & 8)); }

}  // namespace

Work::Work(const render::Film& film)
    : film_(film), tiles_(render::TilesInOrder(film.rect(), TileSize)) {
  BeginTile();
}

void Work::BeginTile() {
  round_ = rounds_ = 0;
  counts_.assign(LeastLimit, 0);
  if (tile_ == tiles_.size()) return;
  const render::PixelRect tile = tiles_[tile_];
  for (std::uint32_t i = 0; i < LeastLimit; ++i) {
    const int x = tile.x0 + EvenBits(i), y = tile.y0 + EvenBits(i >> 1);
    if (x >= tile.x1 || y >= tile.y1) continue;
    const render::Film::Pixel& pixel = film_.At(x, y);
    counts_[i] = pixel.count;
    if (pixel.goal > pixel.count) rounds_ = std::max(rounds_, pixel.goal - pixel.count);
  }
}

Batch Work::Next(std::uint32_t limit) {
  Batch batch;
  while (tile_ < tiles_.size()) {
    const render::PixelRect tile = tiles_[tile_];
    TileShare share{batch.requests.size(), 0};
    for (; round_ < rounds_ && batch.requests.size() + LeastLimit <= limit; ++round_) {
      for (std::uint32_t i = 0; i < LeastLimit; ++i) {
        // Along Morton's curve
        const int x = tile.x0 + EvenBits(i), y = tile.y0 + EvenBits(i >> 1);
        if (x >= tile.x1 || y >= tile.y1) continue;
        const std::uint32_t number = counts_[i] + round_;
        if (number < film_.At(x, y).goal)
          batch.requests.push_back({kernel::uvec2(x, y), film_.firstSample() + number});
      }
    }
    share.last = batch.requests.size();
    if (share.last > share.first) batch.shares.push_back(share);
    if (round_ < rounds_) break;
    ++tile_;
    BeginTile();
  }
  return batch;
}

}  // namespace snell::gpu
