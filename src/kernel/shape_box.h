// SPDX-License-Identifier: Apache-2.0
//
// The cube [−1, 1]³ of its space; boxes are cubes under an affine map. Each face has the whole texture,
// upright as seen from outside.
#ifndef SNELL_KERNEL_SHAPE_BOX_H
#define SNELL_KERNEL_SHAPE_BOX_H

#include "kernel/math.h"
#include "kernel/shape_surface.h"

KERNEL_BEGIN

// The parameters at which a coordinate o + t·d enters and leaves [lower, upper]; an empty interval if never.
FN vec2 SlabInterval(float o, float d, float lower, float upper) {
  if (d == 0.0f) {
    bool within = o >= lower && o <= upper;
    return within ? vec2(-Infinite, Infinite) : vec2(Infinite, -Infinite);
  }
  float t0 = (lower - o) / d;
  float t1 = (upper - o) / d;
  return vec2(Min(t0, t1), Max(t0, t1));
}

// The first end of [enter, leave] at t > 0, or −1.
FN float FirstOfInterval(float enter, float leave) {
  if (enter > leave) return -1.0f;
  return enter > 0.0f ? enter : (leave > 0.0f ? leave : -1.0f);
}

FN float IntersectBox(vec3 o, vec3 d) {
  vec2 x = SlabInterval(o.x, d.x, -1.0f, 1.0f);
  vec2 y = SlabInterval(o.y, d.y, -1.0f, 1.0f);
  vec2 z = SlabInterval(o.z, d.z, -1.0f, 1.0f);
  return FirstOfInterval(Max(x.x, Max(y.x, z.x)), Min(x.y, Min(y.y, z.y)));
}

FN LocalSurface BoxSurface(vec3 o, vec3 d, float t) {
  // Find the face that ends the interval: the last one on the way in, the first one on the way out
  vec2 x = SlabInterval(o.x, d.x, -1.0f, 1.0f);
  vec2 y = SlabInterval(o.y, d.y, -1.0f, 1.0f);
  vec2 z = SlabInterval(o.z, d.z, -1.0f, 1.0f);
  bool enters = Max(x.x, Max(y.x, z.x)) > 0.0f;
  vec3 order = enters ? vec3(x.x, y.x, z.x) : vec3(-x.y, -y.y, -z.y);
  bool faceX = order.x >= order.y && order.x >= order.z;
  bool faceY = !faceX && order.y >= order.z;
  float side = CopySign(1.0f, faceX ? d.x : (faceY ? d.y : d.z)) * (enters ? -1.0f : 1.0f);

  LocalSurface s;
  s.p = o + t * d;
  s.p = vec3(Clamp(s.p.x, -1.0f, 1.0f), Clamp(s.p.y, -1.0f, 1.0f), Clamp(s.p.z, -1.0f, 1.0f));
  s.error = vec3(0.0f, 0.0f, 0.0f);
  if (faceX) {
    s.p.x = side;
    s.n = vec3(side, 0.0f, 0.0f);
    s.dpdu = vec3(0.0f, 0.0f, -2.0f * side);
    s.uv = vec2(0.5f - 0.5f * side * s.p.z, 0.5f + 0.5f * s.p.y);
  } else if (faceY) {
    s.p.y = side;
    s.n = vec3(0.0f, side, 0.0f);
    s.dpdu = vec3(2.0f, 0.0f, 0.0f);
    s.uv = vec2(0.5f + 0.5f * s.p.x, 0.5f - 0.5f * side * s.p.z);
  } else {
    s.p.z = side;
    s.n = vec3(0.0f, 0.0f, side);
    s.dpdu = vec3(2.0f * side, 0.0f, 0.0f);
    s.uv = vec2(0.5f + 0.5f * side * s.p.x, 0.5f + 0.5f * s.p.y);
  }
  return s;
}

// The point p of the face with normal n, moved away from the face's edges by `margin` per coordinate, so that
// a ray that starts there and goes in starts inside of the other faces too.
FN vec3 InsetBoxPoint(vec3 p, vec3 n, vec3 margin) {
  vec3 limit =
      vec3(Max(1.0f - margin.x, 0.0f), Max(1.0f - margin.y, 0.0f), Max(1.0f - margin.z, 0.0f));
  return vec3(n.x != 0.0f ? p.x : Clamp(p.x, -limit.x, limit.x),
              n.y != 0.0f ? p.y : Clamp(p.y, -limit.y, limit.y),
              n.z != 0.0f ? p.z : Clamp(p.z, -limit.z, limit.z));
}

KERNEL_END

#endif
