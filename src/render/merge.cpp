// SPDX-License-Identifier: Apache-2.0
#include "render/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "render/film_file.h"
#include "util/check.h"
#include "util/error.h"

namespace snell::render {

namespace {

PixelRect Around(const PixelRect& a, const PixelRect& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

PixelRect Within(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

bool Overlap(const SampleBlock& a, const SampleBlock& b) {
  return !Within(a.rect, b.rect).Empty() && std::max(a.first, b.first) < std::min(a.last, b.last);
}

// Add what `from` holds; its rectangle lies within that of `film`.
void AddFilm(Film& film, const Film& from, const std::string& name) {
  const PixelRect& rect = from.rect();
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      Film::Pixel& to = film.At(x, y);
      const Film::Pixel& pixel = from.At(x, y);
      if (pixel.count > std::numeric_limits<std::uint32_t>::max() - to.count)
        throw Error("the films hold more samples together than can be counted", {name});
      for (int i = 0; i < 3; ++i) {
        to.sum[i].Add(pixel.sum[i]);
        to.firstHalf[i].Add(pixel.firstHalf[i]);
      }
      to.squares.Add(pixel.squares);
      to.count += pixel.count;
      to.halfCount += pixel.halfCount;
      to.goal = to.count;
    }
  }
  if (film.aovs()) film.aovs()->Add(*from.aovs());
}

// Put blocks together that follow one another in the same rectangle.
std::vector<SampleBlock> Joined(std::vector<SampleBlock> blocks) {
  const auto key = [](const SampleBlock& b) {
    return std::tuple(b.rect.y0, b.rect.x0, b.rect.y1, b.rect.x1, b.first);
  };
  std::sort(blocks.begin(), blocks.end(),
            [&](const SampleBlock& a, const SampleBlock& b) { return key(a) < key(b); });
  std::vector<SampleBlock> joined;
  for (const SampleBlock& block : blocks) {
    if (!joined.empty() && joined.back().rect == block.rect && joined.back().last == block.first)
      joined.back().last = block.last;
    else
      joined.push_back(block);
  }
  return joined;
}

}  // namespace

std::vector<SampleBlock> BlocksOf(const Film& film) {
  if (!film.merged().empty()) return film.merged();
  std::uint32_t most = 0;
  for (const Film::Pixel& pixel : film.pixels()) most = std::max(most, pixel.count);
  return {{film.rect(), film.firstSample(), film.firstSample() + most}};
}

Film MergeFilms(std::vector<Film> films, const std::vector<std::string>& names) {
  CHECK(!films.empty() && films.size() == names.size());
  PixelRect rect = films[0].rect();
  std::vector<SampleBlock> blocks;
  for (std::size_t i = 0; i < films.size(); ++i) {
    std::string difference = Difference(films[i].origin(), films[0].origin());
    if (difference.empty()) difference = AovDifference(films[i].aovs(), films[0].aovs());
    if (!difference.empty())
      throw Error(fmt::format("does not go with '{}': {}", names[0], difference), {names[i]});
    const std::vector<SampleBlock> own = BlocksOf(films[i]);
    for (std::size_t k = 0; k < i; ++k) {
      for (const SampleBlock& theirs : BlocksOf(films[k])) {
        for (const SampleBlock& block : own) {
          if (Overlap(block, theirs))
            throw Error(fmt::format("holds samples {}:{} of pixels that '{}' holds, too",
                                    std::max(block.first, theirs.first),
                                    std::min(block.last, theirs.last), names[k]),
                        {names[i]}, "samples must not count twice; see --samples and --crop");
        }
      }
    }
    blocks.insert(blocks.end(), own.begin(), own.end());
    rect = Around(rect, films[i].rect());
  }

  blocks = Joined(std::move(blocks));
  Film merged(rect, blocks[0].first);
  merged.origin() = films[0].origin();
  if (films[0].aovs()) merged.aovs() = films[0].aovs()->Like(rect);
  for (std::size_t i = 0; i < films.size(); ++i) AddFilm(merged, films[i], names[i]);

  // One block without a gap is a film like any other, which a render can go on with
  const bool whole =
      blocks.size() == 1 && blocks[0].rect == rect &&
      std::all_of(merged.pixels().begin(), merged.pixels().end(), [&](const Film::Pixel& pixel) {
        return pixel.count == blocks[0].last - blocks[0].first;
      });
  if (!whole) merged.merged() = std::move(blocks);
  return merged;
}

}  // namespace snell::render
