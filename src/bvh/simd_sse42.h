// SPDX-License-Identifier: Apache-2.0
//
// Vectors of four and eight floats by SSE4.2: the baseline of x86. Eight are two of four.
#pragma once

#include <immintrin.h>

#include <cstdint>

#define SIMD_FN static inline __attribute__((always_inline))

namespace snell::bvh::SNELL_ISA {

struct Float4 {
  __m128 v;
};

SIMD_FN Float4 Load4(const float* p) { return {_mm_load_ps(p)}; }
SIMD_FN void Store4(float* p, Float4 a) { _mm_store_ps(p, a.v); }
SIMD_FN Float4 Set4(float x) { return {_mm_set1_ps(x)}; }
SIMD_FN Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
SIMD_FN Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
SIMD_FN Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
SIMD_FN Float4 operator/(Float4 a, Float4 b) { return {_mm_div_ps(a.v, b.v)}; }
SIMD_FN Float4 Abs(Float4 a) { return {_mm_andnot_ps(_mm_set1_ps(-0.0f), a.v)}; }
SIMD_FN Float4 operator|(Float4 a, Float4 b) { return {_mm_or_ps(a.v, b.v)}; }
SIMD_FN Float4 operator&(Float4 a, Float4 b) { return {_mm_and_ps(a.v, b.v)}; }
SIMD_FN Float4 AndNot(Float4 no, Float4 a) { return {_mm_andnot_ps(no.v, a.v)}; }
SIMD_FN Float4 operator<(Float4 a, Float4 b) { return {_mm_cmplt_ps(a.v, b.v)}; }
SIMD_FN Float4 operator<=(Float4 a, Float4 b) { return {_mm_cmple_ps(a.v, b.v)}; }
SIMD_FN Float4 operator==(Float4 a, Float4 b) { return {_mm_cmpeq_ps(a.v, b.v)}; }
SIMD_FN Float4 operator!=(Float4 a, Float4 b) { return {_mm_cmpneq_ps(a.v, b.v)}; }
SIMD_FN std::uint32_t Mask(Float4 a) { return std::uint32_t(_mm_movemask_ps(a.v)); }

#ifndef SNELL_SIMD_NATIVE8

struct Float8 {
  __m128 low;
  __m128 high;
};

SIMD_FN Float8 Load8(const float* p) { return {_mm_load_ps(p), _mm_load_ps(p + 4)}; }
SIMD_FN void Store8(float* p, Float8 a) {
  _mm_store_ps(p, a.low);
  _mm_store_ps(p + 4, a.high);
}
SIMD_FN Float8 Set8(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
SIMD_FN Float8 Max(Float8 a, Float8 b) {
  return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
SIMD_FN Float8 Min(Float8 a, Float8 b) {
  return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
// a·b − c; may or may not round between the two.
SIMD_FN Float8 MulSub(Float8 a, Float8 b, Float8 c) {
  return {_mm_sub_ps(_mm_mul_ps(a.low, b.low), c.low),
          _mm_sub_ps(_mm_mul_ps(a.high, b.high), c.high)};
}
SIMD_FN std::uint32_t MaskLessEqual(Float8 a, Float8 b) {
  return std::uint32_t(_mm_movemask_ps(_mm_cmple_ps(a.low, b.low))) |
         std::uint32_t(_mm_movemask_ps(_mm_cmple_ps(a.high, b.high))) << 4;
}

#endif

}  // namespace snell::bvh::SNELL_ISA
