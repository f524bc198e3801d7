// SPDX-License-Identifier: Apache-2.0
//
// The classic view of physical materials: lobes that integrate to what their formulas promise, and no surface
// that gives back more light than it gets.
#include "kernel/physical.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace snell::kernel {
namespace {

constexpr int Steps = 400;

// The share of light from everywhere that goes one way, by the midpoint rule over the hemisphere.
template <class Eval>
float Albedo(const Eval& eval) {
  double sum = 0;
  for (int i = 0; i < Steps; ++i) {
    const float cosine = (float(i) + 0.5f) / float(Steps);
    const float sine = std::sqrt(1 - cosine * cosine);
    for (int j = 0; j < Steps; ++j) {
      const float phi = 2 * Pi * (float(j) + 0.5f) / float(Steps);
      const vec3 wi(sine * std::cos(phi), sine * std::sin(phi), cosine);
      sum += double(eval(wi)) * 2 * double(Pi) / double(Steps) / double(Steps);
    }
  }
  return float(sum);
}

vec3 At(float cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

TEST(GgxLobe, LosesOnlyWhatItsMaskingTakes) {
  const vec3 n(0, 0, 1);
  for (const float alpha : {0.1f, 0.3f, 0.7f, 1.0f}) {
    for (const float cosine : {1.0f, 0.7f, 0.4f}) {
      const vec3 wo = At(cosine);
      const float albedo =
          Albedo([&](vec3 wi) { return GgxLobe(alpha, wo.z, wi.z, Dot(n, Normalize(wo + wi))); });
      EXPECT_LE(albedo, 1.003f) << alpha << " " << cosine;
      EXPECT_GE(albedo, alpha < 0.2f ? 0.95f : 0.3f) << alpha << " " << cosine;
      // At normal incidence and width 1 the integral is 1 − ln 2
      if (alpha == 1.0f && cosine == 1.0f) {
        EXPECT_NEAR(albedo, 0.306853f, 1e-4f);
      }
    }
  }
}

TEST(EvalPhysical, IsReciprocal) {
  test::Random random(81);
  PhysicalPoint point = NoPhysicalPoint();
  point.diffuse = {0.5f, 0.3f, 0.2f};
  point.f0 = {0.04f, 0.05f, 0.06f};
  point.alpha = 0.3f;
  point.fuzz = {0.2f, 0.2f, 0.3f};
  point.fuzzAlpha = 0.4f;
  point.coat = 0.7f;
  point.coatF0 = 0.05f;
  point.coatAlpha = 0.1f;
  const vec3 n(0, 0, 1);
  for (int i = 0; i < 1000; ++i) {
    const vec3 a = At(0.05f + 0.95f * random.UniformFloat());
    const vec3 b = Normalize(vec3(random.UniformFloat() - 0.5f, random.UniformFloat() - 0.5f,
                                  0.05f + random.UniformFloat()));
    const Spectrum forth = EvalPhysical(point, n, a, b) * a.z;
    const Spectrum back = EvalPhysical(point, n, b, a) * b.z;
    EXPECT_NEAR(forth.x, back.x, 1e-4f * (1 + forth.x));
  }
}

TEST(EvalPhysical, ConservesEnergy) {
  const vec3 n(0, 0, 1);
  for (const float f0 : {0.0f, 0.04f, 1.0f}) {
    for (const float alpha : {0.1f, 0.5f, 1.0f}) {
      for (const float coat : {0.0f, 1.0f}) {
        PhysicalPoint point = NoPhysicalPoint();
        point.diffuse = Spectrum(f0 < 1 ? 1.0f : 0.0f);
        point.f0 = Spectrum(f0);
        point.alpha = alpha;
        point.coat = coat;
        point.coatF0 = 0.04f;
        point.coatAlpha = 0.1f;
        for (const float cosine : {1.0f, 0.6f}) {
          const vec3 wo = At(cosine);
          const float albedo = Albedo([&](vec3 wi) { return EvalPhysical(point, n, wo, wi).x; });
          EXPECT_LE(albedo, 1.06f) << f0 << " " << alpha << " " << coat << " " << cosine;
        }
      }
    }
  }
}

TEST(MirrorShare, FadesWithRoughness) {
  EXPECT_GT(MirrorShare(HighlightAlpha(0.0f)), 0.4f);
  EXPECT_EQ(MirrorShare(HighlightAlpha(0.6f)), 0.0f);
  float last = 1;
  for (float roughness = 0; roughness < 1; roughness += 0.05f) {
    const float share = MirrorShare(HighlightAlpha(roughness));
    EXPECT_LE(share, last);
    last = share;
  }
}

}  // namespace
}  // namespace snell::kernel
