// SPDX-License-Identifier: Apache-2.0
//
// The records of buffers that only GPUs have, besides those of the kernel: the tree that rays walk
// (shaders/bvh.glsl), the samples to trace and what they give. All fields are 32 bits wide or vectors of
// such (kernel/types.h).
#ifndef SNELL_GPU_RECORDS_H
#define SNELL_GPU_RECORDS_H

#include "kernel/types.h"

KERNEL_BEGIN

// Where a child leads. Bit 31 marks a leaf; a leaf's bits 29–30 tell its kind, bits 26–28 its count less one, bits
// 0–25 where its first element is. An inner child is the index of its node.
CONST uint TRACE_LEAF = 0x80000000u;
CONST uint TRACE_KIND_SHIFT = 29u;
CONST uint TRACE_COUNT_SHIFT = 26u;
CONST uint TRACE_FIRST_MASK = 0x03ffffffu;
CONST uint TRACE_TRIANGLES = 0u;
CONST uint TRACE_SHAPES = 1u;
CONST uint TRACE_INSTANCES = 2u;
CONST uint TRACE_DEFORMING =
    3u;  // triangles of a mesh that changes its shape: indices among traceShapes

// Groups of children that wait while a ray goes down: one for each level of the world's tree and one mesh's.
CONST uint TraceStackSize = 64u;

// Eight children whose boxes are quantised to 8 bits along each axis (Ylitie, Karras and Laine 2017, "Efficient
// incoherent ray traversal on GPUs through compressed wide BVHs", section 3): a plane is origin + q · step with a
// step that is a power of two. The child in slot s lies, as far as that can be, on the upper side along x if bit 0 of
// s is set, along y if bit 1 is, along z if bit 2 is. A missing child has an inverted box.
struct TraceNode {
  vec3 origin;
  uint exponents;  // of the steps along x, y and z, a byte each, as floats have them
  // By axis: the lower planes of slots 0–3, of 4–7, then the upper ones, a byte each
  uint planes[12];
  uint child[8];
};

// A triangle of a leaf.
struct TraceTriangle {
  vec3 v0;
  vec3 v1;
  vec3 v2;
  uint index;
  uint
      mask;  // of its object; of an instance's triangles all bits, since the instance has been asked
};

// A tree, in the world or placed there by an instance.
struct TraceTree {
  uint root;  // None: it is empty
  uint instance;
  uint mask;
  vec3 slack;  // an error of planes that suits all of the tree, along each axis
};

// What every ray begins with.
struct TraceWorld {
  TraceTree tree;
  uint unboundedCount;  // shapes without bounds, the first of traceShapes
};

// A sample to trace, and what it gives.
struct SampleRequest {
  uvec2 pixel;
  uint index;
};
struct SampleResult {
  Spectrum L;
  float held;
  RayCounts rays;
  uint dropped;
};

KERNEL_END

#endif
