// SPDX-License-Identifier: Apache-2.0
//
// The rule by which a surface shares light conserves energy, and a thin sheet's reflectance is the sum of
// its reflections.
#include "kernel/interface.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace snell::kernel {
namespace {

Spectrum RandomSpectrum(test::Random& random) {
  const float x = random.UniformFloat(), y = random.UniformFloat();
  return {x, y, random.UniformFloat()};
}

TEST(ShareLight, GivesBackAllThatItReceives) {
  test::Random random(61);
  for (int i = 0; i < 200000; ++i) {
    // Ends of the range too
    const Spectrum transparency = glm::floor(RandomSpectrum(random) * 4.0f) / 3.0f;
    const Spectrum reflectivity = random.Chance(0.2) ? Spectrum(1.0f) : RandomSpectrum(random);
    const float fresnel = random.Chance(0.2) ? 1.0f : random.UniformFloat();
    const Shares s = ShareLight(transparency, reflectivity, fresnel);
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(s.own[c] + s.reflection[c] + s.refraction[c], 1.0f, 3e-7f);
      ASSERT_TRUE(s.own[c] >= 0 && s.reflection[c] >= 0 && s.refraction[c] >= 0);
    }
  }
}

TEST(ShareLight, HasThePureCases) {
  const Spectrum zero(0.0f), one(1.0f);
  const Shares matt = ShareLight(zero, zero, 0.3f);
  EXPECT_EQ(matt.own, one);
  EXPECT_EQ(matt.reflection, zero);
  EXPECT_EQ(matt.refraction, zero);
  const Shares mirror = ShareLight(zero, one, 0.3f);
  EXPECT_EQ(mirror.own, zero);
  EXPECT_EQ(mirror.reflection, one);
  const Shares glass = ShareLight(one, zero, 0.25f);
  EXPECT_EQ(glass.own, zero);
  EXPECT_EQ(glass.reflection, Spectrum(0.25f));
  EXPECT_EQ(glass.refraction, Spectrum(0.75f));
}

TEST(ReflectivityAt, FollowsItsModel) {
  const Spectrum r(0.2f, 0.5f, 0.8f);
  for (int i = 0; i <= 20; ++i) {
    const float c = float(i) / 20;
    EXPECT_EQ(ReflectivityAt(REFLECTION_CONSTANT, r, c, 1.5f), r);
    EXPECT_EQ(ReflectivityAt(REFLECTION_SCHLICK, r, c, 1.5f), FrSchlick(r, c));
    const float fresnel = FrDielectric(c, RefractedCosine(c, 1.5f), 1.5f);
    EXPECT_EQ(ReflectivityAt(REFLECTION_FRESNEL, r, c, 1.5f), r * fresnel);
  }
}

TEST(SheetReflectance, IsTheSumOfAllReflections) {
  for (int i = 0; i <= 100; ++i) {
    // The first face, then 2, 4, 6 … passages and 1, 3, 5 … reflections between the faces
    const double f = i / 100.0;
    double sum = f;
    double between = (1 - f) * (1 - f) * f;
    for (int k = 0; k < 100000 && between > 1e-12; ++k) {
      sum += between;
      between *= f * f;
    }
    if (i == 100) sum = 1;
    EXPECT_NEAR(double(SheetReflectance(float(f))), sum, 1e-6);
  }
}

}  // namespace
}  // namespace snell::kernel
