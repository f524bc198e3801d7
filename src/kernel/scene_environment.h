// SPDX-License-Identifier: Apache-2.0
//
// The environment's map: its radiance, and directions in proportion to its brightness. Texels are interpolated, and
// so are their weights: the density follows what is seen also between a bright texel and a dark one. The two tables for
// sampling are floats in the texel buffer: for each row of texels, the share of all weight above its middle; then, for
// each row, the shares of all weight from the middle of its first texel to those of the 2nd, 3rd … and the first again.
// Reads the pictures and the texels.
#ifndef SNELL_KERNEL_SCENE_ENVIRONMENT_H
#define SNELL_KERNEL_SCENE_ENVIRONMENT_H

SCENE_FN Spectrum MapTexel(uint x, uint y) {
  LET(Image) map = images[params.environment.map];
  uint wordsPerTexel = map.encoding == IMAGE_FLOATS ? 4u : 1u;
  vec4 texel = FetchTexel(map.encoding, map.firstWord + (y * map.width + x) * wordsPerTexel);
  return Spectrum(texel.x, texel.y, texel.z);
}

// The weight of a texel, with its solid angle.
SCENE_FN float TexelWeight(uint x, uint y) {
  return MapWeight(MapTexel(x, y), params.environment.dull) *
         RowSine(y, images[params.environment.map].height);
}

// The map's radiance from the unit direction d, and the density of SampleMap there per solid angle.
SCENE_FN Spectrum MapLe(vec3 d, OUT(float) pdf) {
  uint width = images[params.environment.map].width;
  uint height = images[params.environment.map].height;
  vec2 place = EquirectPlace(d, params.environment.turn);
  float s = place.x * float(width) - 0.5f;
  float t = place.y * float(height) - 0.5f;
  float left = floor(s);
  float upper = floor(t);
  Spectrum L = Spectrum(0.0f, 0.0f, 0.0f);
  float weight = 0.0f;
  for (uint row = 0u; row < 2u; ++row) {
    uint y = WrapTexel(WRAP_CLAMP, int(upper) + int(row), height);
    float share = row == 1u ? t - upper : 1.0f - (t - upper);
    Spectrum here = MapTexel(WrapTexel(WRAP_REPEAT, int(left), width), y);
    Spectrum next = MapTexel(WrapTexel(WRAP_REPEAT, int(left) + 1, width), y);
    L += Lerp(s - left, here, next) * share;
    float dull = params.environment.dull;
    weight +=
        Lerp(s - left, MapWeight(here, dull), MapWeight(next, dull)) * (share * RowSine(y, height));
  }
  float sine = sqrt(d.x * d.x + d.z * d.z);
  pdf = sine > 0.0f ? params.environment.density * weight / sine : 0.0f;
  return L * params.environment.scale;
}

// How much of a row's weight lies left of the middle of texel `x` (1 …; the row's width: all of it), interpolated
// between two rows.
SCENE_FN float WeightBefore(uint rowA, uint rowB, float t, uint x) {
  uint width = images[params.environment.map].width;
  uint rows = params.environment.tables + images[params.environment.map].height;
  return Lerp(t, uintBitsToFloat(texels[rows + rowA * width + x - 1u]),
              uintBitsToFloat(texels[rows + rowB * width + x - 1u]));
}

// A direction, by the density that MapLe tells. The map must have some weight.
SCENE_FN vec3 SampleMap(vec2 u) {
  uint width = images[params.environment.map].width;
  uint height = images[params.environment.map].height;
  uint tables = params.environment.tables;

  // Find the rows between whose middles v lies, from 0 (above the first) to the height (below the last)
  uint low = 0u;
  uint high = height;
  while (low < high) {
    uint middle = (low + high) / 2u;
    if (u.y < uintBitsToFloat(texels[tables + middle])) {
      high = middle;
    } else {
      low = middle + 1u;
    }
  }
  float above = low == 0u ? 0.0f : uintBitsToFloat(texels[tables + low - 1u]);
  float below = low == height ? 1.0f : uintBitsToFloat(texels[tables + low]);
  float within = below > above ? Clamp((u.y - above) / (below - above), 0.0f, 1.0f) : 0.5f;
  uint rowA = low == 0u ? 0u : low - 1u;
  uint rowB = low == height ? height - 1u : low;
  float t = 0.0f;
  float y = low == 0u ? 0.5f * within : float(height) - 0.5f + 0.5f * within;
  if (rowA != rowB) {
    t = SampleLinear(within, WeightBefore(rowA, rowA, 0.0f, width),
                     WeightBefore(rowB, rowB, 0.0f, width));
    y = float(rowA) + 0.5f + t;
  }

  // Find the texels between whose middles it lies in these rows
  float target = u.x * WeightBefore(rowA, rowB, t, width);
  low = 1u;
  high = width;
  while (low < high) {
    uint middle = (low + high) / 2u;
    if (target < WeightBefore(rowA, rowB, t, middle)) {
      high = middle;
    } else {
      low = middle + 1u;
    }
  }
  float before = low == 1u ? 0.0f : WeightBefore(rowA, rowB, t, low - 1u);
  float after = WeightBefore(rowA, rowB, t, low);
  within = after > before ? Clamp((target - before) / (after - before), 0.0f, 1.0f) : 0.5f;
  uint next = low == width ? 0u : low;
  float here = Lerp(t, TexelWeight(low - 1u, rowA), TexelWeight(low - 1u, rowB));
  float there = Lerp(t, TexelWeight(next, rowA), TexelWeight(next, rowB));
  float x = float(low) - 0.5f + SampleLinear(within, here, there);
  return EquirectDirection(vec2(x / float(width), y / float(height)), params.environment.turn);
}

// The background's radiance from the unit direction d, and the density with which it is sampled there.
SCENE_FN Spectrum EnvironmentLe(vec3 d, OUT(float) pdf) {
  pdf = 0.0f;
  if (params.environment.map == None) return GradientLe(params.environment, d);
  return MapLe(d, pdf);
}

// The share of samples of light that go to the map, the others to lights and what glows.
SCENE_FN float EnvironmentShare() { return params.environment.share; }

// A sample of the map as of a light, with its density per solid angle.
SCENE_FN LightLiSample SampleEnvironmentLi(vec2 u, OUT(float) pdf) {
  LightLiSample s;
  s.wi = SampleMap(u);
  s.distance = Infinite;
  s.irradiance = MapLe(s.wi, pdf);
  s.irradiance = s.irradiance * (pdf > 0.0f ? 1.0f / pdf : 0.0f);
  return s;
}

// All that is seen in the unit direction d behind the scene, also the discs of directional lights.
SCENE_FN Spectrum BackgroundLe(vec3 d, bool fromCamera) {
  if (fromCamera && params.environment.visible == 0u) return Spectrum(0.0f, 0.0f, 0.0f);
  float pdf;
  Spectrum L = EnvironmentLe(d, pdf);
  for (uint sun = params.environment.firstSun; sun != None; sun = lights[sun].nextSun)
    L += SunLe(lights[sun], d);
  return L;
}

#endif
