// SPDX-License-Identifier: Apache-2.0
//
// The kernel bound to the CPU: the scene's buffers, the two searches that a device provides, and the parts of the kernel
// that read buffers, which become members.
#pragma once

#include "bvh/bvh.h"
#include "cpu/scene_view.h"
#include "kernel/values.h"

namespace snell::cpu {

// Cheap to copy, one per thread.
struct Kernel : SceneView {
  const bvh::Bvh& bvh;
  WhittedBranch* branches = nullptr;  // WhittedStackSize places of the thread
  AovSample* aovs = nullptr;          // its record

  Hit ClosestHit(const Ray& ray, float tMax, uint mask) {
    const bvh::Intersection found = bvh.Closest(ray, tMax, mask);
    return {found.primitive, found.instance};
  }
  bool AnyHit(const Ray& ray, float tMax, uint mask) { return bvh.Any(ray, tMax, mask); }

#include "cpu/kernel_members.inl"
};

// Views of both, which must outlive the kernel.
inline Kernel BindKernel(const FlatScene& flat, const bvh::Bvh& bvh) { return {ViewOf(flat), bvh}; }

}  // namespace snell::cpu
