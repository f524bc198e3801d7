// SPDX-License-Identifier: Apache-2.0
//
// The traversal, one source for all instruction sets: traverse_<set>.cpp includes the vector types and then
// this file, in a namespace of its own. No function of the standard library or other rooms may be compiled
// out of line here: the linker might choose this file's copy for processors that lack the instructions.
//
// Box tests only need to be conservative: each ray carries, per axis, a bound of the error of its distances
// to planes (after Ize 2013, "Robust BVH ray traversal", but absolute, so that it costs nothing and allows
// fused multiply-adds). Triangle tests do the operations of kernel/triangle.h lane by lane and leave the
// rare doubtful cases to that function, so every instruction set finds the same t to the bit.

#include "bvh/instruction_set.h"
#include "bvh/view.h"
#include "kernel/shape.h"
#include "kernel/transform.h"
#include "kernel/triangle.h"

namespace snell::bvh::SNELL_ISA {

using kernel::Hit;
using kernel::Ray;
using kernel::ShearedRay;
using kernel::vec3;

// More than any tree needs: depth at most 80 (BuildBinaryTree), seven children waiting per level.
inline constexpr int StackSize = 80 * (Width - 1) + 1;

// The best hit so far. Order among equal t: smaller instance, then smaller primitive.
struct Best {
  float t;
  std::uint32_t instance;
  std::uint32_t primitive;

  bool Accepts(float candidate, std::uint32_t candidateInstance,
               std::uint32_t candidatePrimitive) const {
    if (!(candidate > 0.0f) || candidate > t) return false;
    if (candidate < t) return true;
    return candidateInstance < instance ||
           (candidateInstance == instance && candidatePrimitive < primitive);
  }
};

// A ray prepared for one tree.
struct TreeRay {
  ShearedRay sheared;
  float reciprocal[3];
  float entry[3];  // what to subtract from plane · reciprocal for the distance to near planes …
  float exit[3];   // … and to far planes
  int near[3];     // rows of WideNode::bounds with the near planes
  int far[3];
};

SIMD_FN TreeRay Prepare(vec3 o, vec3 d, const Tree& tree, bool triangles) {
  TreeRay ray;
  if (triangles) ray.sheared = kernel::Shear(o, d);
  for (int axis = 0; axis < 3; ++axis) {
    // Directions of zero become tiny ones, so that no NaN arises
    const float component =
        d[axis] < 0.0f ? kernel::Min(d[axis], -1e-18f) : kernel::Max(d[axis], 1e-18f);
    const float r = 1.0f / component;
    const float start = o[axis] * r;
    const float error =
        kernel::Gamma(8.0f) * (kernel::abs(start) + tree.reach[axis] * kernel::abs(r));
    ray.reciprocal[axis] = r;
    ray.entry[axis] = start + error;
    ray.exit[axis] = start - error;
    ray.near[axis] = r < 0.0f ? 3 + axis : axis;
    ray.far[axis] = r < 0.0f ? axis : 3 + axis;
  }
  return ray;
}

// Which children the ray meets before `tMax`, and at what distance.
SIMD_FN std::uint32_t IntersectNode(const WideNode& node, const TreeRay& ray, float tMax,
                                    Float8& distance) {
  Float8 enter = Set8(0.0f);
  Float8 leave = Set8(tMax);
#pragma GCC unroll 3
  for (int axis = 0; axis < 3; ++axis) {
    const Float8 r = Set8(ray.reciprocal[axis]);
    enter = Max(MulSub(Load8(node.bounds[ray.near[axis]]), r, Set8(ray.entry[axis])), enter);
    leave = Min(MulSub(Load8(node.bounds[ray.far[axis]]), r, Set8(ray.exit[axis])), leave);
  }
  distance = enter;
  return MaskLessEqual(enter, leave);
}

// Lanes of a block that the ray may hit at 0 < t ≤ tMax; `doubtful` ones must be asked again.
struct BlockHits {
  std::uint32_t lanes;
  std::uint32_t doubtful;
  alignas(16) float t[BlockWidth];
};

SIMD_FN void IntersectBlock(const TriangleBlock& block, const ShearedRay& ray, float tMax,
                            BlockHits& hits) {
  const std::uint32_t kx = ray.kx, ky = ray.ky, kz = ray.kz;
  const Float4 ox = Set4(ray.o[kx]), oy = Set4(ray.o[ky]), oz = Set4(ray.o[kz]);
  const Float4 sx = Set4(ray.sx), sy = Set4(ray.sy), sz = Set4(ray.sz);
  const Float4 zero = Set4(0.0f);

  // Shear the vertices
  const Float4 az = Load4(block.vertex[kz]) - oz;
  const Float4 bz = Load4(block.vertex[3 + kz]) - oz;
  const Float4 cz = Load4(block.vertex[6 + kz]) - oz;
  const Float4 ax = (Load4(block.vertex[kx]) - ox) - sx * az;
  const Float4 ay = (Load4(block.vertex[ky]) - oy) - sy * az;
  const Float4 bx = (Load4(block.vertex[3 + kx]) - ox) - sx * bz;
  const Float4 by = (Load4(block.vertex[3 + ky]) - oy) - sy * bz;
  const Float4 cx = (Load4(block.vertex[6 + kx]) - ox) - sx * cz;
  const Float4 cy = (Load4(block.vertex[6 + ky]) - oy) - sy * cz;

  // Edge functions
  const Float4 u = cx * by - cy * bx;
  const Float4 v = ax * cy - ay * cx;
  const Float4 w = bx * ay - by * ax;
  const Float4 negative = (u < zero) | (v < zero) | (w < zero);
  const Float4 positive = (zero < u) | (zero < v) | (zero < w);
  const Float4 det = (u + v) + w;
  Float4 candidates = AndNot(negative & positive, det != zero);
  hits.lanes = Mask(candidates);
  if (hits.lanes == 0) return;

  const Float4 t = ((u * (sz * az) + v * (sz * bz)) + w * (sz * cz)) / det;
  candidates = candidates & (zero < t) & (t <= Set4(tMax));
  hits.lanes = Mask(candidates);
  if (hits.lanes == 0) return;
  Store4(hits.t, t);

  // Doubtful: an edge function of zero, or a hit nearer than the triangle's size
  const Float4 onEdge = (u == zero) | (v == zero) | (w == zero);
  Float4 size = zero;
  for (int axis = 0; axis < 3; ++axis) {
    const Float4 a = Load4(block.vertex[axis]);
    size = size + (Abs(Load4(block.vertex[3 + axis]) - a) + Abs(Load4(block.vertex[6 + axis]) - a));
  }
  const float speed = kernel::abs(ray.d[kz]);
  // The slack makes up for another order of summation than in StartsOnPlane
  const Float4 close = t * Set4(speed) <= size * Set4(1.0f + 1e-5f);
  hits.doubtful = Mask(candidates & (onEdge | close));
}

SIMD_FN float ExactT(const TriangleBlock& block, std::uint32_t lane, const ShearedRay& ray) {
  const vec3 v0(block.vertex[0][lane], block.vertex[1][lane], block.vertex[2][lane]);
  const vec3 v1(block.vertex[3][lane], block.vertex[4][lane], block.vertex[5][lane]);
  const vec3 v2(block.vertex[6][lane], block.vertex[7][lane], block.vertex[8][lane]);
  return kernel::IntersectTriangle(ray, v0, v1, v2).t;
}

// The objects' mask of a world triangle, where the tree has no common one.
SIMD_FN std::uint32_t TriangleMask(const View& view, std::uint32_t triangle) {
  return view.objects[view.meshes[view.triangles[triangle].mesh].object].mask;
}

// Test the blocks of a leaf. Returns true if `AnyHit` and something was hit.
template <bool AnyHit>
SIMD_FN bool IntersectTriangles(const View& view, const Tree& tree, ChildRef leaf,
                                const ShearedRay& ray, std::uint32_t instance, std::uint32_t mask,
                                Best& best) {
  const std::uint32_t first = FirstOf(leaf);
  const std::uint32_t last = first + CountOf(leaf);
  for (std::uint32_t b = first; b < last; ++b) {
    const TriangleBlock& block = view.blocks[b];
    BlockHits hits;
    IntersectBlock(block, ray, best.t, hits);
    while (hits.lanes != 0) {
      const std::uint32_t lane = std::uint32_t(__builtin_ctz(hits.lanes));
      hits.lanes &= hits.lanes - 1;
      const bool doubtful = (hits.doubtful >> lane & 1u) != 0;
      const float t = doubtful ? ExactT(block, lane, ray) : hits.t[lane];
      const std::uint32_t id = block.id[lane];
      if (!best.Accepts(t, instance, id)) continue;
      if (tree.triangleMask == MixedMask && (TriangleMask(view, id) & mask) == 0) continue;
      best = {t, instance, id};
      if (AnyHit) return true;
    }
  }
  return false;
}

template <bool AnyHit>
SIMD_FN bool IntersectShapes(const View& view, const std::uint32_t* items, std::uint32_t count,
                             const Ray& ray, std::uint32_t mask, Best& best) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t index = items[i];
    const kernel::Shape& shape = view.shapes[index];
    if ((view.objects[shape.object].mask & mask) == 0) continue;
    const float t = kernel::IntersectShape(shape, ray.o, ray.d);
    if (!best.Accepts(t, kernel::INSTANCE_SHAPE, index)) continue;
    best = {t, kernel::INSTANCE_SHAPE, index};
    if (AnyHit) return true;
  }
  return false;
}

struct StackEntry {
  float distance;
  ChildRef ref;
};

// Walk one tree, nearest children first. `World`: the tree may hold shapes and instances.
template <bool AnyHit, bool World>
static bool Traverse(const View& view, const Tree& tree, const Ray& ray, std::uint32_t instance,
                     std::uint32_t mask, Best& best) {
  if (tree.root == None) return false;
  const bool seesTriangles =
      !World || tree.triangleMask == MixedMask || (tree.triangleMask & mask) != 0;
  const TreeRay prepared = Prepare(ray.o, ray.d, tree, seesTriangles);
  StackEntry stack[StackSize];
  int size = 0;
  ChildRef current = tree.root;
  for (;;) {
    // Go down to a leaf
    while (!IsLeaf(current)) {
      const WideNode& node = view.nodes[current];
      Float8 distances;
      std::uint32_t hits = IntersectNode(node, prepared, best.t, distances);
      if (hits == 0) break;
      const std::uint32_t only = std::uint32_t(__builtin_ctz(hits));
      hits &= hits - 1;
      if (hits == 0) {
        current = node.child[only];
        continue;
      }

      // Keep the nearest child, stack the others in order of decreasing distance
      alignas(32) float distance[Width];
      Store8(distance, distances);
      StackEntry nearest{distance[only], node.child[only]};
      const int base = size;
      while (hits != 0) {
        const std::uint32_t i = std::uint32_t(__builtin_ctz(hits));
        hits &= hits - 1;
        StackEntry entry{distance[i], node.child[i]};
        if (entry.distance < nearest.distance) {
          const StackEntry other = nearest;
          nearest = entry;
          entry = other;
        }
        int place = size++;
        if (!AnyHit) {
          while (place > base && stack[place - 1].distance < entry.distance) {
            stack[place] = stack[place - 1];
            --place;
          }
        }
        stack[place] = entry;
      }
      current = nearest.ref;
    }

    if (IsLeaf(current)) {
      if (World && KindOf(current) == LeafKind::Shapes) {
        if (IntersectShapes<AnyHit>(view, view.items + FirstOf(current), CountOf(current), ray,
                                    mask, best))
          return true;
      } else if (World && KindOf(current) == LeafKind::Instances) {
        for (std::uint32_t i = 0; i < CountOf(current); ++i) {
          const std::uint32_t index = view.items[FirstOf(current) + i];
          const kernel::Instance& placed = view.instances[index];
          if ((view.objects[placed.object].mask & mask) == 0) continue;
          const Ray local = kernel::ToLocalRay(placed.toWorld, ray.o, ray.d);
          if (Traverse<AnyHit, false>(view, view.trees[placed.root], local, index, mask, best))
            return true;
        }
      } else if (seesTriangles) {
        if (IntersectTriangles<AnyHit>(view, tree, current, prepared.sheared, instance, mask, best))
          return true;
      }
    }

    // Take the next entry that can still hold a nearer hit
    do {
      if (size == 0) return false;
      --size;
    } while (stack[size].distance > best.t);
    current = stack[size].ref;
  }
}

static Hit Closest(const View& view, const Ray& ray, float tMax, std::uint32_t mask) {
  Best best{tMax, None, None};
  IntersectShapes<false>(view, view.unbounded, view.unboundedCount, ray, mask, best);
  if ((view.treeMask & mask) != 0) Traverse<false, true>(view, view.trees[0], ray, None, mask, best);
  return {best.primitive, best.instance};
}

static bool Any(const View& view, const Ray& ray, float tMax, std::uint32_t mask) {
  Best best{tMax, None, None};
  if (IntersectShapes<true>(view, view.unbounded, view.unboundedCount, ray, mask, best)) return true;
  return (view.treeMask & mask) != 0 &&
         Traverse<true, true>(view, view.trees[0], ray, None, mask, best);
}

extern const Traversal traversal;
const Traversal traversal = {Closest, Any};

}  // namespace snell::bvh::SNELL_ISA
