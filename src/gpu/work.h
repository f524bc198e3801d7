// SPDX-License-Identifier: Apache-2.0
//
// The samples of one pass over the picture in batches of any size: tile by tile, of each tile round by round, so
// that neighbours in a batch are neighbours in the picture.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/records.h"
#include "render/film.h"

namespace snell::gpu {

// The requests [first, last) of a batch are those of one tile: a pixel's samples are in order of their numbers.
struct TileShare {
  std::size_t first = 0;
  std::size_t last = 0;
};

struct Batch {
  std::vector<kernel::SampleRequest> requests;
  std::vector<TileShare> shares;
};

class Work {
 public:
  static constexpr int TileSize = 16;
  // Requests that a batch may have at least: a round of a tile.
  static constexpr std::uint32_t LeastLimit = TileSize * TileSize;

  // What brings the film's pixels to their goals. A film may get the samples of earlier batches meanwhile.
  explicit Work(const render::Film& film);

  // The next requests, at most `limit`; none if all have been given out.
  Batch Next(std::uint32_t limit);

 private:
  void BeginTile();

  const render::Film& film_;
  std::vector<render::PixelRect> tiles_;
  std::size_t tile_ = 0;
  std::uint32_t round_ = 0;
  std::uint32_t rounds_ = 0;           // of the tile
  std::vector<std::uint32_t> counts_;  // of the tile's pixels when it was begun
};

}  // namespace snell::gpu
