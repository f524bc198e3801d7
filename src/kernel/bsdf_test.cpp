// SPDX-License-Identifier: Apache-2.0
//
// Scattering of physical surfaces: samples fall as the density says (χ² over the whole sphere), their weights are
// what evaluation gives, what is reflected one way is reflected the other, and the lobes' published limits hold.
#include "kernel/bsdf.h"

#include <gtest/gtest.h>

#include "support/random.h"
#include "support/statistics.h"

namespace snell::kernel {
namespace {

Bsdf Empty() {
  Bsdf b = {};
  b.alpha = b.coatAlpha = vec2(0.3f, 0.3f);
  b.eta = b.etaFresnel = b.coatEta = 1.5f;
  b.metalTint = b.metalScale = b.coatTint = b.underCoat = Spectrum(1.0f);
  b.metalWeight = 1;
  b.fuzzAlpha = 0.3f;
  b.underFuzz = 1;
  b.filmEta = 1.3f;
  b.filmPath = 2 * 1.3f * 0.4f;
  b.metalEta = {0.2f, 0.9f, 1.3f};
  b.metalK = {3.3f, 2.4f, 1.9f};
  return b;
}

Bsdf Matt() {
  Bsdf b = Empty();
  b.diffuse = b.diffuseColor = {0.8f, 0.5f, 0.3f};
  b.diffuseRoughness = 0.7f;
  b.pickDiffuse = 1;
  return b;
}

Bsdf Metal() {
  Bsdf b = Empty();
  b.alpha = vec2(0.5f, 0.15f);
  b.metalness = 1;
  b.metalF0 = {0.9f, 0.7f, 0.4f};
  b.metalTint = {0.8f, 0.9f, 1.0f};
  b.pickBase = 1;
  return b;
}

Bsdf Glass(float eta) {
  Bsdf b = Empty();
  b.alpha = vec2(0.4f, 0.2f);
  b.eta = b.etaFresnel = eta;
  b.reflectionScale = b.transmissionScale = Spectrum(1.0f);
  b.pickBase = 1;
  return b;
}

Bsdf Pane() {
  Bsdf b = Glass(1.5f);
  b.thin = 1;
  return b;
}

Bsdf FilmOnGlass() {
  Bsdf b = Glass(1.5f);
  b.film = 0.8f;
  return b;
}

Bsdf FilmOnMetal() {
  Bsdf b = Metal();
  b.film = 1;
  return b;
}

// A coat that is brushed and whose normal is not that of the base.
Bsdf TiltedCoat() {
  Bsdf b = Matt();
  b.coat = 1;
  b.coatScale = 1;
  b.coatAlpha = vec2(0.4f, 0.15f);
  b.coatTilted = 1;
  b.coatZ = Normalize(vec3(0.2f, -0.1f, 1));
  b.coatX = Normalize(vec3(1, 0, 0) - b.coatZ * b.coatZ.x);
  b.pickCoat = 0.4f;
  b.pickDiffuse = 0.6f;
  return b;
}

Bsdf Everything() {
  Bsdf b = Matt();
  b.metalness = 0.3f;
  b.metalF0 = {0.9f, 0.7f, 0.4f};
  b.reflectionScale = b.transmissionScale = Spectrum(0.6f);
  b.diffuseTransmission = Spectrum(0.2f);
  b.coat = 0.5f;
  b.coatScale = 0.35f;
  b.coatTint = {0.9f, 0.5f, 0.5f};
  b.coatAlpha = vec2(0.2f, 0.2f);
  b.underCoat = Spectrum(0.8f);
  b.fuzz = Spectrum(0.3f);
  b.underFuzz = 0.7f;
  b.pickCoat = 0.15f;
  b.pickBase = 0.3f;
  b.pickDiffuse = 0.25f;
  b.pickDiffuseTransmission = 0.1f;
  b.pickFuzz = 0.2f;
  return b;
}

vec3 At(float cosine, float phi) {
  const float sine = std::sqrt(1 - cosine * cosine);
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

// What the density says of each cell of cosine and angle, by the midpoint rule.
constexpr int Rows = 40;
constexpr int Columns = 40;
std::vector<double> Expected(const Bsdf& b, vec3 wo, double count) {
  constexpr int Fine = 24;
  std::vector<double> cells(Rows * Columns, 0);
  for (int row = 0; row < Rows * Fine; ++row) {
    for (int column = 0; column < Columns * Fine; ++column) {
      const float cosine = 2 * (float(row) + 0.5f) / float(Rows * Fine) - 1;
      const float phi = 2 * Pi * (float(column) + 0.5f) / float(Columns * Fine) - Pi;
      float pdf;
      EvalBsdf(b, wo, At(cosine, phi), pdf);
      cells[std::size_t(row / Fine * Columns + column / Fine)] +=
          double(pdf) * count * 4 * double(Pi) / double(Rows * Fine) / double(Columns * Fine);
    }
  }
  return cells;
}

TEST(Bsdf, SamplesFallAsTheirDensitySays) {
  const Bsdf all[] = {Matt(),
                      Metal(),
                      Glass(1.5f),
                      Glass(1 / 1.5f),
                      Pane(),
                      FilmOnGlass(),
                      FilmOnMetal(),
                      TiltedCoat(),
                      Everything(),
                      OnlyLobes(Everything(), LOBE_SPECULAR | LOBE_DIFFUSE),
                      OnlyLobes(Everything(), LOBE_REFRACTION | LOBE_DIFFUSE_TRANSMISSION)};
  const float cosines[] = {0.95f, 0.5f, 0.15f};
  test::Random random(91);
  const int tests = int(std::size(all) * std::size(cosines));
  for (std::size_t kind = 0; kind < std::size(all); ++kind) {
    for (const float cosine : cosines) {
      const Bsdf& b = all[kind];
      const vec3 wo = At(cosine, 0.8f);
      const std::uint64_t count = test::Scaled(400000);
      std::vector<double> observed(Rows * Columns, 0);
      for (std::uint64_t i = 0; i < count; ++i) {
        const float lobe = random.UniformFloat();
        const vec2 u(random.UniformFloat(), random.UniformFloat());
        const BsdfSample s = SampleBsdf(b, wo, lobe, u);
        if (s.pdf <= 0) continue;
        ASSERT_NEAR(Length(s.wi), 1, 1e-3);
        ASSERT_EQ(s.transmitted == 1, s.wi.z < 0);
        const int row = std::clamp(int((s.wi.z + 1) / 2 * Rows), 0, Rows - 1);
        const int column = std::clamp(int((std::atan2(s.wi.y, s.wi.x) / (2 * Pi) + 0.5f) * Columns),
                                      0, Columns - 1);
        observed[std::size_t(row * Columns + column)] += 1;
      }
      EXPECT_GT(test::ChiSquarePValue(observed, Expected(b, wo, double(count))),
                test::Sidak(0.01, tests))
          << "kind " << kind << ", cosine " << cosine;
    }
  }
}

TEST(Bsdf, WeightsAreWhatEvaluationGives) {
  test::Random random(92);
  for (const Bsdf& b : {Matt(), Metal(), Glass(1.5f), Glass(1 / 1.5f), Pane(), FilmOnGlass(),
                        FilmOnMetal(), TiltedCoat(), Everything()}) {
    for (int i = 0; i < 10000; ++i) {
      const vec3 wo = At(0.02f + 0.97f * random.UniformFloat(), 6 * random.UniformFloat());
      const float lobe = random.UniformFloat();
      const BsdfSample s =
          SampleBsdf(b, wo, lobe, vec2(random.UniformFloat(), random.UniformFloat()));
      if (s.pdf <= 0) continue;
      float pdf;
      const Spectrum f = EvalBsdf(b, wo, s.wi, pdf);
      ASSERT_FLOAT_EQ(pdf, s.pdf);
      ASSERT_NEAR(s.weight.y, f.y / pdf, 1e-5f * s.weight.y);
      ASSERT_GE(s.weight.x, 0);
    }
  }
}

// The kinds of lobes add up to the whole, and no sample is of a kind that is left out.
TEST(Bsdf, LobesOfAllKindsAddUp) {
  test::Random random(94);
  for (const Bsdf& b :
       {Matt(), Metal(), Glass(1.5f), Glass(1 / 1.5f), Pane(), TiltedCoat(), Everything()}) {
    for (int i = 0; i < 1000; ++i) {
      const vec3 wo = At(0.05f + 0.9f * random.UniformFloat(), 6 * random.UniformFloat());
      vec3 wi = At(0.05f + 0.9f * random.UniformFloat(), 6 * random.UniformFloat());
      if (i % 2 == 0) wi.z = -wi.z;
      float pdf;
      Spectrum sum(0.0f);
      for (const uint lobes :
           {LOBE_DIFFUSE, LOBE_SPECULAR, LOBE_REFRACTION, LOBE_DIFFUSE_TRANSMISSION}) {
        const Bsdf only = OnlyLobes(b, lobes);
        sum += EvalBsdf(only, wo, wi, pdf);
        const BsdfSample s = SampleBsdf(only, wo, random.UniformFloat(),
                                        vec2(random.UniformFloat(), random.UniformFloat()));
        if (s.pdf <= 0 || MaxChannel(s.weight) <= 0) continue;
        EXPECT_EQ(s.isDiffuse, lobes == LOBE_DIFFUSE ? 1u : 0u);
        EXPECT_EQ(s.transmitted, lobes >= LOBE_REFRACTION ? 1u : 0u);
      }
      const Spectrum whole = EvalBsdf(b, wo, wi, pdf);
      ASSERT_NEAR(sum.x, whole.x, 1e-4f * whole.x + 1e-6f);
    }
  }
}

TEST(Bsdf, ReflectionIsReciprocal) {
  test::Random random(93);
  for (const Bsdf& b :
       {Matt(), Metal(), Glass(1.5f), Pane(), FilmOnGlass(), FilmOnMetal(), Everything()}) {
    for (int i = 0; i < 1000; ++i) {
      const vec3 wo = At(0.05f + 0.9f * random.UniformFloat(), 6 * random.UniformFloat());
      const vec3 wi = At(0.05f + 0.9f * random.UniformFloat(), 6 * random.UniformFloat());
      float pdf;
      const float there = EvalBsdf(b, wo, wi, pdf).x / wi.z;
      const float back = EvalBsdf(b, wi, wo, pdf).x / wo.z;
      ASSERT_NEAR(there, back, 2e-4f * (there + back) + 1e-6f);
    }
  }
}

// Radiance over the square of the index is what is reciprocal through a boundary.
TEST(Bsdf, RefractionIsReciprocalUpToTheIndices) {
  test::Random random(94);
  const Bsdf enters = Glass(1.5f), leaves = Glass(1 / 1.5f);
  for (int i = 0; i < 1000; ++i) {
    const vec3 wo = At(0.1f + 0.85f * random.UniformFloat(), 6 * random.UniformFloat());
    const vec3 wi = -At(0.1f + 0.85f * random.UniformFloat(), 6 * random.UniformFloat());
    float pdf;
    const float in = EvalBsdf(enters, wo, wi, pdf).x / -wi.z;
    // The other way the surface is seen from below
    const vec3 from(wi.x, -wi.y, -wi.z), to(wo.x, -wo.y, -wo.z);
    const float out = EvalBsdf(leaves, from, to, pdf).x / wo.z;
    ASSERT_NEAR(in * 1.5f, out / 1.5f, 1e-3f * (in + out) + 1e-5f);
  }
}

TEST(Bsdf, SmoothSurfacesReflectByFresnelAndRefractBySnell) {
  Bsdf b = Glass(1.5f);
  b.alpha = vec2(1e-4f, 1e-4f);
  const vec3 wo = At(0.6f, 0);
  float reflected = 0, refracted = 0;
  for (int i = 0; i < 1000; ++i) {
    const BsdfSample s = SampleBsdf(b, wo, (float(i) + 0.5f) / 1000, vec2(0.3f, 0.7f));
    ASSERT_EQ(s.isSpecular, 1u);
    if (s.transmitted == 1) {
      EXPECT_NEAR(s.wi.x, -wo.x / 1.5f, 1e-6f);
      EXPECT_NEAR(s.weight.x, 1 / 2.25f, 1e-5f);  // radiance in the denser medium is greater
      refracted += 1;
    } else {
      EXPECT_NEAR(s.wi.x, -wo.x, 1e-6f);
      reflected += 1;
    }
  }
  EXPECT_NEAR(reflected / 1000, FrOfEta(0.6f, 1.5f), 2e-3);
  EXPECT_NEAR(refracted / 1000, 1 - FrOfEta(0.6f, 1.5f), 2e-3);
  float pdf;
  EXPECT_EQ(EvalBsdf(b, wo, At(0.6f, Pi), pdf), Spectrum(0.0f));
  EXPECT_EQ(pdf, 0);
}

// A film absorbs nothing: what a facet does not reflect it lets through.
TEST(Bsdf, FilmsOnGlassShareTheLight) {
  Bsdf b = FilmOnGlass();
  for (const float cosine : {1.0f, 0.7f, 0.3f, 0.05f}) {
    const BaseSplit split = SplitAtBase(b, cosine);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(split.reflectance[c] + split.transmittance[c], 1, 1e-6f);
      EXPECT_GE(split.reflectance[c], 0);
    }
  }
}

// The colour of a coat is what is left of light that crosses it down and up again.
TEST(Bsdf, CoatsTakeTheirColourOnBothWays) {
  const Spectrum color(0.81f, 0.5f, 0.1f);
  const Spectrum once = CoatPassage(1, 1.6f, color, 1);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(once[c] * once[c], color[c], 1e-5f);
  EXPECT_LT(CoatPassage(1, 1.6f, color, 0.2f).z, once.z);
  EXPECT_EQ(CoatPassage(0.5f, 1.6f, Spectrum(1.0f), 0.3f), Spectrum(1.0f));
}

TEST(EvalEon, KeepsAllEnergyAndIsLambertWhenSmooth) {
  const vec3 wo = At(0.4f, 1);
  EXPECT_EQ(EvalEon(Spectrum(0.7f), Spectrum(0.7f), 0, wo, At(0.3f, 2)), Spectrum(0.7f) * InvPi);
  for (const float roughness : {0.2f, 0.6f, 1.0f}) {
    double sum = 0;
    constexpr int Steps = 300;
    for (int i = 0; i < Steps; ++i) {
      for (int j = 0; j < Steps; ++j) {
        const float z = (float(i) + 0.5f) / Steps;
        sum += double(EvalEon(Spectrum(1.0f), Spectrum(1.0f), roughness, wo,
                              At(z, 2 * Pi * (float(j) + 0.5f) / Steps))
                          .x *
                      z);
      }
    }
    // The published fit of the single-scattering albedo is good to a thousandth
    EXPECT_NEAR(sum * 2 * double(Pi) / Steps / Steps, 1, 2e-3) << roughness;
  }
}

TEST(FrConductorF82, MeetsItsTwoColours) {
  const Spectrum f0(0.9f, 0.6f, 0.3f), tint(0.5f, 0.8f, 1.0f);
  const Spectrum normal = FrConductorF82(f0, tint, 1);
  const Spectrum grazing = FrConductorF82(f0, tint, 1.0f / 7);
  const Spectrum schlick = FrSchlick(f0, 1.0f / 7);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(normal[c], f0[c], 1e-6f);
    EXPECT_NEAR(grazing[c], schlick[c] * tint[c], 1e-5f);
    EXPECT_NEAR(FrConductorF82(f0, tint, 0)[c], 1, 1e-5f);
  }
}

// What lies below a coat or fuzz gets no brighter when the lobes above are left out.
TEST(Bsdf, LobesLeftOutStillShadeWhatIsBelow) {
  const vec3 wo(0.6f, 0.0f, 0.8f), wi(0.0f, -0.6f, 0.8f);
  Bsdf coated = DiffuseBsdf(Spectrum(0.5f, 0.5f, 0.5f));
  coated.coat = 1;
  coated.coatEta = 1.5f;
  coated.underCoat = Spectrum(0.6f, 0.6f, 0.6f);
  coated.pickCoat = 0.375f;
  coated.pickDiffuse = 0.625f;
  Bsdf fuzzy = DiffuseBsdf(Spectrum(0.5f, 0.5f, 0.5f));
  fuzzy.underFuzz = 0.7f;
  for (const Bsdf& whole : {coated, fuzzy}) {
    const Bsdf below = OnlyLobes(whole, LOBE_DIFFUSE);
    EXPECT_FLOAT_EQ(below.pickDiffuse, 1.0f);
    float pdf;
    const float expected = EvalBsdf(whole, wo, wi, pdf).x;
    EXPECT_LT(expected, 0.36f * wi.z * InvPi);
    EXPECT_EQ(EvalBsdf(below, wo, wi, pdf).x, expected);
    EXPECT_LT(SampleBsdf(below, wo, 0.5f, vec2(0.3f, 0.6f)).weight.x, 0.36f);
  }
}

}  // namespace
}  // namespace snell::kernel
