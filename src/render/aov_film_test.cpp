// SPDX-License-Identifier: Apache-2.0
#include "render/aov_film.h"

#include <gtest/gtest.h>

#include "util/error.h"

namespace snell::render {
namespace {

constexpr PixelRect Rect = {2, 1, 5, 3};

AovFilm FilmOf(bool denoise) {
  scene::AovSet all;
  all.Add(scene::Aov::All);
  AovFilm film(Rect, all, {"", "key"}, denoise);
  film.SetNames({{"a", "b"}, {"red"}, {0, 0}});
  return film;
}

void AddSamples(std::uint32_t first, std::uint32_t last, AovFilm& film) {
  for (std::uint32_t i = first; i < last; ++i) {
    kernel::AovSample sample = {};
    sample.seen = i % 3 == 0 ? 0 : 1;
    sample.object = i % 2;
    sample.depth = 5 - float(i) / 8;
    sample.albedo = kernel::Spectrum(0.1f * float(i % 7));
    sample.groups[1] = kernel::Spectrum(0.3f, 0.2f, 0.1f);
    film.Add(int(i) % 3 + 2, int(i / 3) % 2 + 1, i, kernel::Spectrum(float(i) / 3), sample);
  }
}

TEST(AovFilm, GoesOnAfterItWasSaved) {
  for (const bool denoise : {false, true}) {
    AovFilm whole = FilmOf(denoise), first = FilmOf(denoise), second = FilmOf(denoise);
    AddSamples(0, 70, whole);
    AddSamples(0, 33, first);
    second.Load(first.Save());
    AddSamples(33, 70, second);
    EXPECT_EQ(second.Save(), whole.Save());
  }
}

TEST(AovFilm, RefusesWhatItHasNotSaved) {
  AovFilm film = FilmOf(false), other = FilmOf(true);
  AddSamples(0, 20, film);
  const std::string saved = film.Save();
  EXPECT_THROW(other.Load(saved), Error);
  for (std::size_t length = 0; length < saved.size(); length += 5)
    EXPECT_THROW(FilmOf(false).Load(saved.substr(0, length)), Error) << length;
  EXPECT_THROW(film.Load(saved + "x"), Error);
}

// Even and odd samples would be different sides of a pixel; the halves are even in all dimensions of the sampler.
TEST(AovFilm, HalvesHoldAsManySamples) {
  AovFilm film(PixelRect{0, 0, 1, 1}, {}, {""}, true);
  kernel::AovSample sample = {};
  for (std::uint32_t i = 0; i < 64; ++i) {
    sample.albedo = kernel::Spectrum(1.0f, float(i & 1), 0.0f);
    film.Add(0, 0, i, kernel::Spectrum(1.0f), sample);
  }
  const DenoiseInput input = film.ToDenoiseInput();
  for (const auto& half : input.albedo) {
    EXPECT_EQ(half[0].x, 1);
    EXPECT_NEAR(half[0].y, 0.5f, 0.04f);
  }
}

TEST(AovFilm, WhatIsNotFiniteCountsAsNothing) {
  AovFilm film = FilmOf(false);
  kernel::AovSample sample = {};
  sample.albedo = kernel::Spectrum(1.0f / 0.0f);
  film.Add(2, 1, 0, kernel::Spectrum(1.0f), sample);
  for (const image::Layer& layer : film.ToLayers().layers) {
    if (layer.name != "albedo") continue;
    EXPECT_EQ(layer.values[0], 0);
  }
}

}  // namespace
}  // namespace snell::render
