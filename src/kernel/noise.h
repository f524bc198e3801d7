// SPDX-License-Identifier: Apache-2.0
//
// Gradient noise (Perlin 2002, "Improving noise") with hashed gradients, and its sum over octaves.
#ifndef SNELL_KERNEL_NOISE_H
#define SNELL_KERNEL_NOISE_H

#include "kernel/math.h"
#include "kernel/sobol.h"

KERNEL_BEGIN

// Dot of the lattice point's gradient, one of the twelve edges of a cube, with the offset from it.
FN float GradientDot(int ix, int iy, int iz, float x, float y, float z) {
  uint h = HashUint(uint(ix) * 0x8da6b343u ^ uint(iy) * 0xd8163841u ^ uint(iz) * 0xcb1ab31fu) & 15u;
  float u = h < 8u || h == 12u || h == 13u ? x : y;
  float v = h < 4u || h == 12u || h == 13u ? y : z;
  return ((h & 1u) == 0u ? u : -u) + ((h & 2u) == 0u ? v : -v);
}

FN float NoiseFade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

// Beyond this floats have no fraction left, and integers soon end.
CONST float NoiseReach = 1.0e9f;

// Smooth noise in about [−1, 1] with mean 0; 0 at the integer points.
FN float Noise(vec3 at) {
  vec3 p = vec3(Clamp(at.x, -NoiseReach, NoiseReach), Clamp(at.y, -NoiseReach, NoiseReach),
                Clamp(at.z, -NoiseReach, NoiseReach));
  float fx = floor(p.x);
  float fy = floor(p.y);
  float fz = floor(p.z);
  int ix = int(fx);
  int iy = int(fy);
  int iz = int(fz);
  float x = p.x - fx;
  float y = p.y - fy;
  float z = p.z - fz;
  float u = NoiseFade(x);
  float v = NoiseFade(y);
  float w = NoiseFade(z);
  float x00 =
      Lerp(u, GradientDot(ix, iy, iz, x, y, z), GradientDot(ix + 1, iy, iz, x - 1.0f, y, z));
  float x10 = Lerp(u, GradientDot(ix, iy + 1, iz, x, y - 1.0f, z),
                   GradientDot(ix + 1, iy + 1, iz, x - 1.0f, y - 1.0f, z));
  float x01 = Lerp(u, GradientDot(ix, iy, iz + 1, x, y, z - 1.0f),
                   GradientDot(ix + 1, iy, iz + 1, x - 1.0f, y, z - 1.0f));
  float x11 = Lerp(u, GradientDot(ix, iy + 1, iz + 1, x, y - 1.0f, z - 1.0f),
                   GradientDot(ix + 1, iy + 1, iz + 1, x - 1.0f, y - 1.0f, z - 1.0f));
  return Lerp(w, Lerp(v, x00, x10), Lerp(v, x01, x11));
}

// Sum of octaves of noise, each of twice the frequency and half the height of the one before.
FN float FractalNoise(vec3 p, uint octaves) {
  float sum = 0.0f;
  float height = 1.0f;
  float frequency = 1.0f;
  for (uint i = 0u; i < octaves; ++i) {
    sum += height * Noise(p * frequency);
    height *= 0.5f;
    frequency *= 2.03f;  // not 2, so that the lattices do not coincide
  }
  return sum;
}

KERNEL_END

#endif
