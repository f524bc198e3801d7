// SPDX-License-Identifier: Apache-2.0
//
// The kernel's seam with a device, by testing every primitive in turn: the plainest search there is, with
// the BVH's order among equal hits (smaller t, then smaller instance, then smaller primitive). Serves scenes
// of some dozens of primitives. Written in the kernel's dialect (kernel/dialect.h): the tests compile it as
// C++ too, to compare the BVH with it and to count its loops.
#ifndef SNELL_GPU_BRUTE_FORCE_GLSL
#define SNELL_GPU_BRUTE_FORCE_GLSL

#include "kernel/scene_motion.h"

// Take a candidate if it is nearer than the best one, or as near and first in order.
SCENE_FN void TakeNearer(float t, uint instance, uint primitive, INOUT(float) best,
                         INOUT(Hit) hit) {
  bool first = instance < hit.instance || (instance == hit.instance && primitive < hit.primitive);
  if (t <= 0.0f || t > best || (t == best && !first)) return;
  best = t;
  hit.instance = instance;
  hit.primitive = primitive;
}

SCENE_FN Hit ClosestHit(IN(Ray) ray, float tMax, uint mask) {
  Hit hit;
  hit.primitive = None;
  hit.instance = None;
  float best = tMax;
  for (uint i = 0u; i < counts.shapes; ++i) {
    LET(Shape) shape = shapes[i];
    if ((objects[shape.object].mask & mask) == 0u) continue;
    Ray local = ShapeRay(shape, ray);
    TakeNearer(IntersectShape(shape, local.o, local.d), INSTANCE_SHAPE, i, best, hit);
  }

  // The triangles of every instance, and then, as of one that has no number, those in world space
  for (uint k = 0u; k <= counts.instances; ++k) {
    bool instanced = k < counts.instances;
    uint first = 0u;
    uint count = counts.worldTriangles;
    Ray local = ray;
    if (instanced) {
      first = instances[k].firstTriangle;
      count = instances[k].triangleCount;
      local = ToLocalRay(InstanceAt(k, ray.time), ray.o, ray.d);
    }
    ShearedRay sheared = Shear(local.o, local.d);
    for (uint i = first; i < first + count; ++i) {
      LET(Triangle) triangle = triangles[i];
      LET(Mesh) mesh = meshes[triangle.mesh];
      uint object = instanced ? instances[k].object : mesh.object;
      if ((objects[object].mask & mask) == 0u) continue;
      TriangleHit candidate = IntersectTriangle(sheared, PositionAt(mesh, triangle.v0, ray.time),
                                                PositionAt(mesh, triangle.v1, ray.time),
                                                PositionAt(mesh, triangle.v2, ray.time));
      TakeNearer(candidate.t, instanced ? k : None, i, best, hit);
    }
  }
  return hit;
}

SCENE_FN bool AnyHit(IN(Ray) ray, float tMax, uint mask) {
  return ClosestHit(ray, tMax, mask).primitive != None;
}

#endif
