// SPDX-License-Identifier: Apache-2.0
//
// Vectors of four, eight and sixteen floats by SSE4.2, the baseline of x86, made of vectors of four.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "kernel/dialect.h"

#define SIMD_FN static inline __attribute__((always_inline))
#define SIMD_CALL static __attribute__((noinline))        // kept out of the loops
#define SIMD_COLD static __attribute__((noinline, cold))  // seldom called

namespace snell::bvh::SNELL_ISA {

struct Float4 {
  __m128 v;
};

SIMD_FN Float4 Load4(const float* p) { return {_mm_loadu_ps(p)}; }
SIMD_FN void Store4(float* p, Float4 a) { _mm_storeu_ps(p, a.v); }
SIMD_FN Float4 Set4(float x) { return {_mm_set1_ps(x)}; }
SIMD_FN Float4 Set4(float x, float y, float z, float w) { return {_mm_setr_ps(x, y, z, w)}; }
SIMD_FN Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
SIMD_FN Float4 operator/(Float4 a, Float4 b) { return {_mm_div_ps(a.v, b.v)}; }
SIMD_FN Float4 Abs(Float4 a) { return {_mm_andnot_ps(_mm_set1_ps(-0.0f), a.v)}; }
SIMD_FN Float4 FlipSign(Float4 a, Float4 sign) {
  return {_mm_xor_ps(_mm_and_ps(_mm_set1_ps(-0.0f), sign.v), a.v)};
}
SIMD_FN Float4 Max(Float4 a, Float4 b) { return {_mm_max_ps(a.v, b.v)}; }
SIMD_FN Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
SIMD_FN Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
#ifdef __FMA__
SIMD_FN Float4 MulAdd(Float4 a, Float4 b, Float4 c) { return {_mm_fmadd_ps(a.v, b.v, c.v)}; }
#else
SIMD_FN Float4 MulAdd(Float4 a, Float4 b, Float4 c) { return a * b + c; }
#endif
SIMD_FN Float4 WithLast(Float4 a, float last) {
  return {_mm_insert_ps(a.v, _mm_set_ss(last), 0x30)};
}
// Lanes A, B and C of a, and C once more.
template <int A, int B, int C>
SIMD_FN Float4 Shuffle(Float4 a) {
  return {_mm_shuffle_ps(a.v, a.v, A | B << 2 | C << 4 | C << 6)};
}
// Of the first three lanes.
SIMD_FN std::uint32_t MaskLess(Float4 a, Float4 b) {
  return std::uint32_t(_mm_movemask_ps(_mm_cmplt_ps(a.v, b.v))) & 7;
}
SIMD_FN std::uint32_t SignMask(Float4 a) { return std::uint32_t(_mm_movemask_ps(a.v)) & 7; }
SIMD_FN Float4 Negate(Float4 a) { return {_mm_xor_ps(_mm_set1_ps(-0.0f), a.v)}; }

#ifndef SNELL_SIMD_NATIVE16
struct HalfOrder {
  std::size_t first;
};
SIMD_FN void OrderHalves(const float* direction, HalfOrder order[3]) {
  for (int axis = 0; axis < 3; ++axis)
    order[axis].first = std::size_t(kernel::floatBitsToUint(direction[axis]) >> 31) * 8;
}
#endif

#ifndef SNELL_SIMD_NATIVE8

struct Float8 {
  __m128 low;
  __m128 high;
};

SIMD_FN Float8 operator-(Float8 a, Float8 b) {
  return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
}
SIMD_FN Float8 operator+(Float8 a, Float8 b) {
  return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
}
SIMD_FN Float8 operator*(Float8 a, Float8 b) {
  return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
}
SIMD_FN Float8 Abs(Float8 a) {
  const __m128 sign = _mm_set1_ps(-0.0f);
  return {_mm_andnot_ps(sign, a.low), _mm_andnot_ps(sign, a.high)};
}
SIMD_FN Float8 FlipSign(Float8 a, Float8 sign) {
  const __m128 bit = _mm_set1_ps(-0.0f);
  return {_mm_xor_ps(_mm_and_ps(bit, sign.low), a.low),
          _mm_xor_ps(_mm_and_ps(bit, sign.high), a.high)};
}
SIMD_FN Float8 Join(Float4 low, Float4 high) { return {low.v, high.v}; }
SIMD_FN Float8 Load8(const float* p) { return {_mm_load_ps(p), _mm_load_ps(p + 4)}; }
SIMD_FN void Store8(float* p, Float8 a) {
  _mm_store_ps(p, a.low);
  _mm_store_ps(p + 4, a.high);
}
SIMD_FN float Lane(Float8 a, std::uint32_t lane) {
  alignas(16) float lanes[8];
  Store8(lanes, a);
  return lanes[lane];
}
SIMD_FN Float8 Set8(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
SIMD_FN Float8 Max(Float8 a, Float8 b) {
  return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
SIMD_FN Float8 Min(Float8 a, Float8 b) {
  return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
SIMD_FN std::uint32_t MaskLess(Float8 a, Float8 b) {
  return std::uint32_t(_mm_movemask_ps(_mm_cmplt_ps(a.low, b.low))) |
         std::uint32_t(_mm_movemask_ps(_mm_cmplt_ps(a.high, b.high))) << 4;
}
SIMD_FN std::uint32_t MaskLessEqual(Float8 a, Float8 b) {
  return std::uint32_t(_mm_movemask_ps(_mm_cmple_ps(a.low, b.low))) |
         std::uint32_t(_mm_movemask_ps(_mm_cmple_ps(a.high, b.high))) << 4;
}

struct Mask8 {
  __m128 low;
  __m128 high;
};
SIMD_FN Float8 Where(Mask8 mask, Float8 yes, Float8 no) {
  return {_mm_blendv_ps(no.low, yes.low, mask.low), _mm_blendv_ps(no.high, yes.high, mask.high)};
}
struct Turns {
  Mask8 once;
  Mask8 twice;
};
SIMD_FN Turns LoadTurns(const std::uint32_t* id) {
  const __m128i* ids = reinterpret_cast<const __m128i*>(id);
  const __m128i low = _mm_load_si128(ids), high = _mm_load_si128(ids + 1);
  return {{_mm_castsi128_ps(_mm_slli_epi32(low, 1)), _mm_castsi128_ps(_mm_slli_epi32(high, 1))},
          {_mm_castsi128_ps(low), _mm_castsi128_ps(high)}};
}
SIMD_FN Float8 operator/(Float8 a, Float8 b) {
  return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)};
}

struct Float16 {
  __m128 v[4];
};

SIMD_FN Float16 Load16(const float* p) {
  return {{_mm_load_ps(p), _mm_load_ps(p + 4), _mm_load_ps(p + 8), _mm_load_ps(p + 12)}};
}
SIMD_FN Float16 Join(Float8 low, Float8 high) { return {{low.low, low.high, high.low, high.high}}; }
SIMD_FN Float8 LowHalf(Float16 a) { return {a.v[0], a.v[1]}; }
SIMD_FN Float8 HighHalf(Float16 a) { return {a.v[2], a.v[3]}; }

SIMD_FN Float16 Load16(const float* p, HalfOrder order) {
  const float* low = p + order.first;
  const float* high = p + (order.first ^ 8);
  return {{_mm_load_ps(low), _mm_load_ps(low + 4), _mm_load_ps(high), _mm_load_ps(high + 4)}};
}
SIMD_FN Float16 Set16(float x) {
  return {{_mm_set1_ps(x), _mm_set1_ps(x), _mm_set1_ps(x), _mm_set1_ps(x)}};
}
SIMD_FN Float16 operator-(Float16 a, Float16 b) {
  return {{_mm_sub_ps(a.v[0], b.v[0]), _mm_sub_ps(a.v[1], b.v[1]), _mm_sub_ps(a.v[2], b.v[2]),
           _mm_sub_ps(a.v[3], b.v[3])}};
}
SIMD_FN Float16 operator*(Float16 a, Float16 b) {
  return {{_mm_mul_ps(a.v[0], b.v[0]), _mm_mul_ps(a.v[1], b.v[1]), _mm_mul_ps(a.v[2], b.v[2]),
           _mm_mul_ps(a.v[3], b.v[3])}};
}
SIMD_FN Float16 NextQuarters(Float16 a) { return {{a.v[1], a.v[2], a.v[3], a.v[0]}}; }
SIMD_FN Float4 Quarter0(Float16 a) { return {a.v[0]}; }
SIMD_FN Float16 operator+(Float16 a, Float16 b) {
  return {{_mm_add_ps(a.v[0], b.v[0]), _mm_add_ps(a.v[1], b.v[1]), _mm_add_ps(a.v[2], b.v[2]),
           _mm_add_ps(a.v[3], b.v[3])}};
}
template <int Axis>
SIMD_FN Float16 Spread(Float8 a) {
  constexpr int Places = Axis | Axis << 2 | Axis << 4 | Axis << 6;
  const __m128 low = _mm_shuffle_ps(a.low, a.low, Places);
  const __m128 high = _mm_shuffle_ps(a.high, a.high, Places);
  return {{low, low, high, high}};
}
SIMD_FN Float16 MulAdd(Float16 a, Float16 b, Float16 c) { return a * b + c; }
SIMD_FN Float16 Max(Float16 a, Float16 b) {
  return {{_mm_max_ps(a.v[0], b.v[0]), _mm_max_ps(a.v[1], b.v[1]), _mm_max_ps(a.v[2], b.v[2]),
           _mm_max_ps(a.v[3], b.v[3])}};
}
SIMD_FN Float16 Abs(Float16 a) {
  const __m128 sign = _mm_set1_ps(-0.0f);
  return {{_mm_andnot_ps(sign, a.v[0]), _mm_andnot_ps(sign, a.v[1]), _mm_andnot_ps(sign, a.v[2]),
           _mm_andnot_ps(sign, a.v[3])}};
}
SIMD_FN Float4 Quarter1(Float16 a) { return {a.v[1]}; }
SIMD_FN Float4 Quarter2(Float16 a) { return {a.v[2]}; }
SIMD_FN Float4 Quarter3(Float16 a) { return {a.v[3]}; }
SIMD_FN Float8 Quarters12(Float16 a) { return {a.v[1], a.v[2]}; }

#endif

}  // namespace snell::bvh::SNELL_ISA
