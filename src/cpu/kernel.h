// SPDX-License-Identifier: Apache-2.0
//
// The kernel bound to the CPU: the scene's buffers under the names that the kernel reads (in GLSL:
// src/gpu/shaders/buffers.glsl), the two searches that a device provides, and the parts of the kernel that
// read buffers, which become members.
#pragma once

#include "bvh/bvh.h"
#include "kernel/values.h"

namespace snell::cpu {

using namespace kernel;

// Views only: cheap to copy, one per thread.
struct Kernel {
  const RenderParams& params;
  const Object* objects;
  const Shape* shapes;
  const Instance* instances;
  const Mesh* meshes;
  const Triangle* triangles;
  const vec3* positions;
  const vec3* normals;
  const vec2* uvs;
  const vec4* tangents;
  const vec4* colors;
  const Material* materials;
  const Term* terms;
  const Physical* physicals;
  const Texture* textures;
  const Image* images;
  const uint* texels;
  const Grid* grids;
  const Light* lights;
  const Emitter* emitters;
  const float* albedos;
  const LightNode* lightNodes;
  const MotionKey* motions;
  const bvh::Bvh& bvh;
  WhittedBranch* branches = nullptr;  // WhittedStackSize places of the thread
  AovSample* aovs = nullptr;          // its record

  Hit ClosestHit(const Ray& ray, float tMax, uint mask) {
    const bvh::Intersection found = bvh.Closest(ray, tMax, mask);
    return {found.primitive, found.instance};
  }
  bool AnyHit(const Ray& ray, float tMax, uint mask) { return bvh.Any(ray, tMax, mask); }

#include "kernel/path.h"
#include "kernel/path_light.h"
#include "kernel/path_medium.h"
#include "kernel/path_sample.h"
#include "kernel/path_shadow.h"
#include "kernel/path_wavelength.h"
#include "kernel/scene_aov.h"
#include "kernel/scene_bsdf.h"
#include "kernel/scene_camera.h"
#include "kernel/scene_emitter.h"
#include "kernel/scene_environment.h"
#include "kernel/scene_filter.h"
#include "kernel/scene_frame.h"
#include "kernel/scene_grid.h"
#include "kernel/scene_image.h"
#include "kernel/scene_light_tree.h"
#include "kernel/scene_medium.h"
#include "kernel/scene_motion.h"
#include "kernel/scene_physical.h"
#include "kernel/scene_profile.h"
#include "kernel/scene_shadow.h"
#include "kernel/scene_surface.h"
#include "kernel/scene_terminator.h"
#include "kernel/scene_texture.h"
#include "kernel/whitted.h"
};

}  // namespace snell::cpu
