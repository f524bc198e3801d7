// SPDX-License-Identifier: Apache-2.0
//
// About how much light a point can receive from a group of sources: what choosing one of many goes by. After Conty
// Estevez and Kulla 2018, "Importance sampling of many lights with adaptive tree splitting", section 3, with the cones
// compared by their cosines as in pbrt-v4, section 12.6.3. Where a source can send light, no bound around it is 0.
#ifndef SNELL_KERNEL_LIGHT_TREE_H
#define SNELL_KERNEL_LIGHT_TREE_H

#include "kernel/falloff.h"
#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// After so many choices a random number has lost half its digits, and another one takes its place.
CONST uint LightTreeLevelsPerNumber = 12u;

// Cosine and sine of max(0, a − b) for angles of [0, π].
FN float CosOfDifference(float sinA, float cosA, float sinB, float cosB) {
  return cosA > cosB ? 1.0f : cosA * cosB + sinA * sinB;
}
FN float SinOfDifference(float sinA, float cosA, float sinB, float cosB) {
  return cosA > cosB ? 0.0f : sinA * cosB - cosA * sinB;
}

// The importance of a node's sources at p. `n` is the receiving surface's normal, or 0 where light counts from all
// sides.
FN float LightNodeImportance(IN(LightNode) node, vec3 p, vec3 n) {
  vec3 toNode = node.center - p;
  float distance = Length(toNode);
  float nearest = Max(distance - node.radius, 0.0f);
  // No closer than one source's size, nor than many lie on average: at the middle of a cube full of sources the mean of
  // 1/d² is 6/r². Nor than a nanometre
  bool isLeaf = (node.flags & LIGHT_NODE_LEAF) != 0u;
  float closest = isLeaf ? node.radius : node.radius * 0.41f;
  float d = Max(distance, Max(closest, 1e-9f));
  float importance = node.power.x + node.power.y / d + node.power.z / (d * d);
  importance *= RangeWindow(nearest, node.reach);
  if (distance <= node.radius || distance <= 0.0f) return importance;

  // The angle by which directions to the sources differ from that to their middle
  vec3 wi = toNode / distance;
  float sinSpread = node.radius / distance;
  float cosSpread = SafeSqrt(1.0f - sinSpread * sinSpread);

  // The least angle between p and a source's normal
  float cosW = -Dot(node.axis, wi);
  if ((node.flags & LIGHT_NODE_TWO_SIDED) != 0u) cosW = abs(cosW);
  // A single flat source is dark behind its plane
  if (isLeaf && node.cosThetaO == 1.0f && cosW <= 0.0f) return 0.0f;
  float sinW = SafeSqrt(1.0f - cosW * cosW);
  float sinO = SafeSqrt(1.0f - node.cosThetaO * node.cosThetaO);
  float cosX = CosOfDifference(sinW, cosW, sinO, node.cosThetaO);
  float sinX = SinOfDifference(sinW, cosW, sinO, node.cosThetaO);
  float cosLeast = CosOfDifference(sinX, cosX, sinSpread, cosSpread);
  if (cosLeast <= node.cosThetaE) return 0.0f;
  importance *= cosLeast;

  // The least angle between a source and the surface's normal
  if (LengthSquared(n) > 0.0f) {
    float cosI = Dot(n, wi);
    float cosReceived = CosOfDifference(SafeSqrt(1.0f - cosI * cosI), cosI, sinSpread, cosSpread);
    importance *= Max(cosReceived, 0.0f);
  }
  return importance;
}

// The same of a directional light: its irradiance on the surface.
FN float DirectionalImportance(IN(Light) light, vec3 n) {
  float brightness = MaxChannel(light.emission);
  if (LengthSquared(n) == 0.0f) return brightness;
  float cosI = -Dot(n, light.direction);
  float cosSpread = 1.0f - light.oneMinusCos;
  float sinSpread = SafeSqrt(1.0f - cosSpread * cosSpread);
  float sinI = SafeSqrt(1.0f - cosI * cosI);
  return brightness * Max(CosOfDifference(sinI, cosI, sinSpread, cosSpread), 0.0f);
}

KERNEL_END

#endif
