// SPDX-License-Identifier: Apache-2.0
//
// Pictures as textures: filtered in software, so that all devices see the same. Texels lie in one buffer of
// words; a picture's levels of detail follow each other, each half as wide and high as the one before (Williams
// 1983, "Pyramidal parametrics"). The buffer's first 256 words are the linear values of sRGB's codes.
// Reads the pictures and the texels.
#ifndef SNELL_KERNEL_SCENE_IMAGE_H
#define SNELL_KERNEL_SCENE_IMAGE_H

SCENE_FN vec4 FetchTexel(uint encoding, uint word) {
  if (encoding == IMAGE_FLOATS)
    return vec4(uintBitsToFloat(texels[word]), uintBitsToFloat(texels[word + 1u]),
                uintBitsToFloat(texels[word + 2u]), uintBitsToFloat(texels[word + 3u]));
  uint code = texels[word];
  uint r = code & 255u;
  uint g = (code >> 8) & 255u;
  uint b = (code >> 16) & 255u;
  float alpha = float(code >> 24) * ByteUnit;
  if (encoding == IMAGE_SRGB)
    return vec4(uintBitsToFloat(texels[r]), uintBitsToFloat(texels[g]), uintBitsToFloat(texels[b]),
                alpha);
  return vec4(float(r) * ByteUnit, float(g) * ByteUnit, float(b) * ByteUnit, alpha);
}

// A level of a picture at `st`, where (0, 0) is the upper left corner and (1, 1) the lower right one.
SCENE_FN vec4 EvalLevel(IN(Texture) texture, IN(Image) image, uint level, vec2 st) {
  // Find the level
  uint wordsPerTexel = image.encoding == IMAGE_FLOATS ? 4u : 1u;
  uint width = image.width;
  uint height = image.height;
  uint first = image.firstWord;
  for (uint i = 0u; i < level; ++i) {
    first += width * height * wordsPerTexel;
    width = width > 1u ? width >> 1 : 1u;
    height = height > 1u ? height >> 1 : 1u;
  }
  float s = WrapCoordinate(texture.wrapU, st.x) * float(width);
  float t = WrapCoordinate(texture.wrapV, st.y) * float(height);
  if (texture.lookup == LOOKUP_NEAREST) {
    uint x = WrapTexel(WRAP_CLAMP, int(floor(s)), width);
    uint y = WrapTexel(WRAP_CLAMP, int(floor(t)), height);
    return FetchTexel(image.encoding, first + (y * width + x) * wordsPerTexel);
  }

  // Interpolate between the four nearest texels
  float left = floor(s - 0.5f);
  float upper = floor(t - 0.5f);
  float fx = s - 0.5f - left;
  float fy = t - 0.5f - upper;
  vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  for (uint i = 0u; i < 4u; ++i) {
    int right = int(i & 1u);
    int below = int(i >> 1);
    uint x = WrapTexel(texture.wrapU, int(left) + right, width);
    uint y = WrapTexel(texture.wrapV, int(upper) + below, height);
    float weight = (right == 1 ? fx : 1.0f - fx) * (below == 1 ? fy : 1.0f - fy);
    sum += FetchTexel(image.encoding, first + (y * width + x) * wordsPerTexel) * weight;
  }
  return sum;
}

// The picture at pattern coordinates, averaged over a disc of the diameter `footprint` of uv space.
SCENE_FN vec4 EvalImage(IN(Texture) texture, vec2 uv, float footprint) {
  LET(Image) image = images[texture.image];
  vec2 st = vec2(uv.x, 1.0f - uv.y);
  float texelCount = footprint * texture.texelDensity;
  float level = 0.0f;
  if (texture.lookup == LOOKUP_MIPMAP && texelCount > 1.0f)
    level = Min(Log2(texelCount), float(image.levels - 1u));
  float lower = floor(level);
  vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  for (uint i = 0u; i < 2u; ++i) {
    float weight = i == 1u ? level - lower : 1.0f - (level - lower);
    if (weight > 0.0f) sum += EvalLevel(texture, image, uint(lower) + i, st) * weight;
  }
  return sum;
}

#endif
