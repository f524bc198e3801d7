// SPDX-License-Identifier: Apache-2.0
//
// Vectors of eight and sixteen floats by AVX2 and FMA; those of four are SSE's.
#pragma once

#define SNELL_SIMD_NATIVE8
#include "bvh/simd_sse42.h"

namespace snell::bvh::SNELL_ISA {

struct Float8 {
  __m256 v;
};

SIMD_FN Float8 Load8(const float* p) { return {_mm256_load_ps(p)}; }
SIMD_FN void Store8(float* p, Float8 a) { _mm256_store_ps(p, a.v); }
SIMD_FN Float8 Set8(float x) { return {_mm256_set1_ps(x)}; }
SIMD_FN Float8 Max(Float8 a, Float8 b) { return {_mm256_max_ps(a.v, b.v)}; }
SIMD_FN Float8 Min(Float8 a, Float8 b) { return {_mm256_min_ps(a.v, b.v)}; }
SIMD_FN Float8 operator-(Float8 a, Float8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
SIMD_FN Float8 operator+(Float8 a, Float8 b) { return {_mm256_add_ps(a.v, b.v)}; }
SIMD_FN Float8 operator*(Float8 a, Float8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
SIMD_FN Float8 Abs(Float8 a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)}; }
SIMD_FN Float8 FlipSign(Float8 a, Float8 sign) {
  return {_mm256_xor_ps(_mm256_and_ps(_mm256_set1_ps(-0.0f), sign.v), a.v)};
}
SIMD_FN float Lane(Float8 a, std::uint32_t lane) {
  return _mm256_cvtss_f32(_mm256_permutevar8x32_ps(a.v, _mm256_set1_epi32(int(lane))));
}
SIMD_FN Float8 Join(Float4 low, Float4 high) { return {_mm256_set_m128(high.v, low.v)}; }
SIMD_FN Float8 operator/(Float8 a, Float8 b) { return {_mm256_div_ps(a.v, b.v)}; }
#ifdef __AVX512VL__
struct Mask8 {
  __mmask8 v;
};
SIMD_FN Float8 Where(Mask8 mask, Float8 yes, Float8 no) {
  return {_mm256_mask_blend_ps(mask.v, no.v, yes.v)};
}
struct Turns {
  Mask8 once;
  Mask8 twice;
};
SIMD_FN Turns LoadTurns(const std::uint32_t* id) {
  const __m256i ids = _mm256_load_si256(reinterpret_cast<const __m256i*>(id));
  return {{_mm256_movepi32_mask(_mm256_slli_epi32(ids, 1))}, {_mm256_movepi32_mask(ids)}};
}
SIMD_FN std::uint32_t MaskLessEqual(Float8 a, Float8 b) {
  return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
}
SIMD_FN std::uint32_t MaskLess(Float8 a, Float8 b) {
  return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ);
}
#else
struct Mask8 {
  __m256 v;
};
SIMD_FN Float8 Where(Mask8 mask, Float8 yes, Float8 no) {
  return {_mm256_blendv_ps(no.v, yes.v, mask.v)};
}
struct Turns {
  Mask8 once;
  Mask8 twice;
};
SIMD_FN Turns LoadTurns(const std::uint32_t* id) {
  const __m256i ids = _mm256_load_si256(reinterpret_cast<const __m256i*>(id));
  return {{_mm256_castsi256_ps(_mm256_slli_epi32(ids, 1))}, {_mm256_castsi256_ps(ids)}};
}
SIMD_FN std::uint32_t MaskLessEqual(Float8 a, Float8 b) {
  return std::uint32_t(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}
SIMD_FN std::uint32_t MaskLess(Float8 a, Float8 b) {
  return std::uint32_t(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)));
}
#endif

#ifndef SNELL_SIMD_NATIVE16

struct Float16 {
  __m256 low;
  __m256 high;
};

SIMD_FN Float16 Load16(const float* p) { return {_mm256_load_ps(p), _mm256_load_ps(p + 8)}; }
SIMD_FN Float16 Join(Float8 low, Float8 high) { return {low.v, high.v}; }
SIMD_FN Float8 LowHalf(Float16 a) { return {a.low}; }
SIMD_FN Float8 HighHalf(Float16 a) { return {a.high}; }

SIMD_FN Float16 Load16(const float* p, HalfOrder order) {
  return {_mm256_load_ps(p + order.first), _mm256_load_ps(p + (order.first ^ 8))};
}
template <int Axis>
SIMD_FN Float16 Spread(Float8 a) {
  return {_mm256_permutevar8x32_ps(a.v, _mm256_set1_epi32(Axis)),
          _mm256_permutevar8x32_ps(a.v, _mm256_set1_epi32(4 + Axis))};
}
SIMD_FN Float16 MulAdd(Float16 a, Float16 b, Float16 c) {
  return {_mm256_fmadd_ps(a.low, b.low, c.low), _mm256_fmadd_ps(a.high, b.high, c.high)};
}
SIMD_FN Float16 Set16(float x) { return {_mm256_set1_ps(x), _mm256_set1_ps(x)}; }
SIMD_FN Float16 operator-(Float16 a, Float16 b) {
  return {_mm256_sub_ps(a.low, b.low), _mm256_sub_ps(a.high, b.high)};
}
SIMD_FN Float16 operator*(Float16 a, Float16 b) {
  return {_mm256_mul_ps(a.low, b.low), _mm256_mul_ps(a.high, b.high)};
}
SIMD_FN Float16 NextQuarters(Float16 a) {
  return {_mm256_permute2f128_ps(a.low, a.high, 0x21), _mm256_permute2f128_ps(a.high, a.low, 0x21)};
}
SIMD_FN Float4 Quarter0(Float16 a) { return {_mm256_castps256_ps128(a.low)}; }
SIMD_FN Float16 operator+(Float16 a, Float16 b) {
  return {_mm256_add_ps(a.low, b.low), _mm256_add_ps(a.high, b.high)};
}
SIMD_FN Float16 Max(Float16 a, Float16 b) {
  return {_mm256_max_ps(a.low, b.low), _mm256_max_ps(a.high, b.high)};
}
SIMD_FN Float16 Abs(Float16 a) { return {Abs(Float8{a.low}).v, Abs(Float8{a.high}).v}; }
SIMD_FN Float4 Quarter1(Float16 a) { return {_mm256_extractf128_ps(a.low, 1)}; }
SIMD_FN Float4 Quarter2(Float16 a) { return {_mm256_castps256_ps128(a.high)}; }
SIMD_FN Float4 Quarter3(Float16 a) { return {_mm256_extractf128_ps(a.high, 1)}; }
SIMD_FN Float8 Quarters12(Float16 a) { return {_mm256_permute2f128_ps(a.low, a.high, 0x21)}; }

#endif

}  // namespace snell::bvh::SNELL_ISA
