// SPDX-License-Identifier: Apache-2.0
//
// The order of samples: passes that add up, goals that a saved film keeps, noise that is judged as it is.
#include "render/schedule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/noise.h"

namespace snell::render {
namespace {

using kernel::Spectrum;

void Fill(Film& film, const std::function<float(int x, int y, std::uint32_t sample)>& radiance) {
  const PixelRect& rect = film.rect();
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      while (film.At(x, y).count < film.At(x, y).goal) {
        const std::uint32_t sample = film.firstSample() + film.At(x, y).count;
        film.Add(x, y, sample, Spectrum(radiance(x, y, sample)));
      }
    }
  }
}

TEST(PlanPass, AddsUpAndBeginsSmall) {
  for (const auto& [first, last] :
       {std::pair(0u, 0u), {0u, 1u}, {0u, 16u}, {0u, 1000u}, {5u, 6u}, {7u, 300u}}) {
    Film film({0, 0, 2, 1}, first);
    std::uint32_t next = 0;
    for (PassPlan plan; (plan = PlanPass(film, last, {})).samples > 0;) {
      EXPECT_EQ(plan.remaining, 2u * (last - first - next));
      EXPECT_EQ(plan.hasPicture, next > 0);
      const std::uint32_t size = std::uint32_t(plan.samples / 2);
      EXPECT_EQ(plan.samples % 2, 0u);
      EXPECT_LE(size, std::max(1u, std::min(next, 64u)));
      Fill(film, [](int, int, std::uint32_t) { return 1.0f; });
      next += size;
      EXPECT_EQ(film.SampleCount(1, 0), next);
    }
    EXPECT_EQ(next, last - first);
  }
}

TEST(PlanPass, FinishesAPassThatWasInterrupted) {
  Film film({0, 0, 2, 1});
  PlanPass(film, 16, {});
  film.Add(0, 0, 0, Spectrum(1.0f));
  const PassPlan plan = PlanPass(film, 16, {});
  EXPECT_EQ(plan.samples, 1u);
  EXPECT_FALSE(plan.hasPicture);
  EXPECT_EQ(film.At(0, 0).goal, 1u);
  EXPECT_EQ(film.At(1, 0).goal, 1u);
}

// Independent samples, uniform in [0, 2·mean).
float Uniform(std::uint32_t key, float mean) {
  std::mt19937 random(key);
  random.discard(3);
  return 2 * mean * float(random() >> 8) / 16777216.0f;
}

TEST(PlanPass, LetsPixelsRestThatHaveReachedTheNoise) {
  // Black on the left, noisy on the right; a target that takes some hundred samples
  Film film({0, 0, 40, 10});
  StopConditions stop;
  stop.noise = 0.01f;
  PassPlan plan;
  while ((plan = PlanPass(film, 4096, stop)).samples > 0) {
    Fill(film, [](int x, int y, std::uint32_t sample) {
      return x < 20 ? 0.0f : Uniform(std::uint32_t(y * 40 + x) * 4096 + sample, 0.5f);
    });
  }
  EXPECT_EQ(plan.resting, 400u);
  EXPECT_EQ(film.SampleCount(0, 0), LeastSamplesForNoise);
  EXPECT_EQ(film.SampleCount(16, 5), LeastSamplesForNoise);
  EXPECT_GT(film.SampleCount(18, 5), LeastSamplesForNoise) << "noise is near";
  // The error of √x is σ/(2√x); here σ² = mean²/3 per sample
  const double expected = std::pow(0.5 / std::sqrt(3.0) / (2 * std::sqrt(0.5)) / 0.01, 2);
  for (int y = 0; y < 10; ++y) {
    EXPECT_GT(film.SampleCount(30, y), 0.6 * expected);
    EXPECT_LT(film.SampleCount(30, y), 2 * expected);
  }
  for (const float error : DisplayErrors(film, 1)) EXPECT_LE(error, stop.noise);
}

TEST(DisplayErrors, AreThoseOfIndependentSamples) {
  Film film({0, 0, 64, 64});
  constexpr std::uint32_t Count = 128;
  for (Film::Pixel& pixel : film.pixels()) pixel.goal = Count;
  Fill(film, [](int x, int y, std::uint32_t sample) {
    return Uniform(std::uint32_t(y * 64 + x) * Count + sample, 0.4f);
  });
  double predicted = 0, found = 0;
  for (const float error : DisplayErrors(film, 1)) predicted += double(error) * double(error);
  const double truth = DisplayValue(0.4, 1);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x)
      found += std::pow(DisplayValue(Film::Brightness(film.Mean(x, y)), 1) - truth, 2);
  }
  EXPECT_NEAR(std::sqrt(predicted / found), 1, 0.1);
}

TEST(DisplayErrors, SeeThatTheHalvesAgreeBetterThanChance) {
  // Each block of eight samples is stratified: its mean is always the same
  Film film({0, 0, 8, 8});
  for (Film::Pixel& pixel : film.pixels()) pixel.goal = 64;
  Fill(film, [](int, int, std::uint32_t sample) { return float(sample % 8); });
  const double independent = std::sqrt(film.SampleVariance(0, 0) / 64);
  const double mean = Film::Brightness(film.Mean(0, 0));
  const double plain = DisplayValue(mean + independent, 1) - DisplayValue(mean, 1);
  for (const float error : DisplayErrors(film, 1)) {
    EXPECT_LT(error, 0.3 * plain);
    EXPECT_GT(error, 0) << "never quite sure";
  }
}

TEST(LargestNearby, SpreadsByTheRadius) {
  std::vector<float> values(7 * 5);
  values[2 * 7 + 3] = 1;
  const std::vector<float> spread = LargestNearby(values, 7, 2);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x)
      EXPECT_EQ(spread[std::size_t(y * 7 + x)], std::abs(x - 3) <= 2 ? 1 : 0);
  }
}

TEST(Interruptions, SaveWhenItIsTime) {
  int saved = 0;
  const SavePlan plan{[&](const Film&) { ++saved; }, 0};
  const StopConditions conditions{0};
  StopFlag flag;
  Interruptions interruptions(conditions, plan, &flag);
  Film film({0, 0, 1, 1});
  EXPECT_TRUE(interruptions.SaveIsDue());
  interruptions.SaveIfDue(film);
  EXPECT_EQ(saved, 1);
  EXPECT_TRUE(interruptions.TimeIsOver(true));
  EXPECT_FALSE(interruptions.TimeIsOver(false)) << "there is no picture yet";
  EXPECT_FALSE(interruptions.Stopped());
  flag.Raise();
  EXPECT_TRUE(interruptions.Stopped() && interruptions.Any(false));
}

}  // namespace
}  // namespace snell::render
