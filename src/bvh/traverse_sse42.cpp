// SPDX-License-Identifier: Apache-2.0
//
// The traversal compiled for SSE4.2.
#define SNELL_ISA sse42
#include "bvh/simd_sse42.h"
#include "bvh/traverse.inl"
