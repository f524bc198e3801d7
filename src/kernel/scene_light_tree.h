// SPDX-License-Identifier: Apache-2.0
//
// The tree of all sources that lie somewhere: lights, glowing triangles and shapes (src/cpu/light_tree.h builds it).
// From the root down, one of two children is chosen by their importance at a point; the product of the choices is the
// probability of the source at the end, which is found again from its leaf up. Reads the tree.
#ifndef SNELL_KERNEL_SCENE_LIGHT_TREE_H
#define SNELL_KERNEL_SCENE_LIGHT_TREE_H

SCENE_FN float NodeImportance(uint index, vec3 p, vec3 n) {
  LET(LightNode) node = lightNodes[index];
  if (params.lightSampling == LIGHTS_BY_POWER) return node.power.x + node.power.y + node.power.z;
  return LightNodeImportance(node, p, n);
}

// The share of the first of two children; below 0 if both are dark.
SCENE_FN float ShareOfFirst(uint first, vec3 p, vec3 n) {
  float a = NodeImportance(first, p, n);
  float b = NodeImportance(first + 1u, p, n);
  return a + b > 0.0f ? a / (a + b) : -1.0f;
}

// A source, chosen by u, for a point with the normal n (0: light counts from all sides): a light or, counted on from
// the lights, an emitter; with its probability. None where all are dark.
SCENE_FN uint SampleLightTree(vec3 p, vec3 n, vec2 u, OUT(float) pick) {
  pick = 0.0f;
  if (params.lightNodeCount == 0u) return None;
  float probability = 1.0f;
  float left = u.x;
  uint index = 0u;
  for (uint level = 1u; (lightNodes[index].flags & LIGHT_NODE_LEAF) == 0u; ++level) {
    uint first = lightNodes[index].first;
    float share = ShareOfFirst(first, p, n);
    if (share < 0.0f) return None;
    // Either way the number is stretched to be uniform again
    if (left < share) {
      index = first;
      probability *= share;
      left = left / share;
    } else {
      index = first + 1u;
      probability *= 1.0f - share;
      left = (left - share) / (1.0f - share);
    }
    left = level == LightTreeLevelsPerNumber ? u.y : Min(left, 0.99999994f);
  }
  pick = probability;
  return lightNodes[index].first;
}

// The probability that SampleLightTree ends at a leaf; None has none.
SCENE_FN float PdfLightTree(vec3 p, vec3 n, uint leaf) {
  if (leaf == None) return 0.0f;
  float probability = 1.0f;
  uint index = leaf;
  while (index != 0u && probability > 0.0f) {
    // Siblings lie side by side, the first at an odd place
    bool isFirst = (index & 1u) == 1u;
    float share = ShareOfFirst(isFirst ? index : index - 1u, p, n);
    if (share < 0.0f) return 0.0f;
    probability *= isFirst ? share : 1.0f - share;
    index = lightNodes[index].parent;
  }
  return probability;
}

#endif
