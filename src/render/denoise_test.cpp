// SPDX-License-Identifier: Apache-2.0
//
// The built-in denoiser on pictures whose truth is known: noise goes, edges stay, nothing is invented.
#include "render/denoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "util/threads.h"

namespace snell::render {
namespace {

constexpr int Size = 48;

// A picture in the making: what is seen without noise, and of what surface.
struct Truth {
  std::vector<vec3> color, albedo, normal;
  std::vector<float> nearness;
};

template <class Function>
Truth TruthOf(Function pixel) {
  Truth truth;
  for (int y = 0; y < Size; ++y) {
    for (int x = 0; x < Size; ++x) {
      vec3 color, albedo, normal(0, 0, 1);
      pixel(x, y, color, albedo);
      truth.color.push_back(color);
      truth.albedo.push_back(albedo);
      truth.normal.push_back(normal);
      truth.nearness.push_back(0.5f);
    }
  }
  return truth;
}

// `samples` samples a half whose values scatter around the truth, relative to it, by `noise`.
DenoiseInput Noisy(const Truth& truth, float noise, int samples) {
  DenoiseInput input{Size, Size, {}, {}, {}, {}, {}};
  std::mt19937 random(7);
  std::gamma_distribution<float> factor(1 / (noise * noise), noise * noise);
  for (const vec3& color : truth.color) {
    vec3 sums[2] = {vec3(0.0f), vec3(0.0f)}, squares(0.0f);
    for (int half = 0; half < 2; ++half) {
      for (int i = 0; i < samples; ++i) {
        const vec3 value = noise > 0 ? color * factor(random) : color;
        sums[half] += value;
        squares += value * value;
      }
      input.color[std::size_t(half)].push_back(sums[half] / float(samples));
    }
    const float n = float(2 * samples);
    const vec3 mean = (sums[0] + sums[1]) / n;
    vec3 variance = noise > 0 ? (squares / n - mean * mean) / (n - 1) : vec3(0.0f);
    for (int c = 0; c < 3; ++c) variance[c] = std::max(variance[c], 0.0f);
    input.variance.push_back(variance);
  }
  input.albedo = {truth.albedo, truth.albedo};
  input.normal = {truth.normal, truth.normal};
  input.nearness = {truth.nearness, truth.nearness};
  return input;
}

double Rmse(const std::vector<vec3>& a, const std::vector<vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double difference = double(a[i][c]) - double(b[i][c]);
      sum += difference * difference;
    }
  }
  return std::sqrt(sum / double(3 * a.size()));
}

std::vector<vec3> Mean(const DenoiseInput& input) {
  std::vector<vec3> mean;
  for (std::size_t i = 0; i < input.Pixels(); ++i)
    mean.push_back((input.color[0][i] + input.color[1][i]) * 0.5f);
  return mean;
}

// Light that falls off smoothly on a checker.
Truth Checker() {
  return TruthOf([](int x, int y, vec3& color, vec3& albedo) {
    albedo = (x / 6 + y / 6) % 2 == 0 ? vec3(0.8f, 0.6f, 0.4f) : vec3(0.1f, 0.2f, 0.3f);
    const float dx = float(x - 20) / 30, dy = float(y - 15) / 30;
    color = albedo / (1 + dx * dx + dy * dy);
  });
}

TEST(Denoise, WithoutNoiseThePictureStays) {
  const Truth truth = Checker();
  const image::Image result = DenoiseByRegression(Noisy(truth, 0, 4));
  EXPECT_LT(Rmse(result.pixels, truth.color), 2e-3);
}

TEST(Denoise, TheErrorFallsToAFraction) {
  const Truth truth = Checker();
  const DenoiseInput input = Noisy(truth, 1, 8);
  const double before = Rmse(Mean(input), truth.color);
  EXPECT_GT(before, 0.08);
  EXPECT_LT(Rmse(DenoiseByRegression(input).pixels, truth.color), before / 5);
}

TEST(Denoise, EdgesOfColorsStaySharp) {
  const Truth truth = Checker();
  const image::Image result = DenoiseByRegression(Noisy(truth, 1, 8));
  double steps = 0, expected = 0;
  for (int y = 0; y < Size; ++y) {
    for (int x = 6; x < Size; x += 6) {
      const std::size_t i = result.Index(x, y);
      steps += std::abs(double(result.pixels[i].x) - double(result.pixels[i - 1].x));
      expected += std::abs(double(truth.color[i].x) - double(truth.color[i - 1].x));
    }
  }
  EXPECT_NEAR(steps, expected, 0.1 * expected);
}

// A shadow that no feature knows of keeps its edge, and there is no halo beside it.
TEST(Denoise, ShadowsHaveNoHalos) {
  const Truth truth = TruthOf([](int x, int, vec3& color, vec3& albedo) {
    albedo = vec3(0.5f);
    color = x < Size / 2 ? vec3(1.0f) : vec3(0.05f);
  });
  const DenoiseInput input = Noisy(truth, 0.5f, 8);
  const image::Image result = DenoiseByRegression(input);
  double left = 0, right = 0;
  for (int y = 0; y < Size; ++y) {
    left += double(result.At(Size / 2 - 2, y).x) / Size;
    right += double(result.At(Size / 2 + 1, y).x) / Size;
  }
  EXPECT_NEAR(left, 1, 0.05);
  EXPECT_NEAR(right, 0.05, 0.02);
  EXPECT_LT(Rmse(result.pixels, truth.color), Rmse(Mean(input), truth.color) / 3);
}

TEST(Denoise, OutliersStayFiniteAndWithinWhatThereIs) {
  Truth truth = Checker();
  DenoiseInput input = Noisy(truth, 1, 4);
  for (std::size_t i = 40; i < input.Pixels(); i += 131) {
    input.color[0][i] = vec3(1e6f, 1e3f, 1e5f);
    input.variance[i] = vec3(1e11f);
    input.albedo[1][i] = vec3(0.0f);
  }
  for (const vec3& color : DenoiseByRegression(input).pixels) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(std::isfinite(color[c]));
      EXPECT_GE(color[c], 0);
      EXPECT_LE(color[c], 1e6f);
    }
  }
}

TEST(Denoise, IsTheSameOnAnyNumberOfThreads) {
  const DenoiseInput input = Noisy(Checker(), 1, 4);
  const image::Image all = DenoiseByRegression(input);
  const ThreadLimit limit(1);
  EXPECT_EQ(DenoiseByRegression(input).pixels, all.pixels);
}

TEST(Denoise, TakesPicturesOfAnySize) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 40), std::pair(33, 2)}) {
    const std::size_t pixels = std::size_t(width * height);
    DenoiseInput input{width, height, {}, {}, {}, {}, {}};
    for (std::size_t half = 0; half < 2; ++half) {
      input.color[half].assign(pixels, vec3(0.25f));
      input.albedo[half].assign(pixels, vec3(0.5f));
      input.normal[half].assign(pixels, vec3(0, 1, 0));
      input.nearness[half].assign(pixels, 0.0f);
    }
    input.variance.assign(pixels, vec3(0.01f));
    for (const vec3& color : DenoiseByRegression(input).pixels) EXPECT_NEAR(color.y, 0.25f, 1e-5f);
  }
}

}  // namespace
}  // namespace snell::render
