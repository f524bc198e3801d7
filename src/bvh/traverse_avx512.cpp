// SPDX-License-Identifier: Apache-2.0
//
// The traversal compiled for AVX-512 .
#define SNELL_ISA avx512
#include "bvh/simd_avx512.h"
#include "bvh/traverse.inl"
