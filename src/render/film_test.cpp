// SPDX-License-Identifier: Apache-2.0
//
// Film and the order of work: means, halves and variance of samples, sums in any order, tiles that cover each pixel
// once.
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
  film.Add(3, -2, 0, Spectrum(1, 2, 3));
  film.Add(3, -2, 1, Spectrum(3, 2, 0));
  film.Add(5, -1, 0, Spectrum(7.0f));
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
  for (std::uint32_t i = 0; i < 100000; ++i) film.Add(0, 0, i, Spectrum(0.1f));
  EXPECT_NEAR(film.ToImage().pixels[0].x, 0.1f, 0.1f * 1e-2f);
}

TEST(Film, AddsUpTheSameInAnyOrder) {
  // Numbers of very different sizes, as plain sums of doubles would lose them
  std::vector<double> values;
  for (int i = 0; i < 300; ++i)
    values.push_back(std::ldexp(1.0 + i % 7, i % 90 - 55) * (i % 3 - 1));
  ExactSum forward, backward, left, right;
  for (std::size_t i = 0; i < values.size(); ++i) {
    forward.Add(values[i]);
    backward.Add(values[values.size() - 1 - i]);
    (i % 2 == 0 ? left : right).Add(values[i]);
  }
  left.Add(right);
  EXPECT_EQ(forward, backward);
  EXPECT_EQ(forward, left);
}

TEST(ExactSum, IsExactWhereFloatsAre) {
  for (const float value : {0.0f, 1.0f, -0.375f, 123456.789f, 0x1p-30f, 0x1.fffffep37f}) {
    ExactSum sum;
    for (int i = 0; i < 3; ++i) sum.Add(double(value));
    EXPECT_EQ(sum.Value(), 3 * double(value));
  }
  ExactSum most;
  most.Add(1e300);
  most.Add(-3e38);
  most.Add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(most.Value(), ExactSum::Largest) << "held within its range";
}

TEST(Film, KeepsHalvesAndVariance) {
  Film film({0, 0, 1, 1});
  // The halves take blocks of eight in turns: A B B A
  double sum = 0, squares = 0, first = 0;
  for (std::uint32_t i = 0; i < 32; ++i) {
    const float value = float(i * i % 11) / 4;
    film.Add(0, 0, i, Spectrum(value, 2 * value, 0));
    sum += double(value);
    squares += double(value) * double(value);
    if (i < 8 || i >= 24) first += double(value);
  }
  EXPECT_EQ(film.HalfImage(true).pixels[0], Spectrum(glm::dvec3(first, 2 * first, 0) / 16.0));
  EXPECT_EQ(film.HalfImage(false).pixels[0],
            Spectrum(glm::dvec3(sum - first, 2 * (sum - first), 0) / 16.0));
  EXPECT_NEAR(film.SampleVariance(0, 0), (squares - sum * sum / 32) / 31, 1e-12);
  EXPECT_EQ(Film({0, 0, 1, 1}).SampleVariance(0, 0), 0);
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

}  // namespace
}  // namespace snell::render
