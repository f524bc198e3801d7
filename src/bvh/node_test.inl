// SPDX-License-Identifier: Apache-2.0
//
// Part of traverse.inl: rays against the children's boxes of nodes, and where to go on.
//
// Box tests only need to be conservative: each ray carries, per axis, a bound of the error of its distances
// to planes (after Ize 2013, "Robust BVH ray traversal", but absolute, so that it costs nothing and allows
// fused multiply-adds).

namespace snell::bvh::SNELL_ISA {

// A ray prepared for nodes: the distance to a plane is plane · scale + offset, where planes are those of
// WideNode in the order near, far, and distances to far ones come out times −1.
struct NodeRay {
  HalfOrder order[3];
  Float16 scale[3];
  Float16 offset[3];
};

SIMD_FN NodeRay PrepareForNodes(Float4 o, Float4 direction, const Tree& tree) {
  // Directions of zero become tiny ones, so that no NaN arises
  const Float4 scale = Set4(1.0f) / Max(Abs(direction), Set4(1e-24f));
  const Float4 start = FlipSign(o * scale, direction);
  const Float4 error = (Abs(start) + Load4(tree.reach) * scale) * Set4(kernel::Gamma(8.0f));
  const Float8 offset = Join(Negate(start + error), start - error);
  NodeRay ray;
  OrderHalves(direction, ray.order);
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

}  // namespace snell::bvh::SNELL_ISA
