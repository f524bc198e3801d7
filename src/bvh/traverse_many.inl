// SPDX-License-Identifier: Apache-2.0
//
// Part of traverse.inl: many rays at once. Several rays are under way in turn, each a step at a time, and
// what the next step of one reads is fetched while the others make theirs: where the tree is larger than the
// caches, rays wait for memory together.

namespace snell::bvh::SNELL_ISA {

// How many rays are under way: more than memory can serve at once do not help.
inline constexpr int RaysUnderWay = 8;

// A ray under way in a plain world.
template <bool AnyHit>
struct Walk {
  using Entry = StackEntry<AnyHit>;
  NodeRay nodeRay;
  BlockRay blockRay;
  Float16 limits;
  Ray ray;
  float t;
  std::uint32_t primitive;
  std::size_t query;
  ChildRef current;
  Entry* top;
  Entry stack[StackSize];
};

template <bool AnyHit>
SIMD_FN void Begin(const View& view, const Query& query, std::size_t index, Walk<AnyHit>& walk) {
  const Tree& tree = view.trees[0];
  const Float4 o = OriginOf(query.ray), d = DirectionOf(query.ray);
  walk.nodeRay = PrepareForNodes(query.ray, o, d, tree);
  walk.blockRay = PrepareForBlocks(query.ray, d);
  walk.limits = Limits(query.tMax);
  walk.ray = query.ray;
  walk.t = query.tMax;
  walk.primitive = None;
  walk.query = index;
  walk.current = tree.root;
  walk.top = walk.stack;
}

SIMD_FN void Fetch(const View& view, ChildRef ref) {
  const char* place = IsLeaf(ref) ? reinterpret_cast<const char*>(view.blocks + FirstOf(ref))
                                  : reinterpret_cast<const char*>(view.nodes + ref);
  for (int line = 0; line < 4; ++line) __builtin_prefetch(place + 64 * line);
}

// One node or block. Returns false if the ray has come to its end.
template <bool AnyHit>
SIMD_FN bool Step(const View& view, std::uint32_t mask, Walk<AnyHit>& walk) {
  bool descends = false;
  if (IsLeaf(walk.current)) {
    Best best{walk.ray, walk.t, None, walk.primitive};
    const bool hit = IntersectTriangles<AnyHit>(view, walk.current, walk.ray, walk.blockRay, None,
                                                false, mask, best);
    if (AnyHit && hit) {
      walk.primitive = 0;
      return false;
    }
    walk.t = best.t;
    walk.primitive = best.primitive;
    walk.limits = Limits(best.t);
  } else {
    const WideNode& node = view.nodes[walk.current];
    Float8 distances;
    const std::uint32_t hits = IntersectNode(node, walk.nodeRay, walk.limits, distances);
    if (hits != 0) {
      descends = true;
      walk.current = GoOn(node, hits, distances, walk.top);
    }
  }
  if (!descends) {
    do {
      if (walk.top == walk.stack) return false;
      --walk.top;
    } while (IsBeyond(*walk.top, walk.t));
    walk.current = ChildRef(*walk.top);
  }
  Fetch(view, walk.current);
  return true;
}

// `finish(walk)` takes each ray that has come to its end.
template <bool AnyHit, class Finish>
SIMD_FN void WalkMany(const View& view, const Query* queries, std::size_t count, std::uint32_t mask,
                      const Finish& finish) {
  Walk<AnyHit> walks[RaysUnderWay];
  std::size_t next = 0;
  int active = 0;
  while (active < RaysUnderWay && next < count) {
    Begin(view, queries[next], next, walks[active++]);
    ++next;
  }
  while (active > 0) {
    for (int i = 0; i < active; ++i) {
      if (Step<AnyHit>(view, mask, walks[i])) continue;
      finish(walks[i]);
      if (next < count) {
        Begin(view, queries[next], next, walks[i]);
        ++next;
      } else {
        // The last one takes this place; copying it is rare
        --active;
        if (i < active) {
          const std::ptrdiff_t waiting = walks[active].top - walks[active].stack;
          walks[i] = walks[active];
          walks[i].top = walks[i].stack + waiting;
          --i;
        }
      }
    }
  }
}

// Only plain trees are walked together; other rays go one after another.
SIMD_FN bool MayWalk(const View& view, std::uint32_t mask) { return (view.plainMask & mask) != 0; }

static void ClosestMany(const View& view, const Query* queries, std::size_t count,
                        std::uint32_t mask, Intersection* found) {
  if (!MayWalk(view, mask)) {
    for (std::size_t i = 0; i < count; ++i)
      Closest(view, queries[i].ray, queries[i].tMax, mask, found[i]);
    return;
  }
  WalkMany<false>(view, queries, count, mask, [&](const Walk<false>& walk) {
    found[walk.query] = {walk.t, walk.primitive, None};
  });
}

static void AnyMany(const View& view, const Query* queries, std::size_t count, std::uint32_t mask,
                    bool* hit) {
  if (!MayWalk(view, mask)) {
    for (std::size_t i = 0; i < count; ++i)
      hit[i] = Any(view, queries[i].ray, queries[i].tMax, mask);
    return;
  }
  WalkMany<true>(view, queries, count, mask,
                 [&](const Walk<true>& walk) { hit[walk.query] = walk.primitive != None; });
}

}  // namespace snell::bvh::SNELL_ISA
