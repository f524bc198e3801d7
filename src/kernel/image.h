// SPDX-License-Identifier: Apache-2.0
//
// How textures of pictures go on beyond their borders.
#ifndef SNELL_KERNEL_IMAGE_H
#define SNELL_KERNEL_IMAGE_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

CONST float ByteUnit = 0.0039215686274509803f;  // 1/255

// A coordinate brought to [0, 1]; huge ones, of which no digits behind the point are left, give 0.
FN float WrapCoordinate(uint mode, float x) {
  if (mode == WRAP_CLAMP) return Clamp(x, 0.0f, 1.0f);
  float cell = floor(x);
  float within = Clamp(x - cell, 0.0f, 1.0f);
  if (mode == WRAP_REPEAT) return within;
  bool odd = cell - 2.0f * floor(0.5f * cell) != 0.0f;
  return odd ? 1.0f - within : within;
}

// The texel of a row of `count` at a place that is at most one outside.
FN uint WrapTexel(uint mode, int place, uint count) {
  int last = int(count) - 1;
  if (mode == WRAP_REPEAT) {
    if (place < 0) return uint(last);
    return place > last ? 0u : uint(place);
  }
  if (place < 0) return 0u;
  return place > last ? uint(last) : uint(place);
}

KERNEL_END

#endif
