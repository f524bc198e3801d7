// SPDX-License-Identifier: Apache-2.0
//
// The kernel's seam with a device, by testing every primitive in turn: the plainest search there is, with
// the BVH's order among equal hits (smaller t, then smaller instance, then smaller primitive). Serves scenes
// of some dozens of primitives.
#ifndef SNELL_GPU_BRUTE_FORCE_GLSL
#define SNELL_GPU_BRUTE_FORCE_GLSL

// Take a candidate if it is nearer than the best one, or as near and first in order.
void TakeNearer(float t, uint instance, uint primitive, inout float best, inout Hit hit) {
  bool first = instance < hit.instance || (instance == hit.instance && primitive < hit.primitive);
  if (t <= 0.0 || t > best || (t == best && !first)) return;
  best = t;
  hit.instance = instance;
  hit.primitive = primitive;
}

Hit ClosestHit(Ray ray, float tMax, uint mask) {
  Hit hit;
  hit.primitive = None;
  hit.instance = None;
  float best = tMax;
  for (uint i = 0; i < counts.shapes; ++i) {
    Shape shape = shapes[i];
    if ((objects[shape.object].mask & mask) != 0u)
      TakeNearer(IntersectShape(shape, ray.o, ray.d), INSTANCE_SHAPE, i, best, hit);
  }
  ShearedRay world = Shear(ray.o, ray.d);
  for (uint i = 0; i < counts.worldTriangles; ++i) {
    Triangle triangle = triangles[i];
    if ((objects[meshes[triangle.mesh].object].mask & mask) != 0u)
      TakeNearer(IntersectTriangle(world, positions[triangle.v0], positions[triangle.v1],
                                   positions[triangle.v2]).t, None, i, best, hit);
  }
  for (uint k = 0; k < counts.instances; ++k) {
    Instance instance = instances[k];
    if ((objects[instance.object].mask & mask) == 0u) continue;
    Ray localRay = ToLocalRay(instance.toWorld, ray.o, ray.d);
    ShearedRay local = Shear(localRay.o, localRay.d);
    for (uint i = instance.firstTriangle; i < instance.firstTriangle + instance.triangleCount; ++i) {
      Triangle triangle = triangles[i];
      TakeNearer(IntersectTriangle(local, positions[triangle.v0], positions[triangle.v1],
                                   positions[triangle.v2]).t, k, i, best, hit);
    }
  }
  return hit;
}

bool AnyHit(Ray ray, float tMax, uint mask) { return ClosestHit(ray, tMax, mask).primitive != None; }

#endif
