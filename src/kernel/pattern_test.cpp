// SPDX-License-Identifier: Apache-2.0
//
// Noise and the procedural patterns: closed forms where there are some, range, mean, continuity, calm on
// surfaces that lie on cell borders, and sanity at any finite point.
#include "kernel/pattern.h"

#include <gtest/gtest.h>

#include "support/random.h"
#include "support/statistics.h"

namespace snell::kernel {
namespace {

Texture MakeTexture(uint kind, uint smooth = 0, float turbulence = 0) {
  Texture texture = {};
  texture.kind = kind;
  texture.colorB = Spectrum(1.0f);
  texture.turbulence = turbulence;
  texture.octaves = 4;
  texture.smoothEdges = smooth;
  return texture;
}

TEST(Noise, IsZeroAtTheLattice) {
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      for (int z = -5; z <= 5; ++z) EXPECT_EQ(Noise(vec3(float(x), float(y), float(z))), 0.0f);
    }
  }
}

TEST(Noise, HasItsRangeMeanAndSymmetry) {
  test::Random random(91);
  test::Moments moments, positive;
  double extreme = 0;
  for (std::uint64_t i = 0; i < test::Scaled(1000000); ++i) {
    const double n = double(Noise(vec3(random.InCube() * 500.0)));
    moments.Add(n);
    positive.Add(n > 0 ? 1 : 0);
    extreme = std::max(extreme, std::abs(n));
  }
  EXPECT_NEAR(moments.Mean(), 0, 2e-3);
  EXPECT_NEAR(positive.Mean(), 0.5, 5e-3);
  EXPECT_GT(moments.Variance(), 0.03);
  EXPECT_GT(extreme, 0.7);
  EXPECT_LE(extreme, 1.04);
}

TEST(Noise, IsContinuousWithItsSlope) {
  test::Random random(92);
  for (int i = 0; i < 200000; ++i) {
    // Along an axis, across a lattice plane every second time
    const int axis = int(random.Index(3));
    vec3 p(random.InCube() * 50.0);
    if (random.Chance(0.5)) p[axis] = std::round(p[axis]);
    constexpr float H = 1.0f / 128;
    vec3 step(0.0f);
    step[axis] = H;
    const float before = Noise(p - step), here = Noise(p), after = Noise(p + step);
    ASSERT_LT(std::abs(after - here), 4 * H);
    // The second difference is of second order: no kink
    ASSERT_LT(std::abs(after - 2 * here + before), 40 * H * H);
  }
}

TEST(Noise, IsAboutTheSameAlongAllAxes) {
  test::Random random(93);
  test::Moments slope[3];
  for (int i = 0; i < 300000; ++i) {
    const vec3 p(random.InCube() * 200.0);
    for (int axis = 0; axis < 3; ++axis) {
      vec3 step(0.0f);
      step[axis] = 1.0f / 64;
      slope[axis].Add(double(Noise(p + step) - Noise(p)) * 64);
    }
  }
  const double mean = (slope[0].Variance() + slope[1].Variance() + slope[2].Variance()) / 3;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(slope[axis].Mean(), 0, 0.01);
    EXPECT_NEAR(slope[axis].Variance() / mean, 1, 0.15);  // 16 gradients, 4 of the 12 twice
  }
}

TEST(FractalNoise, AddsOctaves) {
  const vec3 p(0.3f, 1.7f, -2.2f);
  EXPECT_EQ(FractalNoise(p, 0u), 0.0f);
  EXPECT_EQ(FractalNoise(p, 1u), Noise(p));
  EXPECT_FLOAT_EQ(FractalNoise(p, 2u), Noise(p) + 0.5f * Noise(p * 2.03f));
}

TEST(Checker, AlternatesAlongEveryAxis) {
  const Texture checker = MakeTexture(TEXTURE_CHECKER);
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      for (int z = -6; z <= 6; ++z) {
        const vec3 middle(float(x) + 0.5f, float(y) + 0.5f, float(z) + 0.5f);
        EXPECT_EQ(PatternBlend(checker, middle), (x + y + z) % 2 == 0 ? 0.0f : 1.0f);
      }
    }
  }
}

TEST(Checker, IsCalmOnIntegerPlanes) {
  // A plane at an integer height, with heights that rounding makes a little larger or smaller
  test::Random random(94);
  const Texture checker = MakeTexture(TEXTURE_CHECKER);
  const Texture stripes = MakeTexture(TEXTURE_STRIPES);
  for (int i = 0; i < 100000; ++i) {
    const float height = float(int(random.Index(21)) - 10);
    vec3 p(random.InCube() * 30.0);
    p.y = height;
    const float exact = PatternBlend(checker, p);
    p.y = height + float(random.Uniform(-1e-4, 1e-4));
    ASSERT_EQ(PatternBlend(checker, p), exact);
    const float stripe = PatternBlend(stripes, vec3(height, p.y, p.z));
    ASSERT_EQ(PatternBlend(stripes, vec3(height + float(random.Uniform(-1e-4, 1e-4)), p.y, p.z)),
              stripe);
  }
}

TEST(Patterns, AreSaneAtAnyFinitePoint) {
  test::Random random(95);
  for (const uint kind :
       {TEXTURE_CHECKER, TEXTURE_STRIPES, TEXTURE_GRADIENT, TEXTURE_MARBLE, TEXTURE_WOOD}) {
    for (const uint smooth : {0u, 1u}) {
      const Texture texture = MakeTexture(kind, smooth, 1.5f);
      for (int i = 0; i < 20000; ++i) {
        const double size = random.LogUniform(1e-3, 1e18);
        const float blend = PatternBlend(texture, vec3(random.InCube() * size));
        ASSERT_TRUE(blend >= -1e-6f && blend <= 1.000001f) << kind << " " << size;
      }
    }
  }
}

TEST(Stripes, AreHalfAndHalf) {
  const Texture sharp = MakeTexture(TEXTURE_STRIPES);
  EXPECT_EQ(PatternBlend(sharp, vec3(0.25f, 9, 9)), 0.0f);
  EXPECT_EQ(PatternBlend(sharp, vec3(0.75f, 9, 9)), 1.0f);
  EXPECT_EQ(PatternBlend(sharp, vec3(-0.25f, 9, 9)), 1.0f);
  const Texture smooth = MakeTexture(TEXTURE_STRIPES, 1);
  EXPECT_NEAR(PatternBlend(smooth, vec3(0 - PatternShift, 0, 0)), 0.0f, 1e-6f);
  EXPECT_NEAR(PatternBlend(smooth, vec3(0.5f - PatternShift, 0, 0)), 1.0f, 1e-6f);
  EXPECT_NEAR(PatternBlend(smooth, vec3(0.25f - PatternShift, 0, 0)), 0.5f, 1e-6f);
}

TEST(Gradient, RunsAlongY) {
  const Texture gradient = MakeTexture(TEXTURE_GRADIENT);
  EXPECT_EQ(PatternBlend(gradient, vec3(5, -1, 0)), 0.0f);
  EXPECT_EQ(PatternBlend(gradient, vec3(5, 0.25f, 0)), 0.25f);
  EXPECT_EQ(PatternBlend(gradient, vec3(5, 2, 0)), 1.0f);
}

TEST(MarbleAndWood, HaveClosedFormsWithoutTurbulence) {
  const Texture marble = MakeTexture(TEXTURE_MARBLE, 1);
  const Texture wood = MakeTexture(TEXTURE_WOOD, 1);
  for (int i = 0; i < 200; ++i) {
    const double x = -3 + 0.031 * i;
    EXPECT_NEAR(double(PatternBlend(marble, vec3(float(x), 2, 1))),
                0.5 + 0.5 * std::cos(6.283185307179586 * x), 1e-5);
    const double ring = std::hypot(x, 0.7);
    EXPECT_NEAR(double(PatternBlend(wood, vec3(float(x), 5, 0.7f))),
                0.5 + 0.5 * std::cos(6.283185307179586 * ring), 1e-5);
  }
}

TEST(EvalPattern, BlendsTheColours) {
  Texture gradient = MakeTexture(TEXTURE_GRADIENT);
  gradient.colorA = Spectrum(1, 0, 0.5f);
  gradient.colorB = Spectrum(0, 1, 0.5f);
  const Spectrum c = EvalPattern(gradient, vec3(0, 0.25f, 0));
  EXPECT_FLOAT_EQ(c.x, 0.75f);
  EXPECT_FLOAT_EQ(c.y, 0.25f);
  EXPECT_FLOAT_EQ(c.z, 0.5f);
}

}  // namespace
}  // namespace snell::kernel
