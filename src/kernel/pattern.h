// SPDX-License-Identifier: Apache-2.0
//
// The procedural textures as functions of a point of pattern space, where one unit is one period.
#ifndef SNELL_KERNEL_PATTERN_H
#define SNELL_KERNEL_PATTERN_H

#include "kernel/noise.h"
#include "kernel/types.h"

KERNEL_BEGIN

// Surfaces often lie exactly on the border of two cells (a plane at y = 0); this moves the borders off them.
CONST float PatternShift = 1.0f / 4096.0f;

// A wave of period 1 that is 1 at the integers and 0 between them.
FN float PatternWave(float x) { return 0.5f + 0.5f * Cos(2.0f * Pi * (x - floor(x))); }

// Whether the cell of unit length that holds x has an odd number: 1 or 0. Safe for any finite x.
FN float CellParity(float x) {
  float cell = floor(x);
  return cell - 2.0f * floor(0.5f * cell);
}

// Where the pattern stands between colorA (0) and colorB (1) at p.
FN float PatternBlend(IN(Texture) texture, vec3 p) {
  switch (texture.kind) {
    case TEXTURE_CHECKER: {
      vec3 q = p + vec3(PatternShift, PatternShift, PatternShift);
      return CellParity(CellParity(q.x) + CellParity(q.y) + CellParity(q.z));
    }
    case TEXTURE_STRIPES: {
      float x = p.x + PatternShift;
      if (texture.smoothEdges == 1u) return 1.0f - PatternWave(x);
      return x - floor(x) < 0.5f ? 0.0f : 1.0f;
    }
    case TEXTURE_GRADIENT: return Clamp(p.y, 0.0f, 1.0f);
    case TEXTURE_MARBLE: {
      float wave = PatternWave(p.x + texture.turbulence * FractalNoise(p, texture.octaves));
      return texture.smoothEdges == 1u ? wave : wave * wave * wave;
    }
    case TEXTURE_WOOD: {
      // Rings around the y axis, drawn out along it
      float wobble = texture.turbulence * FractalNoise(vec3(p.x, 0.2f * p.y, p.z), texture.octaves);
      float ring = sqrt(p.x * p.x + p.z * p.z) + wobble;
      float phase = ring - floor(ring);
      if (texture.smoothEdges == 1u) return PatternWave(phase);
      return phase * phase * (phase > 0.9f ? (1.0f - phase) * 10.0f : 1.0f);
    }
  }
  return 0.0f;
}

FN Spectrum EvalPattern(IN(Texture) texture, vec3 p) {
  return Lerp(PatternBlend(texture, p), texture.colorA, texture.colorB);
}

KERNEL_END

#endif
