// SPDX-License-Identifier: Apache-2.0
//
// What the Whitted integrator keeps between its steps: the branch of the ray tree being followed and the
// radiance gathered so far. The branches that wait are kept by the device, in its array `branches` of
// WhittedStackSize places: they are too large to be copied in and out of functions, as GLSL does, and a GPU
// that runs the steps one by one leaves them in memory.
#ifndef SNELL_KERNEL_WHITTED_STATE_H
#define SNELL_KERNEL_WHITTED_STATE_H

#include "kernel/ray.h"

KERNEL_BEGIN

// A ray of the tree that has not been traced yet.
struct WhittedBranch {
  Ray ray;
  Spectrum weight;   // what its radiance counts in the pixel
  uint depth;        // 1 for rays from the camera
  uint scatterings;  // reflections and refractions so far
  uint described;    // 1: the denoiser has been told what is there (aov.h)
  float
      coneWidth;  // diameter at the origin of what the ray stands for (Akenine-Möller et al. 2021), metres
  MediumStack media;
};

// The lesser of two branches is followed first and the greater waits, so the followed weight, as the mean of
// its channels, halves with every branch that waits: thirty-two places suffice at any depth for branches of
// which one channel weighs 3 · 2⁻³² or more.
CONST uint WhittedStackSize = 32u;
CONST float LeastWeight = 1e-9f;

// Shader terms of a material whose colours are evaluated once per hit; further ones once per light sample.
CONST uint CachedTerms = 8u;

// Why a ray branches off.
CONST uint BRANCH_REFLECTED = 0u;
CONST uint BRANCH_REFRACTED = 1u;
CONST uint BRANCH_OPENING = 2u;  // straight on where the surface is open

struct WhittedState {
  WhittedBranch branch;
  uint alive;    // 1: `branch` is to be traced
  uint waiting;  // how many of `branches` are to be traced later
  Spectrum L;
  uint seed;         // of this pixel
  uint sampleIndex;  // of this pixel
  uint dimension;    // pairs of sample dimensions used
  uint dropped;      // branches that found the stack full
  RayCounts rays;
};

KERNEL_END

#endif
