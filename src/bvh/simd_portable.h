// SPDX-License-Identifier: Apache-2.0
//
// Vectors of four, eight and sixteen floats in plain C++, for processors without an own version; compilers turn the
// loops into what vector instructions there are. Also the reference for the other versions.
#pragma once

#include <cstdint>
#include <cstring>

#include "kernel/dialect.h"

#define SIMD_FN static inline __attribute__((always_inline))
#define SIMD_CALL static __attribute__((noinline))        // kept out of the loops
#define SIMD_COLD static __attribute__((noinline, cold))  // seldom called

namespace snell::bvh::SNELL_ISA {

template <int N>
struct Lanes {
  float v[N];
};
using Float4 = Lanes<4>;
using Float8 = Lanes<8>;
using Float16 = Lanes<16>;

template <int N, class Op>
SIMD_FN Lanes<N> Map(Lanes<N> a, Lanes<N> b, Op op) {
  Lanes<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = op(a.v[i], b.v[i]);
  return r;
}
template <int N>
SIMD_FN Lanes<N> Broadcast(float x) {
  Lanes<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = x;
  return r;
}
template <int N>
SIMD_FN Lanes<N> LoadLanes(const float* p) {
  Lanes<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = p[i];
  return r;
}
// Lanes first, first + 1, … around the end.
template <int M, int N>
SIMD_FN Lanes<M> Part(Lanes<N> a, int first) {
  Lanes<M> r;
  for (int i = 0; i < M; ++i) r.v[i] = a.v[(first + i) % N];
  return r;
}
template <int N>
SIMD_FN Lanes<N> operator-(Lanes<N> a, Lanes<N> b) {
  return Map(a, b, [](float x, float y) { return x - y; });
}
template <int N>
SIMD_FN Lanes<N> operator*(Lanes<N> a, Lanes<N> b) {
  return Map(a, b, [](float x, float y) { return x * y; });
}
template <int N>
SIMD_FN Lanes<N> operator+(Lanes<N> a, Lanes<N> b) {
  return Map(a, b, [](float x, float y) { return x + y; });
}
template <int N>
SIMD_FN Lanes<N> Max(Lanes<N> a, Lanes<N> b) {
  return Map(a, b, [](float x, float y) { return x > y ? x : y; });
}
template <int N>
SIMD_FN Lanes<N> Abs(Lanes<N> a) {
  return Map(a, a, [](float x, float) { return kernel::abs(x); });
}
template <int N>
SIMD_FN Lanes<N> operator/(Lanes<N> a, Lanes<N> b) {
  return Map(a, b, [](float x, float y) { return x / y; });
}
// a with the opposite sign where `sign` is negative.
template <int N>
SIMD_FN Lanes<N> FlipSign(Lanes<N> a, Lanes<N> sign) {
  return Map(a, sign, [](float x, float y) {
    return kernel::uintBitsToFloat(kernel::floatBitsToUint(x) ^
                                   (kernel::floatBitsToUint(y) & 0x80000000u));
  });
}

SIMD_FN Float4 Load4(const float* p) { return LoadLanes<4>(p); }
SIMD_FN void Store4(float* p, Float4 a) { std::memcpy(p, a.v, sizeof a.v); }
SIMD_FN Float4 Set4(float x) { return Broadcast<4>(x); }
SIMD_FN Float4 Set4(float x, float y, float z, float w) { return {{x, y, z, w}}; }
SIMD_FN Float4 WithLast(Float4 a, float last) { return {{a.v[0], a.v[1], a.v[2], last}}; }
SIMD_FN Float4 Negate(Float4 a) {
  return Map(a, a, [](float x, float) { return -x; });
}

template <int A, int B, int C>
SIMD_FN Float4 Shuffle(Float4 a) {
  return {{a.v[A], a.v[B], a.v[C], a.v[C]}};
}
SIMD_FN std::uint32_t MaskLess(Float4 a, Float4 b) {
  std::uint32_t mask = 0;
  for (int i = 0; i < 3; ++i) mask |= std::uint32_t(a.v[i] < b.v[i]) << i;
  return mask;
}
SIMD_FN std::uint32_t SignMask(Float4 a) {
  std::uint32_t mask = 0;
  for (int i = 0; i < 3; ++i) mask |= (kernel::floatBitsToUint(a.v[i]) >> 31) << i;
  return mask;
}

SIMD_FN Float16 Load16(const float* p) { return LoadLanes<16>(p); }
SIMD_FN Float16 Join(Float8 low, Float8 high) {
  Float16 r;
  for (int i = 0; i < 8; ++i) {
    r.v[i] = low.v[i];
    r.v[8 + i] = high.v[i];
  }
  return r;
}
SIMD_FN float Lane(Float8 a, std::uint32_t lane) { return a.v[lane]; }
SIMD_FN Float8 LowHalf(Float16 a) { return Part<8>(a, 0); }
SIMD_FN Float8 HighHalf(Float16 a) { return Part<8>(a, 8); }

// Whether to swap the halves of what is loaded: where a direction is negative.
struct HalfOrder {
  int first;
};
SIMD_FN void OrderHalves(const float* direction, HalfOrder order[3]) {
  for (int axis = 0; axis < 3; ++axis)
    order[axis].first = int(kernel::floatBitsToUint(direction[axis]) >> 31) * 8;
}
SIMD_FN Float16 Load16(const float* p, HalfOrder order) {
  return Part<16>(LoadLanes<16>(p), order.first);
}
// Eight times lane Axis and eight times lane 4 + Axis.
template <int Axis>
SIMD_FN Float16 Spread(Float8 a) {
  return Join(Broadcast<8>(a.v[Axis]), Broadcast<8>(a.v[4 + Axis]));
}
// a·b + c; may or may not round between the two.
SIMD_FN Float4 MulAdd(Float4 a, Float4 b, Float4 c) { return a * b + c; }
SIMD_FN Float16 MulAdd(Float16 a, Float16 b, Float16 c) { return a * b + c; }
SIMD_FN Float16 Set16(float x) { return Broadcast<16>(x); }
SIMD_FN Float16 NextQuarters(Float16 a) { return Part<16>(a, 4); }
SIMD_FN Float4 Quarter0(Float16 a) { return Part<4>(a, 0); }
SIMD_FN Float4 Quarter1(Float16 a) { return Part<4>(a, 4); }
SIMD_FN Float4 Quarter2(Float16 a) { return Part<4>(a, 8); }
SIMD_FN Float4 Quarter3(Float16 a) { return Part<4>(a, 12); }
SIMD_FN Float8 Quarters12(Float16 a) { return Part<8>(a, 4); }

SIMD_FN Float8 Load8(const float* p) { return LoadLanes<8>(p); }
SIMD_FN void Store8(float* p, Float8 a) { std::memcpy(p, a.v, sizeof a.v); }
SIMD_FN Float8 Set8(float x) { return Broadcast<8>(x); }
SIMD_FN Float8 Join(Float4 low, Float4 high) {
  Float8 r;
  for (int i = 0; i < 4; ++i) {
    r.v[i] = low.v[i];
    r.v[4 + i] = high.v[i];
  }
  return r;
}
SIMD_FN Float8 Min(Float8 a, Float8 b) {
  return Map(a, b, [](float x, float y) { return x < y ? x : y; });
}
SIMD_FN std::uint32_t MaskLess(Float8 a, Float8 b) {
  std::uint32_t mask = 0;
  for (int i = 0; i < 8; ++i) mask |= std::uint32_t(a.v[i] < b.v[i]) << i;
  return mask;
}
SIMD_FN std::uint32_t MaskLessEqual(Float8 a, Float8 b) {
  std::uint32_t mask = 0;
  for (int i = 0; i < 8; ++i) mask |= std::uint32_t(a.v[i] <= b.v[i]) << i;
  return mask;
}

// Eight yes or no.
struct Mask8 {
  bool v[8];
};
SIMD_FN Float8 Where(Mask8 mask, Float8 yes, Float8 no) {
  Float8 r;
  for (int i = 0; i < 8; ++i) r.v[i] = mask.v[i] ? yes.v[i] : no.v[i];
  return r;
}
// By bits 30 and 31 of ids (PairBlock::id) how far triangles are turned.
struct Turns {
  Mask8 once;
  Mask8 twice;
};
SIMD_FN Turns LoadTurns(const std::uint32_t* id) {
  Turns turns;
  for (int i = 0; i < 8; ++i) {
    turns.once.v[i] = (id[i] >> 30 & 1) != 0;
    turns.twice.v[i] = (id[i] >> 31 & 1) != 0;
  }
  return turns;
}

}  // namespace snell::bvh::SNELL_ISA
