// SPDX-License-Identifier: Apache-2.0
//
// Film and the order of work: means of samples, tiles that cover each pixel once, passes that add up.
#include "render/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/tiles.h"

namespace snell::render {
namespace {

using kernel::Spectrum;

TEST(Film, HoldsTheMeanOfTheSamples) {
  Film film({3, -2, 6, 0});
  EXPECT_EQ(film.SampleCount(3, -2), 0u);
  film.Add(3, -2, Spectrum(1, 2, 3));
  film.Add(3, -2, Spectrum(3, 2, 0));
  film.Add(5, -1, Spectrum(7.0f));
  const image::Image image = film.ToImage();
  ASSERT_EQ(image.width, 3);
  ASSERT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels[0], Spectrum(2, 2, 1.5f));
  EXPECT_EQ(image.pixels[5], Spectrum(7.0f));
  EXPECT_EQ(image.pixels[1], Spectrum(0.0f)) << "no samples: black";
  EXPECT_EQ(film.SampleCount(3, -2), 2u);
  EXPECT_EQ(film.SampleCount(4, -2), 0u);
  EXPECT_GE(film.MemoryBytes(), 6u * 16);
}

TEST(Film, KeepsTheMeanOfManySamples) {
  Film film({0, 0, 1, 1});
  for (int i = 0; i < 100000; ++i) film.Add(0, 0, Spectrum(0.1f));
  EXPECT_NEAR(film.ToImage().pixels[0].x, 0.1f, 0.1f * 1e-2f);
}

int Overlap(const PixelRect& a, const PixelRect& b) {
  return std::max(0, std::min(a.x1, b.x1) - std::max(a.x0, b.x0)) *
         std::max(0, std::min(a.y1, b.y1) - std::max(a.y0, b.y0));
}

TEST(TilesInOrder, CoverEveryPixelOnce) {
  for (const PixelRect rect :
       {PixelRect{0, 0, 1, 1}, PixelRect{0, 0, 16, 16}, PixelRect{0, 0, 17, 33},
        PixelRect{5, 7, 300, 40}, PixelRect{100, 3, 101, 500}, PixelRect{0, 0, 640, 480}}) {
    for (const int size : {1, 16, 64}) {
      if (size == 1 && rect.Width() > 300) continue;
      std::vector<int> covered(std::size_t(rect.Width()) * std::size_t(rect.Height()));
      for (const PixelRect& tile : TilesInOrder(rect, size)) {
        EXPECT_FALSE(tile.Empty());
        EXPECT_LE(tile.Width(), size);
        EXPECT_LE(tile.Height(), size);
        ASSERT_EQ(Overlap(tile, rect), tile.Width() * tile.Height()) << "leaves the picture";
        for (int y = tile.y0; y < tile.y1; ++y) {
          for (int x = tile.x0; x < tile.x1; ++x)
            ++covered[std::size_t(y - rect.y0) * std::size_t(rect.Width()) +
                      std::size_t(x - rect.x0)];
        }
      }
      EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), std::ptrdiff_t(covered.size()));
    }
  }
}

TEST(TilesInOrder, GoToNeighboursInASquareOfAPowerOfTwo) {
  const std::vector<PixelRect> tiles = TilesInOrder({0, 0, 128, 128}, 16);
  for (std::size_t i = 1; i < tiles.size(); ++i)
    EXPECT_EQ(std::abs(tiles[i].x0 - tiles[i - 1].x0) + std::abs(tiles[i].y0 - tiles[i - 1].y0),
              16);
}

TEST(Passes, AddUpAndBeginSmall) {
  constexpr std::uint32_t Last = std::numeric_limits<std::uint32_t>::max();
  for (const auto& [first, last] : {std::pair(0u, 0u),
                                    {0u, 1u},
                                    {0u, 2u},
                                    {0u, 16u},
                                    {0u, 1000u},
                                    {5u, 6u},
                                    {7u, 300u},
                                    {Last - 10, Last}}) {
    std::uint32_t next = first;
    for (const SampleRange& pass : Passes(first, last)) {
      EXPECT_EQ(pass.first, next);
      EXPECT_LT(pass.first, pass.last);
      EXPECT_LE(pass.last - pass.first, 64u);
      next = pass.last;
    }
    EXPECT_EQ(next, last);
  }
  const std::vector<SampleRange> passes = Passes(0, 16);
  ASSERT_GE(passes.size(), 4u);
  EXPECT_EQ(passes[0].last, 1u);
  EXPECT_EQ(passes[1].last, 2u);
  EXPECT_EQ(passes[2].last, 4u);
  EXPECT_EQ(passes[3].last, 8u);
}

}  // namespace
}  // namespace snell::render
