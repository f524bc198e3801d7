// SPDX-License-Identifier: Apache-2.0
#include "render/aov_film.h"

#include <gtest/gtest.h>

#include <cstring>

#include "util/error.h"

namespace snell::render {
namespace {

constexpr PixelRect Rect = {2, 1, 5, 3};

const AovNames Names = {{"a", "b"}, {"red"}, {0, 0}};

AovFilm FilmOf(bool denoise) {
  scene::AovSet all;
  all.Add(scene::Aov::All);
  AovFilm film(Rect, all, {"", "key"}, denoise);
  film.SetNames(Names);
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

std::string Saved(const AovFilm& film) {
  std::string bytes;
  film.Save([&](const void* more, std::size_t size) {
    bytes.append(static_cast<const char*>(more), size);
  });
  return bytes;
}

AovFilm Loaded(const std::string& bytes, PixelRect rect = Rect) {
  std::size_t at = 0;
  return AovFilm::Load(rect, bytes.size(), [&](void* to, std::size_t size) {
    ASSERT_LE(size, bytes.size() - at);
    std::memcpy(to, bytes.data() + at, size);
    at += size;
  });
}

void ExpectSame(const AovFilm& a, const AovFilm& b) {
  EXPECT_EQ(a.Difference(b), "");
  const image::Layers left = a.ToLayers(), right = b.ToLayers();
  EXPECT_EQ(left.metadata, right.metadata);
  ASSERT_EQ(left.layers.size(), right.layers.size());
  for (std::size_t i = 0; i < left.layers.size(); ++i) {
    const std::vector<float>&x = left.layers[i].values, &y = right.layers[i].values;
    ASSERT_EQ(x.size(), y.size());
    EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]), 0) << left.layers[i].name;
  }
  if (!a.denoises()) return;
  for (int half : {0, 1})
    EXPECT_EQ(a.ToDenoiseInput().albedo[std::size_t(half)],
              b.ToDenoiseInput().albedo[std::size_t(half)]);
}

TEST(AovFilm, GoesOnAfterItWasSaved) {
  for (const bool denoise : {false, true}) {
    AovFilm whole = FilmOf(denoise), first = FilmOf(denoise);
    AddSamples(0, 70, whole);
    AddSamples(0, 33, first);
    AovFilm second = Loaded(Saved(first));
    EXPECT_TRUE(second.SetNames(Names));
    AddSamples(33, 70, second);
    ExpectSame(second, whole);
    EXPECT_FALSE(second.SetNames({{"a", "c"}, {"red"}, {0, 0}}));
  }
}

TEST(AovFilm, PartsAddUpToTheWholeInAnyOrder) {
  for (const bool denoise : {false, true}) {
    AovFilm whole = FilmOf(denoise), sum = FilmOf(denoise);
    AddSamples(0, 70, whole);
    for (const auto& [first, last] : {std::pair(33u, 51u), {51u, 70u}, {0u, 33u}}) {
      AovFilm part = FilmOf(denoise);
      AddSamples(first, last, part);
      sum.Add(part);
    }
    ExpectSame(sum, whole);
    AovFilm larger = whole.Like({0, 0, 9, 9});
    larger.Add(whole);
    EXPECT_EQ(larger.SampleCount(3, 2), whole.SampleCount(3, 2));
  }
}

TEST(AovFilm, TellsWhatItIs) {
  scene::AovSet two;
  two.Add(scene::Aov::Depth);
  two.Add(scene::Aov::Albedo);
  const AovFilm film(Rect, two, {""}, false), other(Rect, two, {""}, true);
  EXPECT_EQ(film.Difference(other), "layers albedo, depth, not albedo, depth, denoising");
  EXPECT_EQ(film.Difference(film), "");
  EXPECT_EQ(film.Difference(AovFilm(Rect, two, {"", "key"}, false)), "other light groups");
}

TEST(AovFilm, RefusesWhatItHasNotSaved) {
  AovFilm film = FilmOf(false);
  AddSamples(0, 20, film);
  const std::string saved = Saved(film);
  for (std::size_t length = 0; length < saved.size(); length += 3)
    EXPECT_THROW(Loaded(saved.substr(0, length)), Error) << length;
  EXPECT_THROW(Loaded(saved + "x"), Error);
  EXPECT_THROW(Loaded(saved, {0, 0, 60000, 60000}), Error);
  // Damage gives another film or an error
  for (std::size_t i = 0; i < saved.size(); ++i) {
    std::string bad = saved;
    bad[i] = char(bad[i] ^ 0x81);
    try {
      Loaded(bad).ToLayers();
    } catch (const Error&) {
    }
  }
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
