// SPDX-License-Identifier: Apache-2.0
//
// The traversal compiled for AVX2 and FMA.
#define SNELL_ISA avx2
#include "bvh/simd_avx2.h"
#include "bvh/traverse.inl"
