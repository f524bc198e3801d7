// SPDX-License-Identifier: Apache-2.0
//
// The free flight of light through an even medium, to its next scattering or to the end of the way. The distance is
// sampled by the extinction of one channel, which is chosen in proportion to what the path still carries, and weighted
// by all channels (the balance heuristic; Wilkie et al. 2014, "Hero wavelength spectral sampling"; pbrt-v4, section
// 14.2): what a path carries, all channels together, never grows.
#ifndef SNELL_KERNEL_FLIGHT_H
#define SNELL_KERNEL_FLIGHT_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// Longer ways count as this long, metres.
CONST float LongestFlight = 1e30f;

struct FlightSample {
  float t;         // metres; of the scattering
  uint scattered;  // 0: the light gets through
  Spectrum weight;
};

// One channel of the colour `of`, chosen by u in proportion to `weights`, which are not all 0.
FN float PickChannel(Spectrum weights, Spectrum of, float u) {
  float at = u * (weights.x + weights.y + weights.z);
  if (at < weights.x) return of.x;
  if (at < weights.x + weights.y || weights.z <= 0.0f) return of.y;
  return of.z;
}

// The flight of a path that carries beta over at most `distance`; u ∈ [0, 1)².
FN FlightSample SampleFlight(IN(Medium) medium, Spectrum beta, float distance, vec2 u) {
  FlightSample flight;
  float sigma = PickChannel(beta, medium.extinction, u.x);
  flight.t = sigma > 0.0f ? -Log(1.0f - u.y) / sigma : LongestFlight;
  flight.scattered = flight.t < distance ? 1u : 0u;
  Spectrum through = Exp(medium.extinction * -Min(flight.t, distance));
  if (flight.scattered == 1u) {
    float pdf = MeanChannel(beta * medium.extinction * through);
    flight.weight = medium.scattering * through * (pdf > 0.0f ? MeanChannel(beta) / pdf : 0.0f);
  } else {
    float chance = MeanChannel(beta * through);
    flight.weight = through * (chance > 0.0f ? MeanChannel(beta) / chance : 0.0f);
  }
  return flight;
}

// ∫ e^(−σt) dt from 0 to `distance`: how much of an even glow along the way arrives.
FN float GlowLength(float sigma, float distance) {
  float depth = sigma * distance;
  if (depth < 1e-3f) return distance * (1.0f - 0.5f * depth);
  return (1.0f - Exp(-depth)) / sigma;
}
FN Spectrum GlowLength(Spectrum sigma, float distance) {
  return Spectrum(GlowLength(sigma.x, distance), GlowLength(sigma.y, distance),
                  GlowLength(sigma.z, distance));
}

KERNEL_END

#endif
