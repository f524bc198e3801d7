// SPDX-License-Identifier: Apache-2.0
//
// Sample points: the first two dimensions of Sobol''s sequence, Owen-scrambled by hashing and padded to as
// many pairs of dimensions as are needed (Burley 2020, "Practical hash-based Owen scrambling", JCGT 9:4;
// scrambling hash of Laine and Karras 2011 with Burley's constants). Any power-of-two prefix of a pair is
// stratified in every elementary interval.
#ifndef SNELL_KERNEL_SOBOL_H
#define SNELL_KERNEL_SOBOL_H

#include "kernel/math.h"

KERNEL_BEGIN

// A bijective hash of 32 bits (Wellons 2018, "lowbias32").
FN uint HashUint(uint x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return x;
}
FN uint HashCombine(uint seed, uint x) {
  return HashUint(seed ^ (x + 0x9e3779b9u + (seed << 6) + (seed >> 2)));
}

// Owen scrambling of a bit-reversed number: each bit is flipped by a hash of the bits below it.
FN uint ScrambleReversed(uint x, uint seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

// Second dimension of Sobol''s sequence as a 32-bit fraction, from the bit-reversed index: the product with
// Pascal's matrix modulo 2, in five butterfly stages.
FN uint SobolSecond(uint reversedIndex) {
  uint x = reversedIndex;
  x ^= (x << 1) & 0xaaaaaaaau;
  x ^= (x << 2) & 0xccccccccu;
  x ^= (x << 4) & 0xf0f0f0f0u;
  x ^= (x << 8) & 0xff00ff00u;
  x ^= (x << 16) & 0xffff0000u;
  return x;
}

// The 24 high bits as a float in [0, 1).
FN float UnitFloat(uint x) { return float(x >> 8) * 5.9604644775390625e-8f; }

// Point of the pair of dimensions that `seed` names, in [0, 1)², by its bit-reversed index.
FN vec2 Sobol2DOfReversed(uint reversedIndex, uint seed) {
  uint shuffled = ScrambleReversed(reversedIndex, seed);
  uint x =
      bitfieldReverse(ScrambleReversed(bitfieldReverse(shuffled), HashUint(seed ^ 0xa511e9b3u)));
  uint y = bitfieldReverse(
      ScrambleReversed(bitfieldReverse(SobolSecond(shuffled)), HashUint(seed ^ 0x63d83595u)));
  return vec2(UnitFloat(x), UnitFloat(y));
}
FN vec2 Sobol2D(uint index, uint seed) { return Sobol2DOfReversed(bitfieldReverse(index), seed); }

// Point `index` of a row of independent random points, for comparison.
FN vec2 IndependentSample2D(uint index, uint seed) {
  uint x = HashCombine(seed, index);
  return vec2(UnitFloat(x), UnitFloat(HashUint(x ^ 0x63d83595u)));
}

// The bits of x with a 0 before each; the 16 low ones count.
FN uint SpreadBits(uint x) {
  x &= 0xffffu;
  x = (x | (x << 8)) & 0x00ff00ffu;
  x = (x | (x << 4)) & 0x0f0f0f0fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}

// Where in one sequence over all pixels a sample of one of them stands: pixels follow each other along Morton's curve,
// each with 2^samplesLog2 points. So those of every square of pixels, too, are well distributed together, and what
// errors remain differ between neighbours: noise without low frequencies (Ahmed and Wonka 2020, "Screen-space
// blue-noise diffusion of Monte Carlo sampling error via hierarchical ordering of pixels"; the shuffle of
// Sobol2D is their permutation of the squares). Where 32 bits end, and for more samples, another seed begins.
FN uint PixelSampleIndex(uvec2 pixel, uint sampleNumber, uint samplesLog2, INOUT(uint) seed) {
  uint side = (32u - samplesLog2) / 2u;
  seed = HashCombine(HashCombine(seed, pixel.x >> side), pixel.y >> side);
  seed = HashCombine(seed, sampleNumber >> samplesLog2);
  uint low = (1u << side) - 1u;
  uint place = SpreadBits(pixel.x & low) | (SpreadBits(pixel.y & low) << 1);
  return (place << samplesLog2) | (sampleNumber & ((1u << samplesLog2) - 1u));
}

KERNEL_END

#endif
