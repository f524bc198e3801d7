// SPDX-License-Identifier: Apache-2.0
//
// The traversal compiled for AVX-512 (VL, 256-bit vectors with mask registers).
#define SNELL_ISA avx512
#include "bvh/simd_avx2.h"
#include "bvh/traverse.inl"
