// SPDX-License-Identifier: Apache-2.0
//
// Vectors of four and eight floats in plain C++, for processors without an own version; compilers turn the
// loops into what vector instructions there are. Also the reference for the other versions.
#pragma once

#include <cstdint>
#include <cstring>

#define SIMD_FN static inline __attribute__((always_inline))

namespace snell::bvh::SNELL_ISA {

// A comparison gives lanes of all or no bits.
template <int N>
struct Lanes {
  float v[N];
};
using Float4 = Lanes<4>;
using Float8 = Lanes<8>;

template <int N, class Op>
SIMD_FN Lanes<N> Map(Lanes<N> a, Lanes<N> b, Op op) {
  Lanes<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = op(a.v[i], b.v[i]);
  return r;
}
SIMD_FN std::uint32_t BitsOf(float f) {
  std::uint32_t u;
  std::memcpy(&u, &f, 4);
  return u;
}
SIMD_FN float FloatOf(std::uint32_t u) {
  float f;
  std::memcpy(&f, &u, 4);
  return f;
}
SIMD_FN float AllBits(bool set) { return FloatOf(set ? 0xffffffffu : 0u); }
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

SIMD_FN Float4 Load4(const float* p) { return LoadLanes<4>(p); }
SIMD_FN Float8 Load8(const float* p) { return LoadLanes<8>(p); }
SIMD_FN void Store4(float* p, Float4 a) { std::memcpy(p, a.v, sizeof a.v); }
SIMD_FN void Store8(float* p, Float8 a) { std::memcpy(p, a.v, sizeof a.v); }
SIMD_FN Float4 Set4(float x) { return Broadcast<4>(x); }
SIMD_FN Float8 Set8(float x) { return Broadcast<8>(x); }

SIMD_FN Float4 operator+(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return x + y; });
}
SIMD_FN Float4 operator-(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return x - y; });
}
SIMD_FN Float4 operator*(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return x * y; });
}
SIMD_FN Float4 operator/(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return x / y; });
}
SIMD_FN Float4 Abs(Float4 a) {
  return Map(a, a, [](float x, float) { return FloatOf(BitsOf(x) & 0x7fffffffu); });
}
SIMD_FN Float4 operator|(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return FloatOf(BitsOf(x) | BitsOf(y)); });
}
SIMD_FN Float4 operator&(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return FloatOf(BitsOf(x) & BitsOf(y)); });
}
SIMD_FN Float4 AndNot(Float4 no, Float4 a) {
  return Map(no, a, [](float x, float y) { return FloatOf(~BitsOf(x) & BitsOf(y)); });
}
SIMD_FN Float4 operator<(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return AllBits(x < y); });
}
SIMD_FN Float4 operator<=(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return AllBits(x <= y); });
}
SIMD_FN Float4 operator==(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return AllBits(x == y); });
}
SIMD_FN Float4 operator!=(Float4 a, Float4 b) {
  return Map(a, b, [](float x, float y) { return AllBits(x != y); });
}
SIMD_FN std::uint32_t Mask(Float4 a) {
  std::uint32_t mask = 0;
  for (int i = 0; i < 4; ++i) mask |= (BitsOf(a.v[i]) >> 31) << i;
  return mask;
}

SIMD_FN Float8 Max(Float8 a, Float8 b) {
  return Map(a, b, [](float x, float y) { return x > y ? x : y; });
}
SIMD_FN Float8 Min(Float8 a, Float8 b) {
  return Map(a, b, [](float x, float y) { return x < y ? x : y; });
}
SIMD_FN Float8 MulSub(Float8 a, Float8 b, Float8 c) {
  Float8 r;
  for (int i = 0; i < 8; ++i) r.v[i] = a.v[i] * b.v[i] - c.v[i];
  return r;
}
SIMD_FN std::uint32_t MaskLessEqual(Float8 a, Float8 b) {
  std::uint32_t mask = 0;
  for (int i = 0; i < 8; ++i) mask |= std::uint32_t(a.v[i] <= b.v[i]) << i;
  return mask;
}

}  // namespace snell::bvh::SNELL_ISA
