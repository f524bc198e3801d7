// SPDX-License-Identifier: Apache-2.0
//
// The accumulating picture: per pixel the sums of the samples' radiance, of its squares and of one half of the
// samples, and their number. The sums are exact (exact_sum.h), so they do not depend on threads, tiles or on
// which machine rendered which samples: films are saved (film_file.h), gone on with and merged to the bit.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"
#include "kernel/types.h"
#include "render/aov_film.h"
#include "render/exact_sum.h"
#include "render/pixel_rect.h"

namespace snell::render {

// Samples [first, last) of pixels.
struct SampleBlock {
  PixelRect rect;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

// Names and values, in order.
using Properties = std::vector<std::pair<std::string, std::string>>;

// Where a film's samples come from.
struct FilmOrigin {
  Properties samples;  // all that samples depend on: films with the same go together
  Properties notes;    // what pictures made from it want to know
};

class Film {
 public:
  struct Pixel {
    ExactSum sum[3];
    ExactSum firstHalf[3];        // of the samples that are InFirstHalf
    ExactSum squares;             // of Brightness
    std::uint32_t count = 0;      // the samples are firstSample(), firstSample() + 1, …
    std::uint32_t halfCount = 0;  // of those, in the first half
    std::uint32_t goal = 0;       // the count at the end of the present pass
    std::uint32_t unused = 0;
  };

  // Holds the pixels of `rect`, at first without samples.
  explicit Film(PixelRect rect, std::uint32_t firstSample = 0);

  // Add one sample's finite radiance. Not for several threads on one pixel.
  void Add(int x, int y, std::uint32_t sample, kernel::Spectrum L) {
    Pixel& pixel = pixels_[Index(x, y)];
    for (int i = 0; i < 3; ++i) pixel.sum[i].Add(double(L[i]));
    if (InFirstHalf(sample)) {
      for (int i = 0; i < 3; ++i) pixel.firstHalf[i].Add(double(L[i]));
      ++pixel.halfCount;
    }
    const double brightness = Brightness(glm::dvec3(L));
    pixel.squares.Add(brightness * brightness);
    ++pixel.count;
  }

  // The mean of the channels. Luminance would overlook noise in blue.
  static double Brightness(const glm::dvec3& L) { return (L.x + L.y + L.z) * (1.0 / 3.0); }

  // Two halves of the samples in blocks of eight, dealt out by the Thue–Morse sequence. A block keeps its own
  // stratification (sobol.h), the halves are as independent as pixels are.
  static bool InFirstHalf(std::uint32_t sample) { return std::popcount(sample >> 3) % 2 == 0; }

  // Means of the samples; pixels without any are black.
  image::Image ToImage() const;
  // Means of the first half of the samples or of the second one; black where there are none.
  image::Image HalfImage(bool first) const;

  std::uint32_t SampleCount(int x, int y) const { return pixels_[Index(x, y)].count; }
  glm::dvec3 Mean(int x, int y) const;
  // Of the samples' Brightness, without bias; 0 for less than two samples. Divided by the count it is the variance
  // that the mean would have if samples were independent; they do better (noise.h).
  double SampleVariance(int x, int y) const;

  const PixelRect& rect() const { return rect_; }
  std::uint32_t firstSample() const { return firstSample_; }
  bool Empty() const;  // no pixel has a sample
  std::uint64_t MemoryBytes() const { return pixels_.size() * sizeof(Pixel); }

  std::vector<Pixel>& pixels() { return pixels_; }  // rows from top to bottom
  const std::vector<Pixel>& pixels() const { return pixels_; }
  Pixel& At(int x, int y) { return pixels_[Index(x, y)]; }
  const Pixel& At(int x, int y) const { return pixels_[Index(x, y)]; }
  // What a film that was merged from others holds, if a render cannot go on with it (merge.h); else empty.
  std::vector<SampleBlock>& merged() { return merged_; }
  const std::vector<SampleBlock>& merged() const { return merged_; }
  // What else is known of the same samples, if that was asked for.
  std::optional<AovFilm>& aovs() { return aovs_; }
  const std::optional<AovFilm>& aovs() const { return aovs_; }
  FilmOrigin& origin() { return origin_; }
  const FilmOrigin& origin() const { return origin_; }

 private:
  std::size_t Index(int x, int y) const { return rect_.Index(x, y); }

  PixelRect rect_;
  std::uint32_t firstSample_;
  std::vector<Pixel> pixels_;
  std::vector<SampleBlock> merged_;
  std::optional<AovFilm> aovs_;
  FilmOrigin origin_;
};

}  // namespace snell::render
