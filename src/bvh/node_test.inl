// SPDX-License-Identifier: Apache-2.0
//
// Part of traverse.inl: rays against the children's boxes of nodes, and where to go on.
//
// Box tests only need to be conservative: each ray carries, per axis, a bound of the error of its distances
// to planes (after Ize 2013, "Robust BVH ray traversal", but absolute, so that it costs nothing and allows
// fused multiply-adds).

#include <type_traits>

namespace snell::bvh::SNELL_ISA {

// A ray prepared for nodes: the distance to a plane is plane · scale + offset, where planes are those of
// WideNode in the order near, far, and distances to far ones come out times −1.
struct NodeRay {
  HalfOrder order[3];
  Float16 scale[3];
  Float16 offset[3];
};

SIMD_FN NodeRay PrepareForNodes(const Ray& r, Float4 o, Float4 d, const Tree& tree) {
  // Directions of zero become tiny ones, so that no NaN arises
  const Float4 scale = Set4(1.0f) / Max(Abs(d), Set4(1e-24f));
  const Float4 start = FlipSign(o * scale, d);
  const Float4 error = MulAdd(Abs(o), Set4(kernel::Gamma(8.0f)), Load4(tree.slack)) * scale;
  const Float8 offset = Join(Negate(start + error), start - error);
  NodeRay ray;
  OrderHalves(&r.d.x, ray.order);
  const Float8 scales = Join(scale, scale);
  ray.scale[0] = Spread<0>(scales);
  ray.scale[1] = Spread<1>(scales);
  ray.scale[2] = Spread<2>(scales);
  ray.offset[0] = Spread<0>(offset);
  ray.offset[1] = Spread<1>(offset);
  ray.offset[2] = Spread<2>(offset);
  return ray;
}

// Eight times where a ray begins, and eight times where it ends, times −1.
SIMD_FN Float16 Limits(float tMax) { return Join(Set8(0.0f), Set8(-tMax)); }

// Which children the ray meets within its limits, and at what distance.
SIMD_FN std::uint32_t IntersectNode(const WideNode& node, const NodeRay& ray, Float16 limits,
                                    Float8& distance) {
  const Float16 x = MulAdd(Load16(node.planes[0], ray.order[0]), ray.scale[0], ray.offset[0]);
  const Float16 y = MulAdd(Load16(node.planes[1], ray.order[1]), ray.scale[1], ray.offset[1]);
  const Float16 z = MulAdd(Load16(node.planes[2], ray.order[2]), ray.scale[2], ray.offset[2]);
  const Float16 all = Max(Max(x, y), Max(z, limits));
  distance = LowHalf(all);
  return MaskLessEqual(distance, Set8(0.0f) - HighHalf(all));
}

// What waits on the stack: the bits of the distance, which order as the distances do because those are not
// negative, above the child.
using Waiting = std::uint64_t;
SIMD_FN Waiting Wait(float distance, ChildRef ref) {
  return Waiting(kernel::floatBitsToUint(distance)) << 32 | ref;
}
SIMD_FN bool IsBeyond(Waiting entry, float t) { return entry >> 32 > kernel::floatBitsToUint(t); }
// For any hit distances do not matter.
SIMD_FN bool IsBeyond(ChildRef, float) { return false; }
template <bool AnyHit>
using StackEntry = std::conditional_t<AnyHit, ChildRef, Waiting>;

#ifndef SNELL_SIMD_NATIVE16
// Append the lanes `lanes` of `from` to what waits; the end afterwards. May write eight elements.
SIMD_FN ChildRef* Append(ChildRef* to, const ChildRef* from, std::uint32_t lanes) {
  for (; lanes != 0; lanes &= lanes - 1) *to++ = from[__builtin_ctz(lanes)];
  return to;
}
SIMD_FN Waiting* Append(Waiting* to, Float8 distances, const ChildRef* from, std::uint32_t lanes) {
  alignas(32) float distance[Width];
  Store8(distance, distances);
  for (; lanes != 0; lanes &= lanes - 1) {
    const std::uint32_t i = std::uint32_t(__builtin_ctz(lanes));
    *to++ = Wait(distance[i], from[i]);
  }
  return to;
}
#endif

// Choose where to go on among `hits`, at least one; the others wait, nearest on top.
SIMD_FN ChildRef GoOn(const WideNode& node, std::uint32_t hits, Float8 distances, Waiting*& top) {
  if ((hits & (hits - 1)) == 0) return node.child[__builtin_ctz(hits)];
  Waiting* const base = top;
  top = Append(top, distances, node.child, hits) - 1;
  const Waiting first = base[0], second = base[1];
  Waiting nearest = first < second ? first : second;
  base[0] = first < second ? second : first;
  for (Waiting* next = base + 2; next <= top; ++next) {
    const Waiting other = *next;
    const Waiting entry = other < nearest ? nearest : other;
    nearest = other < nearest ? other : nearest;
    Waiting* place = next - 1;
    while (place > base && place[-1] < entry) {
      *place = place[-1];
      --place;
    }
    *place = entry;
  }
  return ChildRef(nearest);
}

// For any hit the builder's order of the children counts, not the distance.
SIMD_FN ChildRef GoOn(const WideNode& node, std::uint32_t hits, Float8, ChildRef*& top) {
  if ((hits & (hits - 1)) == 0) return node.child[__builtin_ctz(hits)];
  top = Append(top, node.child, hits) - 1;
  return node.child[31 - __builtin_clz(hits)];
}

}  // namespace snell::bvh::SNELL_ISA
