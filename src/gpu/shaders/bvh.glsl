// SPDX-License-Identifier: Apache-2.0
//
// The kernel's seam with a device, by the tree of src/gpu/trace_tree.h: wide nodes with quantised boxes and a stack
// of groups of children (Ylitie, Karras and Laine 2017, section 4). Of equal hits the one with the smaller instance
// and then the smaller primitive wins, as on the CPU. Written in the kernel's dialect: the tests compile it as
// C++ too, to compare it with the CPU's traversal and to count its loops.
#ifndef SNELL_GPU_BVH_GLSL
#define SNELL_GPU_BVH_GLSL

#include "kernel/scene_motion.h"

// A ray prepared for the nodes of one tree.
struct NodeRay {
  vec3 o;
  vec3 inverse;  // of its direction
  vec3 error;    // of its distances to planes
  uint upward;   // bit a: it runs up along axis a
};

SCENE_FN float NodeInverse(float d) {
  float size = Max(abs(d), 1e-24f);
  return d < 0.0f ? -1.0f / size : 1.0f / size;
}

SCENE_FN NodeRay PrepareForNodes(vec3 o, vec3 d, vec3 slack) {
  NodeRay ray;
  ray.o = o;
  ray.inverse = vec3(NodeInverse(d.x), NodeInverse(d.y), NodeInverse(d.z));
  ray.error = (Abs(o) * Gamma(16.0f) + slack) * Abs(ray.inverse);
  ray.upward = (d.x < 0.0f ? 0u : 1u) + (d.y < 0.0f ? 0u : 2u) + (d.z < 0.0f ? 0u : 4u);
  return ray;
}

// The children of a node that a ray meets before tMax: bit (slot ^ ray.upward), so that the highest bit is the child
// that comes first, about.
SCENE_FN uint MeetChildren(uint index, IN(NodeRay) ray, float tMax) {
  vec3 origin = traceNodes[index].origin;
  uint exponents = traceNodes[index].exponents;
  vec3 scale = vec3(uintBitsToFloat((exponents & 255u) << 23u) * ray.inverse.x,
                    uintBitsToFloat((exponents >> 8u & 255u) << 23u) * ray.inverse.y,
                    uintBitsToFloat((exponents >> 16u & 255u) << 23u) * ray.inverse.z);
  vec3 start = (origin - ray.o) * ray.inverse;
  vec3 nearStart = start - ray.error;
  vec3 farStart = start + ray.error;
  uint nearX = (ray.upward & 1u) != 0u ? 0u : 2u;
  uint nearY = (ray.upward & 2u) != 0u ? 4u : 6u;
  uint nearZ = (ray.upward & 4u) != 0u ? 8u : 10u;
  uint met = 0u;
  for (uint part = 0u; part < 2u; ++part) {
    uint nx = traceNodes[index].planes[nearX + part];
    uint fx = traceNodes[index].planes[2u - nearX + part];
    uint ny = traceNodes[index].planes[nearY + part];
    uint fy = traceNodes[index].planes[10u - nearY + part];
    uint nz = traceNodes[index].planes[nearZ + part];
    uint fz = traceNodes[index].planes[18u - nearZ + part];
    for (uint i = 0u; i < 4u; ++i) {
      uint at = 8u * i;
      float tNear = Max(Max(float(nx >> at & 255u) * scale.x + nearStart.x,
                            float(ny >> at & 255u) * scale.y + nearStart.y),
                        Max(float(nz >> at & 255u) * scale.z + nearStart.z, 0.0f));
      float tFar = Min(Min(float(fx >> at & 255u) * scale.x + farStart.x,
                           float(fy >> at & 255u) * scale.y + farStart.y),
                       Min(float(fz >> at & 255u) * scale.z + farStart.z, tMax));
      if (tNear <= tFar) met |= 1u << ((4u * part + i) ^ ray.upward);
    }
  }
  return met;
}

// Take a candidate if it is nearer than the best one, or as near and first in order.
SCENE_FN void TakeNearer(float t, uint instance, uint primitive, INOUT(float) best,
                         INOUT(Hit) hit) {
  bool first = instance < hit.instance || (instance == hit.instance && primitive < hit.primitive);
  if (t <= 0.0f || t > best || (t == best && !first)) return;
  best = t;
  hit.instance = instance;
  hit.primitive = primitive;
}

SCENE_FN void MeetShapes(uint first, uint count, IN(Ray) ray, uint mask, INOUT(float) best,
                         INOUT(Hit) hit) {
  for (uint i = first; i < first + count; ++i) {
    uint index = traceShapes[i];
    LET(Shape) shape = shapes[index];
    if ((objects[shape.object].mask & mask) == 0u) continue;
    Ray local = ShapeRay(shape, ray);
    TakeNearer(IntersectShape(shape, local.o, local.d), INSTANCE_SHAPE, index, best, hit);
  }
}

// The nearest hit, or, if `anyWillDo`, the first one found.
SCENE_FN Hit Search(IN(Ray) ray, float tMax, uint mask, bool anyWillDo) {
  Hit hit;
  hit.primitive = None;
  hit.instance = None;
  float best = tMax;
  uvec2 stack[TraceStackSize];  // nodes, and which of their children are still to be seen
  uint top = 0u;
  uint bottom = None;  // of the stack's part that belongs to the instance
  uint instance = None;
  // The shapes without bounds come first, and the tree, if rays of this mask see it, waits as a group of its own
  uint child = None;
  bool hasTree = traceWorld.tree.root != None && (traceWorld.tree.mask & mask) != 0u;
  uvec2 group = uvec2(None, hasTree ? 1u : 0u);
  NodeRay nodeRay = PrepareForNodes(ray.o, ray.d, traceWorld.tree.slack);
  ShearedRay sheared = Shear(ray.o, ray.d);
  for (;;) {
    // See what is in the child
    bool isLeaf = (child & TRACE_LEAF) != 0u;
    uint kind = child >> TRACE_KIND_SHIFT & 3u;
    uint count = (child >> TRACE_COUNT_SHIFT & 7u) + 1u;
    uint first = child & TRACE_FIRST_MASK;
    if (child == None) {
      kind = TRACE_SHAPES;
      first = 0u;
      count = traceWorld.unboundedCount;
    }
    uint met = 0u;
    if (!isLeaf) {
      met = MeetChildren(child, nodeRay, best);
    } else if (kind == TRACE_TRIANGLES || kind == TRACE_DEFORMING) {
      for (uint i = first; i < first + count; ++i) {
        uint index;
        vec3 v0;
        vec3 v1;
        vec3 v2;
        if (kind == TRACE_TRIANGLES) {
          if ((traceTriangles[i].mask & mask) == 0u) continue;
          index = traceTriangles[i].index;
          v0 = traceTriangles[i].v0;
          v1 = traceTriangles[i].v1;
          v2 = traceTriangles[i].v2;
        } else {
          index = traceShapes[i];
          LET(Triangle) triangle = triangles[index];
          LET(Mesh) mesh = meshes[triangle.mesh];
          v0 = PositionAt(mesh, triangle.v0, ray.time);
          v1 = PositionAt(mesh, triangle.v1, ray.time);
          v2 = PositionAt(mesh, triangle.v2, ray.time);
        }
        TriangleHit found = IntersectTriangle(sheared, v0, v1, v2);
        TakeNearer(found.t, instance, index, best, hit);
      }
    } else if (kind == TRACE_SHAPES) {
      MeetShapes(first, count, ray, mask, best, hit);
    } else {
      met = (1u << count) - 1u;
    }
    if (anyWillDo && hit.primitive != None) return hit;

    // Its children come first; what is left of the others waits
    if (met != 0u) {
      if (group.y != 0u) {
        stack[top] = group;
        top += 1u;
      }
      group = uvec2(child, met);
    } else if (group.y == 0u) {
      if (top == bottom) {
        // Leave the instance
        bottom = None;
        instance = None;
        nodeRay = PrepareForNodes(ray.o, ray.d, traceWorld.tree.slack);
        sheared = Shear(ray.o, ray.d);
      }
      if (top == 0u) return hit;
      top -= 1u;
      group = stack[top];
    }

    // Go on with one of the group
    uint bit = uint(findMSB(group.y));
    group.y = group.y & ~(1u << bit);
    if ((group.x & TRACE_LEAF) == 0u) {
      child = traceNodes[group.x].child[bit ^ nodeRay.upward];
    } else if (group.x == None) {
      child = traceWorld.tree.root;
    } else {
      // Enter an instance, unless rays of this mask do not see it
      uint place = (group.x & TRACE_FIRST_MASK) + bit;
      child = TRACE_LEAF;  // the first triangle is none
      if ((traceTrees[place].mask & mask) != 0u) {
        if (group.y != 0u) {
          stack[top] = group;
          top += 1u;
          group.y = 0u;
        }
        bottom = top;
        instance = traceTrees[place].instance;
        child = traceTrees[place].root;
        Ray local = ToLocalRay(InstanceAt(instance, ray.time), ray.o, ray.d);
        nodeRay = PrepareForNodes(local.o, local.d, traceTrees[place].slack);
        sheared = Shear(local.o, local.d);
      }
    }
  }
}

SCENE_FN Hit ClosestHit(IN(Ray) ray, float tMax, uint mask) {
  return Search(ray, tMax, mask, false);
}

SCENE_FN bool AnyHit(IN(Ray) ray, float tMax, uint mask) {
  return Search(ray, tMax, mask, true).primitive != None;
}

#endif
