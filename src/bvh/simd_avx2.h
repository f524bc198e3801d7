// SPDX-License-Identifier: Apache-2.0
//
// Vectors of eight floats by AVX2 and FMA; those of four are SSE's.
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
SIMD_FN Float8 MulSub(Float8 a, Float8 b, Float8 c) { return {_mm256_fmsub_ps(a.v, b.v, c.v)}; }
SIMD_FN std::uint32_t MaskLessEqual(Float8 a, Float8 b) {
#ifdef __AVX512VL__
  return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
#else
  return std::uint32_t(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
#endif
}

}  // namespace snell::bvh::SNELL_ISA
