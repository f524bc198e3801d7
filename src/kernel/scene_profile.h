// SPDX-License-Identifier: Apache-2.0
//
// How a point or spot light shines by direction, where that was measured: a table of shares of its greatest intensity,
// among the words of pictures. First come the numbers of vertical and horizontal angles, then both sorts in radians,
// then the shares, vertical angles fastest. Reads the texels.
#ifndef SNELL_KERNEL_SCENE_PROFILE_H
#define SNELL_KERNEL_SCENE_PROFILE_H

SCENE_FN float ProfileNumber(uint word) { return uintBitsToFloat(texels[word]); }

// The last of `count` rising numbers, but for the very last, that is not above x.
SCENE_FN uint ProfileInterval(uint first, uint count, float x) {
  uint low = 0u;
  uint high = count - 1u;
  while (low + 1u < high) {
    uint middle = (low + high) >> 1;
    if (ProfileNumber(first + middle) <= x) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

// How far x lies from a number towards the next one.
SCENE_FN float ProfileFraction(uint word, float x) {
  float a = ProfileNumber(word);
  return Clamp((x - a) / Max(ProfileNumber(word + 1u) - a, 1e-9f), 0.0f, 1.0f);
}

// The share of a light's greatest intensity that it sends towards p; 1 for lights that shine evenly.
SCENE_FN float ProfileShare(IN(Light) light, vec3 p) {
  if (light.profile == None) return 1.0f;
  vec3 d = p - light.position;
  float x = Dot(d, light.edgeU);
  float y = Dot(d, light.edgeV);
  uint verticals = texels[light.profile];
  uint horizontals = texels[light.profile + 1u];
  uint firstVertical = light.profile + 2u;
  uint firstHorizontal = firstVertical + verticals;
  uint shares = firstHorizontal + horizontals;

  float theta = Atan2(sqrt(x * x + y * y), Dot(d, light.direction));
  if (theta < ProfileNumber(firstVertical)) return 0.0f;
  if (theta > ProfileNumber(firstHorizontal - 1u)) return 0.0f;
  uint v = ProfileInterval(firstVertical, verticals, theta);
  float t = ProfileFraction(firstVertical + v, theta);
  uint near = shares + v;
  if (horizontals == 1u) return Lerp(t, ProfileNumber(near), ProfileNumber(near + 1u));

  float phi = Atan2(y, x);
  if (phi < 0.0f) phi += 2.0f * Pi;
  uint h = ProfileInterval(firstHorizontal, horizontals, phi);
  near += h * verticals;
  uint far = near + verticals;
  return Lerp(ProfileFraction(firstHorizontal + h, phi),
              Lerp(t, ProfileNumber(near), ProfileNumber(near + 1u)),
              Lerp(t, ProfileNumber(far), ProfileNumber(far + 1u)));
}

#endif
