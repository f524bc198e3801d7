// SPDX-License-Identifier: Apache-2.0
//
// All that a traversal reads, as plain pointers: the files that are compiled for one instruction set call no
// functions of others (traverse.inl says why).
#pragma once

#include "bvh/node.h"
#include "kernel/types.h"

namespace snell::bvh {

// A ray, and how far it looks: for hits at 0 < t ≤ tMax, in units of d's length.
struct Query {
  kernel::Ray ray;
  float tMax;
};

// The nearest hit. `primitive` is None, and t the limit that was given, if there is none; else kernel::Hit
// says what the ids mean.
struct Intersection {
  float t;
  std::uint32_t primitive;
  std::uint32_t instance;
};

// Asked about each hit that a ray would otherwise take; false: the ray goes on as if nothing were there. Called
// from the threads that trace, seldom twice for a hit. `ray` is in world space.
struct HitFilter {
  bool (*accepts)(const void* data, const kernel::Ray& ray, const Intersection& hit) = nullptr;
  const void* data = nullptr;
};

struct View {
  const WideNode* nodes = nullptr;
  const PairBlock* blocks = nullptr;
  const std::uint32_t* leafShapes = nullptr;  // of leaves; also triangles that change their shape
  const PlacedTree* placed = nullptr;         // instances of leaves
  const Tree* trees = nullptr;                // the first is the world's
  const std::uint32_t* unbounded = nullptr;   // shapes without bounds, which every ray tests
  std::uint32_t unboundedCount = 0;
  // Rays of these masks may take the short way: there are triangles alone, they see all of them, and every
  // hit counts
  std::uint32_t plainMask = 0;
  std::uint32_t treeMask = 0;  // of all objects that the world's tree holds, together

  // The caller's geometry
  const kernel::vec3* positions = nullptr;
  const kernel::Triangle* triangles = nullptr;
  const kernel::Mesh* meshes = nullptr;
  const kernel::Shape* shapes = nullptr;
  const kernel::Instance* instances = nullptr;
  const kernel::Object* objects = nullptr;     // none: everything is seen by every ray
  const kernel::MotionKey* motions = nullptr;  // none: nothing moves
  HitFilter filter;
};

}  // namespace snell::bvh
