// SPDX-License-Identifier: Apache-2.0
//
// The traversal compiled for plain C++.
#define SNELL_ISA portable
#include "bvh/simd_portable.h"
#include "bvh/traverse.inl"
