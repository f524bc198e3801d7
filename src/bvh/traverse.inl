// SPDX-License-Identifier: Apache-2.0
//
// The traversal, one source for all instruction sets: traverse_<set>.cpp includes the vector types and then
// this file, in a namespace of its own. No function of the standard library or other rooms may be compiled
// out of line here: the linker might choose this file's copy for processors that lack the instructions.

#include "bvh/instruction_set.h"
#include "bvh/view.h"
#include "kernel/motion.h"
#include "kernel/shape.h"
#include "kernel/transform.h"
#include "kernel/triangle.h"

namespace snell::bvh::SNELL_ISA {

using kernel::Hit;
using kernel::Ray;
using kernel::vec3;

// The first three lanes are a ray's origin and direction.
SIMD_FN Float4 OriginOf(const Ray& ray) { return Load4(&ray.o.x); }
SIMD_FN Float4 DirectionOf(const Ray& ray) { return Shuffle<1, 2, 3>(Load4(&ray.o.z)); }
SIMD_FN Ray RayOf(Float4 o, Float4 d) {
  float start[4], direction[4];
  Store4(start, o);
  Store4(direction, d);
  return {vec3(start[0], start[1], start[2]), vec3(direction[0], direction[1], direction[2]), 0};
}

}  // namespace snell::bvh::SNELL_ISA

#include "bvh/block_test.inl"
#include "bvh/node_test.inl"

namespace snell::bvh::SNELL_ISA {

// More than any tree needs: depth at most 80 (BuildBinaryTree), seven children waiting per level,
// and room for Append.
inline constexpr int StackSize = 80 * (Width - 1) + 1 + Width;

// The best hit so far. Order among equal t: smaller instance, then smaller primitive.
struct Best {
  const Ray& world;
  float t;
  std::uint32_t instance;
  std::uint32_t primitive;

  bool Accepts(float candidate, std::uint32_t candidateInstance,
               std::uint32_t candidatePrimitive) const {
    if (!(candidate > 0.0f && candidate <= t)) return false;
    if (candidate < t) return true;
    return candidateInstance < instance ||
           (candidateInstance == instance && candidatePrimitive < primitive);
  }
  void Take(float nearer, std::uint32_t itsInstance, std::uint32_t itsPrimitive) {
    t = nearer;
    instance = itsInstance;
    primitive = itsPrimitive;
  }
};

// Whether a ray of this mask sees an object.
SIMD_FN bool Sees(const View& view, std::uint32_t object, std::uint32_t mask) {
  return ((view.objects == nullptr ? ~0u : view.objects[object].mask) & mask) != 0;
}

// What is to be asked about a hit on a triangle before it counts, where not all hits count.
SIMD_CALL bool Counts(const View& view, const Intersection& hit, std::uint32_t mask,
                      const Ray& world) {
  if (hit.instance == None && view.meshes != nullptr &&
      !Sees(view, view.meshes[view.triangles[hit.primitive].mesh].object, mask))
    return false;
  return view.filter.accepts == nullptr || view.filter.accepts(view.filter.data, world, hit);
}

// Test a block. Returns true if something was hit.
template <bool AnyHit>
SIMD_FN bool IntersectTriangles(const View& view, ChildRef leaf, const Ray& ray,
                                const BlockRay& prepared, std::uint32_t instance, bool choosy,
                                std::uint32_t mask, Best& best) {
  const PairBlock& block = view.blocks[FirstOf(leaf)];
  Float8 distances;
  std::uint32_t certain;
  std::uint32_t lanes = IntersectBlock(block, prepared, best.t, distances, certain);
  if (lanes == 0) return false;
  if (AnyHit && !choosy && certain != 0) return true;
  alignas(32) float distance[2 * BlockWidth];
  Store8(distance, distances);
  bool found = false;
  do {
    const std::uint32_t lane = std::uint32_t(__builtin_ctz(lanes));
    lanes &= lanes - 1;
    const float t = distance[lane];
    const std::uint32_t triangle = TriangleOf(block.id[lane]);
    if (!best.Accepts(t, instance, triangle)) continue;
    if ((certain >> lane & 1) == 0 && !Confirm(block, lane, ray)) continue;
    if (choosy && !Counts(view, {t, triangle, instance}, mask, best.world)) continue;
    best.Take(t, instance, triangle);
    if (AnyHit) return true;
    found = true;
  } while (lanes != 0);
  return found;
}

// A ray in the space of an object that moves.
SIMD_CALL Ray RayToMover(const View& view, std::uint32_t object, const Ray& ray) {
  const kernel::Object& mover = view.objects[object];
  const kernel::MotionMoment moment = kernel::MomentOf(ray.time, mover.motionSteps);
  const kernel::MotionKey* key = view.motions + mover.motion + moment.step;
  const kernel::Transform place = kernel::PlaceBetween(key[0], key[1], moment.share);
  return kernel::ToLocalRay(place, ray.o, ray.d);
}

// Out of line, so that what stands still is as fast as without.
SIMD_CALL float IntersectMovingShape(const View& view, const kernel::Shape& shape, const Ray& ray) {
  const Ray local = RayToMover(view, shape.object, ray);
  return kernel::IntersectShape(shape, local.o, local.d);
}

template <bool AnyHit>
SIMD_FN bool IntersectShapes(const View& view, const std::uint32_t* items, std::uint32_t count,
                             const Ray& ray, std::uint32_t mask, Best& best) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t index = items[i];
    const kernel::Shape& shape = view.shapes[index];
    if (!Sees(view, shape.object, mask)) continue;
    const bool moves = view.motions != nullptr && view.objects[shape.object].motion != None;
    const float t = moves ? IntersectMovingShape(view, shape, ray)
                          : kernel::IntersectShape(shape, ray.o, ray.d);
    if (!best.Accepts(t, kernel::INSTANCE_SHAPE, index)) continue;
    if (view.filter.accepts != nullptr &&
        !view.filter.accepts(view.filter.data, ray, {t, index, kernel::INSTANCE_SHAPE}))
      continue;
    best.Take(t, kernel::INSTANCE_SHAPE, index);
    if (AnyHit) return true;
  }
  return false;
}

// Triangles of a mesh that changes its shape, as they are when the ray looks.
template <bool AnyHit>
SIMD_CALL bool IntersectDeforming(const View& view, ChildRef leaf, const Ray& ray,
                                  std::uint32_t instance, Best& best) {
  const std::uint32_t* items = view.leafShapes + FirstOf(leaf);
  const kernel::Mesh& mesh = view.meshes[view.triangles[items[0]].mesh];
  const kernel::MotionMoment moment = kernel::MomentOf(best.world.time, mesh.steps);
  const vec3* positions = view.positions + std::size_t(moment.step) * mesh.stride;
  const kernel::ShearedRay sheared = kernel::Shear(ray.o, ray.d);
  bool found = false;
  for (std::uint32_t i = 0; i < CountOf(leaf); ++i) {
    const kernel::Triangle& triangle = view.triangles[items[i]];
    const std::uint32_t vertices[3] = {triangle.v0, triangle.v1, triangle.v2};
    vec3 p[3];
    for (int k = 0; k < 3; ++k)
      p[k] = kernel::Lerp(moment.share, positions[vertices[k]],
                          positions[std::size_t(vertices[k]) + mesh.stride]);
    const float t = kernel::IntersectTriangle(sheared, p[0], p[1], p[2]).t;
    if (!best.Accepts(t, instance, items[i])) continue;
    if (view.filter.accepts != nullptr &&
        !view.filter.accepts(view.filter.data, best.world, {t, items[i], instance}))
      continue;
    best.Take(t, instance, items[i]);
    if (AnyHit) return true;
    found = true;
  }
  return found;
}

template <bool AnyHit>
SIMD_CALL bool IntersectInstances(const View& view, ChildRef leaf, const Ray& ray,
                                  std::uint32_t mask, Best& best);

// Walk one tree. `Plain`: it holds triangles that keep their shape alone, and every hit counts. `o` and `d` are the ray's.
template <bool AnyHit, bool Plain>
SIMD_FN bool Traverse(const View& view, const Tree& tree, const Ray& ray, Float4 o, Float4 d,
                      std::uint32_t instance, std::uint32_t mask, Best& best) {
  // Objects of instances were asked for their masks on the way in
  const bool isWorld = instance == None;
  const bool seesTriangles = Plain || !isWorld || (tree.anyMask & mask) != 0;
  const bool choosy =
      !Plain && ((isWorld && (tree.commonMask & mask) == 0) || view.filter.accepts != nullptr);
  const NodeRay nodeRay = PrepareForNodes(ray, o, d, tree);
  const BlockRay blockRay = PrepareForBlocks(ray, d);
  Float16 limits = Limits(best.t);
  using Entry = StackEntry<AnyHit>;
  Entry stack[StackSize];
  Entry* top = stack;
  ChildRef current = tree.root;
  for (;;) {
    // Go down to a leaf
    while (!IsLeaf(current)) {
      const WideNode& node = view.nodes[current];
      Float8 distances;
      const std::uint32_t hits = IntersectNode(node, nodeRay, limits, distances);
      if (hits == 0) break;
      current = GoOn(node, hits, distances, top);
    }

    if (IsLeaf(current)) {
      if (Plain || KindOf(current) == LeafKind::Triangles) {
        if (seesTriangles && IntersectTriangles<AnyHit>(view, current, ray, blockRay, instance,
                                                        choosy, mask, best)) {
          if (AnyHit) return true;
          limits = Limits(best.t);
        }
      } else {
        const bool hit = KindOf(current) == LeafKind::Shapes
                             ? IntersectShapes<AnyHit>(view, view.leafShapes + FirstOf(current),
                                                       CountOf(current), ray, mask, best)
                         : KindOf(current) == LeafKind::Deforming
                             ? IntersectDeforming<AnyHit>(view, current, ray, instance, best)
                             : IntersectInstances<AnyHit>(view, current, ray, mask, best);
        if (AnyHit && hit) return true;
        limits = Limits(best.t);
      }
    }

    // Take the next one that can still hold a nearer hit
    do {
      if (top == stack) return false;
      --top;
    } while (IsBeyond(*top, best.t));
    current = ChildRef(*top);
  }
}

// Out of line, so that the plain case keeps its registers.
template <bool AnyHit>
SIMD_CALL bool TraverseChoosily(const View& view, const Tree& tree, const Ray& ray,
                                std::uint32_t instance, std::uint32_t mask, Best& best) {
  return Traverse<AnyHit, false>(view, tree, ray, OriginOf(ray), DirectionOf(ray), instance, mask,
                                 best);
}

template <bool AnyHit>
SIMD_CALL bool IntersectInstances(const View& view, ChildRef leaf, const Ray& ray,
                                  std::uint32_t mask, Best& best) {
  for (std::uint32_t i = FirstOf(leaf); i < FirstOf(leaf) + CountOf(leaf); ++i) {
    const PlacedTree& placed = view.placed[i];
    if ((placed.mask & mask) == 0) continue;
    if (placed.mover != None) {
      const Ray local = RayToMover(view, placed.mover, ray);
      if (TraverseChoosily<AnyHit>(view, view.trees[placed.tree], local, placed.instance, mask,
                                   best))
        return true;
      continue;
    }
    // As kernel::ToLocalRay does
    const float* map = placed.map;
    const Float4 x = Load4(map), y = Load4(map + 3), z = Load4(map + 6);
    const vec3 from = ray.o - vec3(map[9], map[10], map[11]);
    const Float4 o = (x * Set4(from.x) + y * Set4(from.y)) + z * Set4(from.z);
    const Float4 d = (x * Set4(ray.d.x) + y * Set4(ray.d.y)) + z * Set4(ray.d.z);
    const Ray local = RayOf(o, d);
    const Tree& tree = view.trees[placed.tree];
    if (view.filter.accepts == nullptr && tree.deforms == 0
            ? Traverse<AnyHit, true>(view, tree, local, o, d, placed.instance, mask, best)
            : TraverseChoosily<AnyHit>(view, tree, local, placed.instance, mask, best))
      return true;
  }
  return false;
}

// The world, unless the short way will do.
template <bool AnyHit>
SIMD_CALL bool TraverseWorldChoosily(const View& view, const Ray& ray, std::uint32_t mask,
                                     Best& best) {
  if (IntersectShapes<AnyHit>(view, view.unbounded, view.unboundedCount, ray, mask, best))
    return true;
  return (view.treeMask & mask) != 0 &&
         TraverseChoosily<AnyHit>(view, view.trees[0], ray, None, mask, best);
}

static void Closest(const View& view, const Ray& ray, float tMax, std::uint32_t mask,
                    Intersection& found) {
  if ((view.plainMask & mask) != 0) {
    Best best{ray, tMax, None, None};
    Traverse<false, true>(view, view.trees[0], ray, OriginOf(ray), DirectionOf(ray), None, mask,
                          best);
    found = {best.t, best.primitive, None};
  } else {
    Best best{ray, tMax, None, None};
    TraverseWorldChoosily<false>(view, ray, mask, best);
    found = {best.t, best.primitive, best.instance};
  }
}

static bool Any(const View& view, const Ray& ray, float tMax, std::uint32_t mask) {
  if ((view.plainMask & mask) != 0) {
    Best best{ray, tMax, None, None};
    return Traverse<true, true>(view, view.trees[0], ray, OriginOf(ray), DirectionOf(ray), None,
                                mask, best);
  }
  Best best{ray, tMax, None, None};
  return TraverseWorldChoosily<true>(view, ray, mask, best);
}

}  // namespace snell::bvh::SNELL_ISA

#include "bvh/traverse_many.inl"

namespace snell::bvh::SNELL_ISA {

extern const Traversal traversal;
const Traversal traversal = {Closest, Any, ClosestMany, AnyMany};

}  // namespace snell::bvh::SNELL_ISA
