// SPDX-License-Identifier: Apache-2.0
//
// Free flights through media: on average as much is scattered and let through as Beer's law says, in every channel,
// and a path never carries more than before. Beside it the albedo of what wanders below surfaces.
#include "kernel/flight.h"

#include <gtest/gtest.h>

#include "kernel/subsurface.h"
#include "support/random.h"

namespace snell::kernel {
namespace {

Spectrum RandomSpectrum(test::Random& random, float most) {
  return {most * random.UniformFloat(), most * random.UniformFloat(), most * random.UniformFloat()};
}

TEST(SampleFlight, SharesLightByBeersLaw) {
  test::Random random(72);
  for (int trial = 0; trial < 12; ++trial) {
    Medium medium = {};
    medium.scattering = RandomSpectrum(random, 3);
    medium.extinction = medium.scattering + RandomSpectrum(random, 1);
    if (trial % 3 == 0) medium.scattering.y = 0;
    if (trial % 4 == 0) medium.scattering.x = medium.extinction.x = 0;
    const Spectrum beta = RandomSpectrum(random, 1) + Spectrum(0.05f);
    const float distance = 2 * random.UniformFloat();
    glm::dvec3 scattered(0), through(0);
    constexpr int Steps = 600;
    for (int i = 0; i < Steps * Steps; ++i) {
      const vec2 u((float(i % Steps) + 0.5f) / Steps, (float(i) / Steps + 0.5f) / Steps);
      const FlightSample flight =
          SampleFlight(medium, beta, distance, vec2(u.x, Min(u.y, 0.9999f)));
      ASSERT_LE(MeanChannel(beta * flight.weight), MeanChannel(beta) * 1.0001f);
      ASSERT_EQ(flight.scattered == 1, flight.t < distance);
      (flight.scattered == 1 ? scattered : through) +=
          glm::dvec3(flight.weight) / double(Steps * Steps);
    }
    for (int c = 0; c < 3; ++c) {
      const double sigma = double(medium.extinction[c]);
      const double left = std::exp(-sigma * double(distance));
      EXPECT_NEAR(through[c], left, 3e-3) << trial;
      if (sigma > 0) {
        EXPECT_NEAR(scattered[c], double(medium.scattering[c]) / sigma * (1 - left), 3e-3) << trial;
      }
    }
  }
}

TEST(GlowLength, IsTheIntegralOfTheTransmittance) {
  EXPECT_FLOAT_EQ(GlowLength(0.0f, 3.0f), 3);
  EXPECT_NEAR(GlowLength(1e-4f, 9.9f), (1 - std::exp(-9.9e-4)) / 1e-4, 1e-5);
  EXPECT_NEAR(GlowLength(2.0f, 1.5f), (1 - std::exp(-3.0)) / 2, 1e-6);
  EXPECT_NEAR(GlowLength(2.0f, LongestFlight), 0.5, 1e-6);
}

// Put into van de Hulst's fit, the albedo gives the colour.
TEST(SingleAlbedo, GivesTheColourBack) {
  for (const float g : {-0.5f, 0.0f, 0.8f}) {
    for (float color = 0; color <= 1; color += 0.05f) {
      const double albedo = double(SingleAlbedo(color, g));
      ASSERT_GE(albedo, 0);
      ASSERT_LE(albedo, 1);
      const double s = std::sqrt((1 - albedo) / (1 - albedo * double(g)));
      EXPECT_NEAR((1 - s) * (1 - 0.139 * s) / (1 + 1.17 * s), double(color), 1e-3) << g;
    }
  }
  EXPECT_EQ(SingleAlbedo(1.0f, 0.3f), 1);
}

}  // namespace
}  // namespace snell::kernel
