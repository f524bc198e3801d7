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
SIMD_FN void OrderHalves(const float* direction, HalfOrder order[3]) {
  const __m512i lanes = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const __m512i eight = _mm512_set1_epi32(8);
  for (int axis = 0; axis < 3; ++axis) {
    const __m512i bits = _mm512_castps_si512(_mm512_set1_ps(direction[axis]));
    // lanes ^ (sign & 8)
    order[axis].index = _mm512_ternarylogic_epi32(lanes, _mm512_srai_epi32(bits, 31), eight, 0x78);
  }
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

// Append the lanes `lanes` of `from`, or of high and low parts, to a list; its end afterwards. Write eight
// elements.
SIMD_FN std::uint32_t* Append(std::uint32_t* to, const std::uint32_t* from, std::uint32_t lanes) {
  const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i*>(from));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                      _mm256_maskz_compress_epi32(__mmask8(lanes), all));
  return to + __builtin_popcount(lanes);
}
SIMD_FN std::uint64_t* Append(std::uint64_t* to, Float8 high, const std::uint32_t* low,
                              std::uint32_t lanes) {
  const __m512i places = _mm512_setr_epi32(16, 0, 17, 1, 18, 2, 19, 3, 20, 4, 21, 5, 22, 6, 23, 7);
  const __m512i all = _mm512_permutex2var_epi32(_mm512_castps_si512(_mm512_castps256_ps512(high.v)),
                                                places, _mm512_load_si512(low));
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi64(__mmask8(lanes), all));
  return to + __builtin_popcount(lanes);
}

}  // namespace snell::bvh::SNELL_ISA
