// SPDX-License-Identifier: Apache-2.0
//
// Vectors of sixteen floats by AVX-512; those of eight are AVX2's, with mask registers.
#pragma once

#define SNELL_SIMD_NATIVE16
#include "bvh/simd_avx2.h"

namespace snell::bvh::SNELL_ISA {

struct Float16 {
  __m512 v;
};

SIMD_FN Float16 Load16(const float* p) { return {_mm512_load_ps(p)}; }
SIMD_FN Float16 Join(Float8 low, Float8 high) {
  return {_mm512_insertf32x8(_mm512_castps256_ps512(low.v), high.v, 1)};
}
SIMD_FN Float8 LowHalf(Float16 a) { return {_mm512_castps512_ps256(a.v)}; }
SIMD_FN Float8 HighHalf(Float16 a) { return {_mm512_extractf32x8_ps(a.v, 1)}; }

struct HalfOrder {
  __m512i index;
};
SIMD_FN void OrderHalves(Float4 direction, HalfOrder order[3]) {
  const __m512i lanes = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const __m128i sign = _mm_srli_epi32(_mm_castps_si128(direction.v), 31);
  alignas(16) int swap[4];
  _mm_store_si128(reinterpret_cast<__m128i*>(swap), _mm_slli_epi32(sign, 3));
  for (int axis = 0; axis < 3; ++axis)
    order[axis].index = _mm512_xor_si512(lanes, _mm512_set1_epi32(swap[axis]));
}
template <int Axis>
SIMD_FN Float16 Spread(Float8 a) {
  constexpr int L = Axis, H = 4 + Axis;
  const __m512i lanes = _mm512_setr_epi32(L, L, L, L, L, L, L, L, H, H, H, H, H, H, H, H);
  return {_mm512_permutexvar_ps(lanes, _mm512_castps256_ps512(a.v))};
}
SIMD_FN Float16 Load16(const float* p, HalfOrder order) {
  return {_mm512_permutexvar_ps(order.index, _mm512_load_ps(p))};
}
SIMD_FN Float16 MulAdd(Float16 a, Float16 b, Float16 c) { return {_mm512_fmadd_ps(a.v, b.v, c.v)}; }
SIMD_FN Float16 Set16(float x) { return {_mm512_set1_ps(x)}; }
SIMD_FN Float16 operator-(Float16 a, Float16 b) { return {_mm512_sub_ps(a.v, b.v)}; }
SIMD_FN Float16 operator*(Float16 a, Float16 b) { return {_mm512_mul_ps(a.v, b.v)}; }
SIMD_FN Float16 NextQuarters(Float16 a) { return {_mm512_shuffle_f32x4(a.v, a.v, 0x39)}; }
SIMD_FN Float4 Quarter0(Float16 a) { return {_mm512_castps512_ps128(a.v)}; }
SIMD_FN Float16 operator+(Float16 a, Float16 b) { return {_mm512_add_ps(a.v, b.v)}; }
SIMD_FN Float16 Max(Float16 a, Float16 b) { return {_mm512_max_ps(a.v, b.v)}; }
SIMD_FN Float16 Abs(Float16 a) { return {_mm512_abs_ps(a.v)}; }
SIMD_FN Float4 Quarter1(Float16 a) { return {_mm512_extractf32x4_ps(a.v, 1)}; }
SIMD_FN Float4 Quarter2(Float16 a) { return {_mm512_extractf32x4_ps(a.v, 2)}; }
SIMD_FN Float4 Quarter3(Float16 a) { return {_mm512_extractf32x4_ps(a.v, 3)}; }
SIMD_FN Float8 Quarters12(Float16 a) {
  return {_mm512_castps512_ps256(_mm512_shuffle_f32x4(a.v, a.v, 0x39))};
}

}  // namespace snell::bvh::SNELL_ISA
