// SPDX-License-Identifier: Apache-2.0
//
// The part of the kernel that turns hits into surfaces, bound to plain arrays, and the plainest search for
// the nearest triangle.
#pragma once

#include <vector>

#include "kernel/motion.h"
#include "kernel/shape.h"
#include "kernel/triangle.h"
#include "support/meshes.h"

namespace snell::test {

using namespace kernel;

struct SurfaceKernel {
  const Triangle* triangles = nullptr;
  const Mesh* meshes = nullptr;
  const vec3* positions = nullptr;
  const vec3* normals = nullptr;
  const vec2* uvs = nullptr;
  const vec4* tangents = nullptr;
  const vec4* colors = nullptr;
  const Instance* instances = nullptr;
  const Shape* shapes = nullptr;
  const Object* objects = nullptr;
  const MotionKey* motions = nullptr;

#include "kernel/scene_motion.h"
#include "kernel/scene_surface.h"
};

// A mesh in world space with its records.
struct MeshScene {
  std::vector<vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Mesh> meshes;
  mutable SurfaceKernel kernel;  // its functions are not const, as GLSL has no such thing

  explicit MeshScene(const TriangleMesh& mesh)
      : positions(mesh.positions), meshes{{0, None, None, None, None, None, 0, 0}} {
    for (const uvec3 t : mesh.triangles) triangles.push_back({t.x, t.y, t.z, 0});
    kernel.triangles = triangles.data();
    kernel.meshes = meshes.data();
    kernel.positions = positions.data();
  }
  MeshScene(const MeshScene&) = delete;
  MeshScene& operator=(const MeshScene&) = delete;

  TriangleHit Intersect(uint triangle, const ShearedRay& ray) const {
    const Triangle& t = triangles[triangle];
    return IntersectTriangle(ray, positions[t.v0], positions[t.v1], positions[t.v2]);
  }

  // The nearest triangle, or None.
  Hit Closest(vec3 o, vec3 d) const {
    const ShearedRay ray = Shear(o, d);
    Hit hit = {None, None};
    float best = Infinite;
    for (uint i = 0; i < triangles.size(); ++i) {
      const float t = Intersect(i, ray).t;
      if (t <= 0 || t >= best) continue;
      best = t;
      hit.primitive = i;
    }
    return hit;
  }
};

}  // namespace snell::test
