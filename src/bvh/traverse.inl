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
using kernel::vec3;

// More than any tree needs: depth at most 80 (BuildBinaryTree), seven children waiting per level.
inline constexpr int StackSize = 80 * (Width - 1) + 1;

// The best hit so far. Order among equal t: smaller instance, then smaller primitive.
struct Best {
  const Ray& world;
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
  void Take(float nearer, std::uint32_t itsInstance, std::uint32_t itsPrimitive) {
    t = nearer;
    instance = itsInstance;
    primitive = itsPrimitive;
  }
};

// A ray prepared for triangles: what kernel::Shear computes.
struct BlockRay {
  std::size_t kx;
  std::size_t ky;
  std::size_t kz;
  float speed;  // along kz
  float slack;  // how far a distance may be off by rounding
  float origin[4];
  float shear[4];  // the direction over its component kz, and that component's reciprocal
};

// A ray prepared for nodes: the distance to a plane is plane · scale + offset, where planes are those of
// WideNode in the order near, far, and distances to far ones come out times −1.
struct NodeRay {
  HalfOrder order[3];
  Float16 scale[3];
  Float16 offset[3];
};

// Without branches, which random directions would make unpredictable.
SIMD_FN BlockRay PrepareForBlocks(const Ray& from, const Tree& tree) {
  const vec3 a = kernel::Abs(from.d);
  const std::uint32_t yOverX = a.x > a.y ? 0u : 1u;
  const std::uint32_t isZ = kernel::Max(a.x, a.y) > a.z ? 0u : ~0u;
  const std::uint32_t kz = (yOverX & ~isZ) | (2u & isZ);
  // By axis, and by whether the direction along it is negative, which swaps the other two
  static constexpr std::uint8_t X[6] = {1, 2, 2, 0, 0, 1};
  static constexpr std::uint8_t Y[6] = {2, 1, 0, 2, 1, 0};
  const float direction[3] = {from.d.x, from.d.y, from.d.z};
  const float dz = direction[kz];
  const std::uint32_t row = 2 * kz + (kernel::floatBitsToUint(dz) >> 31);
  BlockRay ray;
  ray.kx = X[row];
  ray.ky = Y[row];
  ray.kz = kz;
  Store4(ray.origin, Set4(from.o.x, from.o.y, from.o.z, 0.0f));
  Store4(ray.shear, Set4(from.d.x, from.d.y, from.d.z, 1.0f) / Set4(dz));
  ray.speed = kernel::abs(dz);
  ray.slack = (tree.reach[kz] + kernel::abs(ray.origin[kz])) * kernel::abs(ray.shear[3]) *
              kernel::Gamma(16.0f);
  return ray;
}

SIMD_FN NodeRay PrepareForNodes(const Ray& from, const Tree& tree) {
  // Directions of zero become tiny ones, so that no NaN arises
  const Float4 direction = Set4(from.d.x, from.d.y, from.d.z, 0.0f);
  const Float4 scale = Set4(1.0f) / Max(Abs(direction), Set4(1e-18f));
  const Float4 start = FlipSign(Set4(from.o.x, from.o.y, from.o.z, 0.0f) * scale, direction);
  const Float4 error = (Abs(start) + Load4(tree.reach) * scale) * Set4(kernel::Gamma(8.0f));
  const Float8 offset = Join(Negate(start + error), start - error);
  NodeRay ray;
  ray.order[0] = OrderHalves<0>(direction);
  ray.order[1] = OrderHalves<1>(direction);
  ray.order[2] = OrderHalves<2>(direction);
  const Float8 scales = Join(scale, scale);
  ray.scale[0] = Spread<0>(scales);
  ray.scale[1] = Spread<1>(scales);
  ray.scale[2] = Spread<2>(scales);
  ray.offset[0] = Spread<0>(offset);
  ray.offset[1] = Spread<1>(offset);
  ray.offset[2] = Spread<2>(offset);
  return ray;
}

// Which children the ray meets, and at what distance. `limits`: eight times where the ray begins, and
// eight times where it ends, times −1.
SIMD_FN std::uint32_t IntersectNode(const WideNode& node, const NodeRay& ray, Float16 limits,
                                    Float8& distance) {
  const Float16 x = MulAdd(Load16(node.planes[0], ray.order[0]), ray.scale[0], ray.offset[0]);
  const Float16 y = MulAdd(Load16(node.planes[1], ray.order[1]), ray.scale[1], ray.offset[1]);
  const Float16 z = MulAdd(Load16(node.planes[2], ray.order[2]), ray.scale[2], ray.offset[2]);
  const Float16 all = Max(Max(x, y), Max(z, limits));
  distance = LowHalf(all);
  return MaskLessEqual(distance, Set8(0.0f) - HighHalf(all));
}

// What the test of a block tells of its eight triangles, those of the lanes' first triangles before those of
// the second ones. All but `candidates` is set only if there are some.
struct BlockTest {
  std::uint32_t
      candidates;  // all that the ray hits at 0 < t ≤ tMax, and a few more for rounding's sake
  std::uint32_t certain;  // those that it hits without doubt
  // By corner of p0 p1 p2 or p0 p2 p3: edge function of the edge that faces it, and its distance along the
  // ray's axis
  Float8 edge[3];
  Float8 z[3];
};

SIMD_FN void IntersectBlock(const PairBlock& block, const BlockRay& ray, float tMax,
                            BlockTest& test) {
  // Shear the corners
  const Float16 cx = Load16(block.corner[ray.kx]) - Set16(ray.origin[ray.kx]);
  const Float16 cy = Load16(block.corner[ray.ky]) - Set16(ray.origin[ray.ky]);
  const Float16 cz = Load16(block.corner[ray.kz]) - Set16(ray.origin[ray.kz]);
  const Float16 x = cx - Set16(ray.shear[ray.kx]) * cz;
  const Float16 y = cy - Set16(ray.shear[ray.ky]) * cz;
  const Float16 z = Set16(ray.shear[3]) * cz;

  // Edge functions of p0 p1, p1 p2, p2 p3, p3 p0, and of p2 p0
  const Float16 around = NextQuarters(x) * y - NextQuarters(y) * x;
  const Float4 diagonal = Quarter0(x) * Quarter2(y) - Quarter0(y) * Quarter2(x);
  const Float8 u = Quarters12(around);
  const Float8 v = Join(diagonal, Quarter3(around));
  const Float8 w = Join(Quarter0(around), Negate(diagonal));
  const Float8 least = Min(u, Min(v, w));
  const Float8 most = Max(u, Max(v, w));
  const Float8 zero = Set8(0.0f);
  const std::uint32_t inside = MaskLessEqual(zero, least) | MaskLessEqual(most, zero);

  // Compare distances, times the determinant so that nothing is divided
  const Float4 z0 = Quarter0(z), z2 = Quarter2(z);
  const Float8 za = Join(z0, z0), zb = Quarters12(z), zc = Join(z2, Quarter3(z));
  const Float8 det = (u + v) + w;
  const Float8 area = Abs(det);
  const Float8 distance = FlipSign((u * za + v * zb) + w * zc, det);
  const std::uint32_t outside = MaskLess(distance, area * Set8(-ray.slack)) |
                                MaskLess(area * Set8(tMax + ray.slack), distance);
  test.candidates = inside & ~outside;
  if (test.candidates == 0) return;
  test.edge[0] = u;
  test.edge[1] = v;
  test.edge[2] = w;
  test.z[0] = za;
  test.z[1] = zb;
  test.z[2] = zc;

  // Certain: no edge function is zero, the limits are not near, and the ray does not start on the plane, be
  // it that the hit is farther than the triangle's size or that the volume between the triangle and the
  // ray's origin exceeds the error that kernel::StartsOnPlane allows for: at most 24 Γ₆ m³ if no coordinate
  // differs from the origin's by more than m.
  const std::uint32_t strictlyInside = MaskLess(zero, least) | MaskLess(most, zero);
  const std::uint32_t withinLimits = MaskLess(area * Set8(ray.slack), distance) &
                                     MaskLess(distance, area * Set8(tMax - ray.slack));
  const Float4 sizes = Load4(block.size);
  const Float8 volume = distance * Set8(ray.speed);
  test.certain = test.candidates & strictlyInside & withinLimits;
  const std::uint32_t isFar = MaskLess(area * Join(sizes, sizes), volume);
  if ((test.certain & ~isFar) != 0) {
    const Float16 reach = Max(Abs(x), Abs(y)) + Abs(cz);
    const Float4 m4 =
        Max(Max(Quarter0(reach), Quarter1(reach)), Max(Quarter2(reach), Quarter3(reach)));
    const Float8 m = Join(m4, m4);
    test.certain &= isFar | MaskLess((m * m) * (m * Set8(24.0f * kernel::Gamma(8.0f))), volume);
  }
}

// Whether a triangle of a block is really hit at t, by the kernel's own test.
SIMD_COLD bool Confirm(const PairBlock& block, std::uint32_t lane, std::uint32_t turn,
                       const Ray& ray) {
  static constexpr std::uint8_t Corners[2][5] = {{0, 1, 2, 0, 1}, {0, 2, 3, 0, 2}};
  vec3 v[3];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t place =
        Corners[lane / BlockWidth][turn + i] * BlockWidth + lane % BlockWidth;
    v[i] = vec3(block.corner[0][place], block.corner[1][place], block.corner[2][place]);
  }
  return kernel::IntersectTriangle(kernel::Shear(ray.o, ray.d), v[0], v[1], v[2]).t > 0.0f;
}

// The t of a candidate lane, or a number ≤ 0 if it is no hit at 0 < t ≤ tMax. `turn`: where the triangle's
// own first vertex is among its corners; the order of operations follows its own order.
SIMD_FN float CandidateT(const PairBlock& block, std::uint32_t lane, std::uint32_t turn,
                         const BlockTest& test, const Ray& ray, float tMax) {
  float u = Lane(test.edge[0], lane), v = Lane(test.edge[1], lane), w = Lane(test.edge[2], lane);
  float a = Lane(test.z[0], lane), b = Lane(test.z[1], lane), c = Lane(test.z[2], lane);
  while (turn > 0) {
    const float u0 = u, a0 = a;
    u = v, v = w, w = u0;
    a = b, b = c, c = a0;
    --turn;
  }
  const float det = (u + v) + w;
  const float t = ((u * a + v * b) + w * c) / det;
  if ((test.certain >> lane & 1) != 0) return t;
  if (!(t > 0.0f && t <= tMax) || det == 0.0f || block.id[lane] == None) return -1.0f;
  return Confirm(block, lane, TurnOf(block.id[lane]), ray) ? t : -1.0f;
}

// Whether a ray of this mask sees an object.
SIMD_FN bool Sees(const View& view, std::uint32_t object, std::uint32_t mask) {
  return view.objects == nullptr || (view.objects[object].mask & mask) != 0;
}

// What is to be asked about a hit on a triangle before it counts, where not all hits count.
SIMD_CALL bool Counts(const View& view, const Intersection& hit, std::uint32_t mask,
                      const Ray& world) {
  if (hit.instance == None && view.meshes != nullptr &&
      !Sees(view, view.meshes[view.triangles[hit.primitive].mesh].object, mask))
    return false;
  return view.filter.accepts == nullptr || view.filter.accepts(view.filter.data, world, hit);
}

// Test a block. Returns true if `AnyHit` and something was hit.
template <bool AnyHit>
SIMD_FN bool IntersectTriangles(const View& view, ChildRef leaf, const Ray& ray,
                                const BlockRay& prepared, std::uint32_t instance, bool choosy,
                                std::uint32_t mask, Best& best) {
  const PairBlock& block = view.blocks[FirstOf(leaf)];
  BlockTest test;
  IntersectBlock(block, prepared, best.t, test);
  if (test.candidates == 0) return false;
  if (AnyHit && !choosy && test.certain != 0) return true;
  std::uint32_t lanes = test.candidates;
  while (lanes != 0) {
    const std::uint32_t lane = std::uint32_t(__builtin_ctz(lanes));
    lanes &= lanes - 1;
    const std::uint32_t id = block.id[lane];
    const float t = CandidateT(block, lane, TurnOf(id), test, ray, best.t);
    const std::uint32_t triangle = TriangleOf(id);
    if (!best.Accepts(t, instance, triangle)) continue;
    if (choosy && !Counts(view, {t, triangle, instance}, mask, best.world)) continue;
    best.Take(t, instance, triangle);
    if (AnyHit) return true;
  }
  return false;
}

template <bool AnyHit>
SIMD_CALL bool IntersectShapes(const View& view, const std::uint32_t* items, std::uint32_t count,
                               const Ray& ray, std::uint32_t mask, Best& best) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t index = items[i];
    const kernel::Shape& shape = view.shapes[index];
    if (!Sees(view, shape.object, mask)) continue;
    const float t = kernel::IntersectShape(shape, ray.o, ray.d);
    if (!best.Accepts(t, kernel::INSTANCE_SHAPE, index)) continue;
    if (view.filter.accepts != nullptr &&
        !view.filter.accepts(view.filter.data, ray, {t, index, kernel::INSTANCE_SHAPE}))
      continue;
    best.Take(t, kernel::INSTANCE_SHAPE, index);
    if (AnyHit) return true;
  }
  return false;
}

// What waits on the stack: the bits of the distance, which order as the distances do because those are not
// negative, above the child.
using Waiting = std::uint64_t;
SIMD_FN Waiting Wait(float distance, ChildRef ref) {
  return Waiting(kernel::floatBitsToUint(distance)) << 32 | ref;
}

// Choose where to go on among `hits`, at least two; the others wait, nearest on top.
SIMD_FN ChildRef Descend(const WideNode& node, std::uint32_t hits, Float8 distances,
                         Waiting*& top) {
  alignas(32) float distance[Width];
  Store8(distance, distances);
  const auto next = [&] {
    const std::uint32_t i = std::uint32_t(__builtin_ctz(hits));
    hits &= hits - 1;
    return Wait(distance[i], node.child[i]);
  };
  const Waiting first = next(), second = next();
  Waiting nearest = first < second ? first : second;
  Waiting* const base = top;
  *top++ = first < second ? second : first;
  while (hits != 0) {
    const Waiting other = next();
    Waiting entry = other < nearest ? nearest : other;
    nearest = other < nearest ? other : nearest;
    Waiting* place = top++;
    while (place > base && place[-1] < entry) {
      *place = place[-1];
      --place;
    }
    *place = entry;
  }
  return ChildRef(nearest);
}

// For any hit the builder's order of the children counts, not the distance.
SIMD_FN ChildRef DescendInOrder(const WideNode& node, std::uint32_t hits, Waiting*& top) {
  for (;;) {
    const std::uint32_t last = 31u - std::uint32_t(__builtin_clz(hits));
    hits ^= 1u << last;
    if (hits == 0) return node.child[last];
    *top++ = node.child[last];
  }
}

template <bool AnyHit>
SIMD_CALL bool IntersectInstances(const View& view, ChildRef leaf, const Ray& ray,
                                  std::uint32_t mask, Best& best);

// Walk one tree. `World`: the tree may hold shapes and instances.
template <bool AnyHit, bool World>
SIMD_FN bool Traverse(const View& view, const Tree& tree, const Ray& ray, std::uint32_t instance,
                      std::uint32_t mask, Best& best) {
  if (tree.root == None) return false;
  const bool seesTriangles = !World || (tree.anyMask & mask) != 0;
  const bool choosy = (World && (tree.commonMask & mask) == 0) || view.filter.accepts != nullptr;
  const NodeRay nodeRay = PrepareForNodes(ray, tree);
  const BlockRay blockRay = PrepareForBlocks(ray, tree);
  Float16 limits = Join(Set8(0.0f), Set8(-best.t));
  Waiting stack[StackSize];
  Waiting* top = stack;
  ChildRef current = tree.root;
  for (;;) {
    // Go down to a leaf
    while (!IsLeaf(current)) {
      const WideNode& node = view.nodes[current];
      Float8 distances;
      const std::uint32_t hits = IntersectNode(node, nodeRay, limits, distances);
      if (hits == 0) break;
      if ((hits & (hits - 1)) == 0) {
        current = node.child[__builtin_ctz(hits)];
      } else {
        current = AnyHit ? DescendInOrder(node, hits, top) : Descend(node, hits, distances, top);
      }
    }

    if (IsLeaf(current)) {
      if (!World || KindOf(current) == LeafKind::Triangles) {
        if (seesTriangles &&
            IntersectTriangles<AnyHit>(view, current, ray, blockRay, instance, choosy, mask, best))
          return true;
      } else if (KindOf(current) == LeafKind::Shapes) {
        if (IntersectShapes<AnyHit>(view, view.items + FirstOf(current), CountOf(current), ray,
                                    mask, best))
          return true;
      } else if (IntersectInstances<AnyHit>(view, current, ray, mask, best)) {
        return true;
      }
      if (!AnyHit) limits = Join(Set8(0.0f), Set8(-best.t));
    }

    // Take the next one that can still hold a nearer hit
    do {
      if (top == stack) return false;
      --top;
    } while (!AnyHit && *top >> 32 > kernel::floatBitsToUint(best.t));
    current = ChildRef(*top);
  }
}

template <bool AnyHit>
SIMD_CALL bool IntersectInstances(const View& view, ChildRef leaf, const Ray& ray,
                                  std::uint32_t mask, Best& best) {
  for (std::uint32_t i = 0; i < CountOf(leaf); ++i) {
    const std::uint32_t index = view.items[FirstOf(leaf) + i];
    const kernel::Instance& placed = view.instances[index];
    if (!Sees(view, placed.object, mask)) continue;
    const Ray local = kernel::ToLocalRay(placed.toWorld, ray.o, ray.d);
    if (Traverse<AnyHit, false>(view, view.trees[placed.root], local, index, mask, best))
      return true;
  }
  return false;
}

static Intersection Closest(const View& view, const Ray& ray, float tMax, std::uint32_t mask) {
  Best best{ray, tMax, None, None};
  if (view.unboundedCount > 0)
    IntersectShapes<false>(view, view.unbounded, view.unboundedCount, ray, mask, best);
  if ((view.treeMask & mask) != 0)
    Traverse<false, true>(view, view.trees[0], ray, None, mask, best);
  return {best.t, best.primitive, best.instance};
}

static bool Any(const View& view, const Ray& ray, float tMax, std::uint32_t mask) {
  Best best{ray, tMax, None, None};
  if (view.unboundedCount > 0 &&
      IntersectShapes<true>(view, view.unbounded, view.unboundedCount, ray, mask, best))
    return true;
  return (view.treeMask & mask) != 0 &&
         Traverse<true, true>(view, view.trees[0], ray, None, mask, best);
}

extern const Traversal traversal;
const Traversal traversal = {Closest, Any};

}  // namespace snell::bvh::SNELL_ISA
