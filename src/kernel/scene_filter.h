// SPDX-License-Identifier: Apache-2.0
//
// The pixel filter, sampled instead of weighted: each sample's place in the image plane is drawn from the
// filter's density, so every sample counts the same and pixels stay independent, as denoisers want (Ernst,
// Stamminger, Greiner 2006, "Filter importance sampling"). The host tabulates the quantile function of
// whichever filter is asked for (src/cpu/flatten_filter.h); all are symmetric and separable.
// Reads the render's parameters.
#ifndef SNELL_KERNEL_SCENE_FILTER_H
#define SNELL_KERNEL_SCENE_FILTER_H

// The offset below which the share u ∈ [0, 1) of the filter lies, in pixels.
SCENE_FN float FilterQuantile(float u) {
  // Place the nearer tail's mass among the table's octaves by the float's own exponent and leading bits
  float mass = Max(Min(u, 1.0f - u), 5.9604644775390625e-8f);
  uint place = floatBitsToUint(mass) - 0x33800000u;
  uint cell = place >> 18;
  float between = float(place & 0x3ffffu) * 3.814697265625e-6f;
  float x = Lerp(between, params.filterQuantiles[cell], params.filterQuantiles[cell + 1u]);
  return u < 0.5f ? x : -x;
}

// The sample's offset from the pixel's centre, in pixels.
SCENE_FN vec2 SamplePixelFilter(vec2 u) { return vec2(FilterQuantile(u.x), FilterQuantile(u.y)); }

#endif
