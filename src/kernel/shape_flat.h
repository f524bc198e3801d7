// SPDX-License-Identifier: Apache-2.0
//
// Shapes in the plane y = 0 of their space, with normal +y: the infinite plane, the rectangle and the disk
// with an optional hole. Texture coordinates run along x and −z, so that an image lies upright for a viewer
// above who looks along −z.
#ifndef SNELL_KERNEL_SHAPE_FLAT_H
#define SNELL_KERNEL_SHAPE_FLAT_H

#include "kernel/math.h"
#include "kernel/shape_surface.h"

KERNEL_BEGIN

// The hit with y = 0, or −1 for rays that are parallel to it or leave it.
FN float IntersectPlane(vec3 o, vec3 d) {
  if (d.y == 0.0f) return -1.0f;
  float t = -o.y / d.y;
  return t < Infinite ? t : -1.0f;
}

FN float IntersectRectangle(vec3 o, vec3 d) {
  float t = IntersectPlane(o, d);
  float u = o.x + t * d.x;
  float v = -(o.z + t * d.z);
  return u >= 0.0f && u <= 1.0f && v >= 0.0f && v <= 1.0f ? t : -1.0f;
}

FN float IntersectDisk(vec3 o, vec3 d, float innerRadius) {
  float t = IntersectPlane(o, d);
  float r2 = Sqr(o.x + t * d.x) + Sqr(o.z + t * d.z);
  return r2 <= 1.0f && r2 >= innerRadius * innerRadius ? t : -1.0f;
}

FN LocalSurface FlatSurface(vec3 o, vec3 d, float t) {
  LocalSurface s;
  s.p = vec3(o.x + t * d.x, 0.0f, o.z + t * d.z);
  s.error = vec3(0.0f, 0.0f, 0.0f);
  s.n = vec3(0.0f, 1.0f, 0.0f);
  s.uv = vec2(s.p.x, -s.p.z);
  s.dpdu = vec3(1.0f, 0.0f, 0.0f);
  return s;
}

// The disk's texture coordinates cover its bounding square.
FN LocalSurface DiskSurface(vec3 o, vec3 d, float t) {
  LocalSurface s = FlatSurface(o, d, t);
  s.uv = vec2(0.5f + 0.5f * s.p.x, 0.5f - 0.5f * s.p.z);
  s.dpdu = vec3(2.0f, 0.0f, 0.0f);
  return s;
}

KERNEL_END

#endif
