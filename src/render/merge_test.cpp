// SPDX-License-Identifier: Apache-2.0
//
// Merging: the parts of a render add up to the whole to the bit; what does not go together is refused.
#include "render/merge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "util/error.h"

namespace snell::render {
namespace {

using kernel::Spectrum;

// What a renderer gives for a sample: of sizes that plain sums would round.
Spectrum Radiance(int x, int y, std::uint32_t sample) {
  std::mt19937 random(std::uint32_t(x * 977 + y * 31) + sample * 7919);
  random.discard(2);
  const float value = float(random() >> 8) / 16777216.0f;
  return Spectrum(value, value * value * 1e6f, value * 1e-5f);
}

Film Rendered(PixelRect rect, std::uint32_t first, std::uint32_t last) {
  Film film(rect, first);
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      for (std::uint32_t i = first; i < last; ++i) film.Add(x, y, i, Radiance(x, y, i));
      film.At(x, y).goal = last - first;
    }
  }
  film.origin().samples = {{"seed", "0"}};
  return film;
}

constexpr PixelRect Whole{0, 0, 12, 9};

void ExpectSame(const Film& a, const Film& b) {
  ASSERT_EQ(a.rect(), b.rect());
  EXPECT_EQ(std::memcmp(a.pixels().data(), b.pixels().data(), a.MemoryBytes()), 0);
}

Film Merged(std::vector<Film> films) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < films.size(); ++i) names.push_back("f" + std::to_string(i));
  return MergeFilms(std::move(films), names);
}

std::string ErrorOf(std::vector<Film> films) {
  try {
    Merged(std::move(films));
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(MergeFilms, RangesAddUpToTheWholeInAnyOrder) {
  const Film whole = Rendered(Whole, 0, 100);
  const Film merged = Merged({Rendered(Whole, 50, 63), Rendered(Whole, 0, 1),
                              Rendered(Whole, 63, 100), Rendered(Whole, 1, 50)});
  ExpectSame(merged, whole);
  EXPECT_TRUE(merged.merged().empty()) << "a film like any other";
  EXPECT_EQ(merged.firstSample(), 0u);
  EXPECT_EQ(merged.origin().samples, whole.origin().samples);
  // In two steps
  ExpectSame(
      Merged({Merged({Rendered(Whole, 70, 100), Rendered(Whole, 0, 20)}), Rendered(Whole, 20, 70)}),
      whole);
}

TEST(MergeFilms, PartsOfThePictureAddUp) {
  const Film whole = Rendered(Whole, 0, 10);
  const Film merged = Merged({Rendered({0, 0, 5, 9}, 0, 10), Rendered({5, 0, 12, 9}, 0, 3),
                              Rendered({5, 0, 12, 9}, 3, 10)});
  ExpectSame(merged, whole);
  EXPECT_EQ(merged.merged().size(), 2u);
  // Parts that touch nothing leave gaps
  const Film corners = Merged({Rendered({0, 0, 2, 2}, 0, 4), Rendered({10, 7, 12, 9}, 0, 8)});
  EXPECT_EQ(corners.rect(), Whole);
  EXPECT_EQ(corners.SampleCount(1, 1), 4u);
  EXPECT_EQ(corners.SampleCount(5, 5), 0u);
  EXPECT_EQ(corners.SampleCount(11, 8), 8u);
}

TEST(MergeFilms, KeepsGapsInMind) {
  const Film merged = Merged({Rendered(Whole, 0, 4), Rendered(Whole, 8, 12)});
  EXPECT_EQ(merged.merged().size(), 2u) << "no render can go on with this";
  EXPECT_EQ(merged.SampleCount(0, 0), 8u);
  EXPECT_EQ(ErrorOf({merged, Rendered(Whole, 4, 8)}), "");
  EXPECT_NE(ErrorOf({merged, Rendered(Whole, 3, 5)}), "");
  // A part that was stopped early has not all that its range says
  Film stopped = Rendered(Whole, 0, 4);
  stopped.At(0, 0) = Rendered(Whole, 0, 2).At(0, 0);
  EXPECT_EQ(Merged({stopped, Rendered(Whole, 4, 8)}).merged().size(), 1u);
}

TEST(MergeFilms, RefusesWhatDoesNotGoTogether) {
  EXPECT_EQ(ErrorOf({Rendered(Whole, 0, 5), Rendered(Whole, 4, 9)}),
            "f1: holds samples 4:5 of pixels that 'f0' holds, too; samples must not count twice; "
            "see --samples and --crop");
  EXPECT_NE(ErrorOf({Rendered({0, 0, 3, 3}, 0, 5), Rendered({2, 2, 4, 4}, 0, 5)}), "");
  Film other = Rendered(Whole, 5, 9);
  other.origin().samples = {{"seed", "1"}};
  EXPECT_EQ(ErrorOf({Rendered(Whole, 0, 5), other}), "f1: does not go with 'f0': seed 1, not 0");
}

}  // namespace
}  // namespace snell::render
