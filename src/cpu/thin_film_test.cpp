// SPDX-License-Identifier: Apache-2.0
//
// Thin films (kernel/thin_film.h) against Airy's formula in complex numbers, wavelength by wavelength, seen by the CIE's
// observer in daylight.
#include "kernel/thin_film.h"

#include <gtest/gtest.h>

#include <complex>
#include <glm/common.hpp>

#include "image/spectrum.h"

namespace snell::kernel {
namespace {

using Complex = std::complex<double>;

constexpr double Tau = 6.283185307179586;

// Amplitudes at a boundary, across and along the plane of incidence, of waves with these indices and cosines.
std::pair<Complex, Complex> Amplitudes(Complex n1, Complex cos1, Complex n2, Complex cos2) {
  return {(n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2),
          (n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2)};
}

double Airy(double cosine, double film, double micrometres, Complex base, double wavelength) {
  const double sine2 = 1 - cosine * cosine;
  const Complex inFilm = std::sqrt(Complex(1 - sine2 / (film * film)));
  const Complex inBase = std::sqrt(1.0 - sine2 / (base * base));
  const auto [across1, along1] = Amplitudes(1, cosine, film, inFilm);
  const auto [across2, along2] = Amplitudes(film, inFilm, base, inBase);
  const Complex wave =
      std::exp(Complex(0, Tau * 2 * film * micrometres * inFilm.real() / wavelength));
  const auto both = [&](Complex a, Complex b) {
    return std::norm((a + b * wave) / (1.0 + a * b * wave));
  };
  return 0.5 * (both(across1, across2) + both(along1, along2));
}

// By channel, with an index of the base for each.
Spectrum Seen(double cosine, double film, double micrometres, const Complex (&base)[3]) {
  glm::dvec3 sum(0.0);
  for (int nanometres = 380; nanometres <= 780; ++nanometres) {
    const glm::dvec3 response = image::DaylightResponse(nanometres);
    for (int c = 0; c < 3; ++c)
      sum[c] += response[c] * Airy(cosine, film, micrometres, base[c], nanometres / 1000.0);
  }
  return Spectrum(glm::clamp(sum, glm::dvec3(0.0), glm::dvec3(1.0)));
}

TEST(ThinFilm, MeanWavesAreTheChannels) {
  for (double path = 0; path < 3.5; path += 0.07) {
    glm::dvec3 expectedRe(0.0), expectedIm(0.0);
    for (int nanometres = 380; nanometres <= 780; ++nanometres) {
      const Complex wave = std::exp(Complex(0, Tau * path * 1000 / nanometres));
      expectedRe += image::DaylightResponse(nanometres) * wave.real();
      expectedIm += image::DaylightResponse(nanometres) * wave.imag();
    }
    Spectrum re, im;
    MeanWave(float(path), re, im);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(double(re[c]), expectedRe[c], 5e-3) << path;
      EXPECT_NEAR(double(im[c]), expectedIm[c], 5e-3) << path;
    }
  }
}

TEST(ThinFilm, OnDielectricsIsAirysSum) {
  for (const double film : {1.3, 1.8, 2.4}) {
    for (const double base : {1.5, 1.0, 2.0}) {
      for (const double micrometres : {0.05, 0.25, 0.55, 1.0}) {
        for (const double cosine : {1.0, 0.7, 0.3, 0.1}) {
          const Complex index(base);
          const Spectrum expected = Seen(cosine, film, micrometres, {index, index, index});
          const Spectrum found = FrFilmOnDielectric(float(cosine), float(film),
                                                    float(2 * micrometres * film), float(base));
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 0.012f)
                << film << " " << base << " " << micrometres << " " << cosine;
        }
      }
    }
  }
}

TEST(ThinFilm, OnConductorsIsAirysSum) {
  const Complex gold[3] = {{0.21, 3.27}, {0.43, 2.45}, {1.33, 1.87}};
  const Complex iron[3] = {{2.88, 3.05}, {2.95, 2.93}, {2.65, 2.81}};
  for (const auto& metal : {gold, iron}) {
    for (const double film : {1.4, 2.2}) {
      for (const double micrometres : {0.1, 0.3, 0.8}) {
        for (const double cosine : {1.0, 0.6, 0.2}) {
          const Complex base[3] = {metal[0], metal[1], metal[2]};
          const Spectrum expected = Seen(cosine, film, micrometres, base);
          const Spectrum found = FrFilmOnConductor(
              float(cosine), float(film), float(2 * micrometres * film),
              {float(base[0].real()), float(base[1].real()), float(base[2].real())},
              {float(base[0].imag()), float(base[1].imag()), float(base[2].imag())});
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 0.015f)
                << film << " " << micrometres << " " << cosine;
        }
      }
    }
  }
}

// A film of no thickness is not there; a thick one reflects as its two faces do without interference.
TEST(ThinFilm, HasTheLimitsOfNoneAndThick) {
  for (const float cosine : {1.0f, 0.6f, 0.2f}) {
    const Spectrum none = FrFilmOnDielectric(cosine, 1.4f, 0, 1.7f);
    EXPECT_NEAR(none.y, FrDielectric(cosine, RefractedCosine(cosine, 1.7f), 1.7f), 1e-3f);
    const float inside = RefractedCosine(cosine, 1.4f);
    const float behind = RefractedCosine(inside, 1.7f / 1.4f);
    const vec2 a = FrAmplitudes(cosine, inside, 1.4f);
    const vec2 b = FrAmplitudes(inside, behind, 1.7f / 1.4f);
    const auto both = [](float upper, float lower) {
      const float t = (1 - upper) * (1 - upper);
      return upper + t * lower / (1 - upper * lower);
    };
    const float faces = 0.5f * (both(a.x * a.x, b.x * b.x) + both(a.y * a.y, b.y * b.y));
    EXPECT_NEAR(FrFilmOnDielectric(cosine, 1.4f, 1000, 1.7f).y, faces, 1e-4f);
  }
  // From the denser side beyond the critical angle all is reflected
  EXPECT_EQ(FrFilmOnDielectric(0.3f, 1.4f / 1.5f, 1, 1 / 1.5f), Spectrum(1.0f));
}

// Gold in red, gold in blue, iron, and something like aluminium come back from their two reflectances.
TEST(ConductorIor, FindsTheMetal) {
  for (const vec2 metal :
       {vec2(0.21f, 3.27f), vec2(1.38f, 1.91f), vec2(2.9f, 3.0f), vec2(1.0f, 6.5f)}) {
    const vec2 found =
        ConductorIor(FrConductor(1, metal.x, metal.y), FrConductor(1.0f / 7, metal.x, metal.y));
    EXPECT_NEAR(found.x, metal.x, 0.03f * metal.x);
    EXPECT_NEAR(found.y, metal.y, 0.03f * metal.y);
  }
}

}  // namespace
}  // namespace snell::kernel
