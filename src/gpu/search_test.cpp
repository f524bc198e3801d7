// SPDX-License-Identifier: Apache-2.0
//
// The GPUs' search, compiled as C++, against the one that asks every primitive, over soups and rays of the awkward
// kinds: the same ids, whatever the mask and the range of t.
#include <gtest/gtest.h>

#include <bit>

#include "bvh/bvh.h"
#include "gpu/trace_tree.h"
#include "support/soups.h"

namespace snell::gpu {

namespace {

using namespace kernel;

// GLSL's.
int findMSB(uint x) { return 31 - std::countl_zero(x); }

// A part of the kernel that the other search's struct has taken in already.
#undef SNELL_KERNEL_SCENE_MOTION_H

struct GpuSearch {
  const TraceWorld& traceWorld;
  const TraceNode* traceNodes;
  const TraceTriangle* traceTriangles;
  const TraceTree* traceTrees;
  const uint* traceShapes;
  const Object* objects;
  const Shape* shapes;
  const Instance* instances;
  const Mesh* meshes;
  const Triangle* triangles;
  const vec3* positions;
  const MotionKey* motions;

#include "gpu/shaders/bvh.glsl"
};

class Search : public testing::TestWithParam<test::SoupKind> {};

TEST_P(Search, AgreesWithBruteForce) {
  test::Random random(900);
  std::uint64_t rays = 0, hits = 0, wrong = 0;
  for (std::uint64_t round = 0; round < test::Scaled(12); ++round) {
    test::Soup soup;
    if (round % 3 != 1) soup.DeformMeshes(random);
    GetParam().fill(soup, random, round % 4 == 0 ? 9 : 200);
    if (soup.PrimitiveCount() == 0) continue;
    if (round % 3 == 0) soup.Move(random);
    const bvh::Geometry geometry = soup.Geometry();
    const bvh::Bvh bvh(geometry);
    const TraceArrays tree = ToTraceArrays(bvh, geometry);
    GpuSearch search{tree.world,
                     tree.nodes.data(),
                     tree.triangles.data(),
                     tree.trees.data(),
                     tree.shapes.data(),
                     geometry.objects.data(),
                     geometry.shapes.data(),
                     geometry.instances.data(),
                     geometry.meshes.data(),
                     geometry.triangles.data(),
                     geometry.positions.data(),
                     geometry.motions.data()};
    test::search::BruteForce brute = soup.BruteForce();
    for (int i = 0; i < 1500; ++i) {
      Ray ray = test::RandomRay(random, soup);
      ray.time = random.Chance(0.1) ? float(random.Index(2)) : random.UniformFloat();
      const unsigned mask = random.Chance(0.5) ? MASK_ALL : 1u << random.Index(5);
      float tMax = random.Chance(0.7) ? Infinite : float(random.LogUniform(1e-3, 1e3));
      Hit expected = brute.ClosestHit(ray, tMax, mask);
      if (expected.primitive != None && random.Chance(0.2)) {
        tMax = soup.DistanceOf(expected, ray);
        expected = brute.ClosestHit(ray, tMax, mask);
      }
      const Hit found = search.ClosestHit(ray, tMax, mask);
      ++rays;
      hits += expected.primitive != None ? 1 : 0;
      const bool same = found.primitive == expected.primitive &&
                        found.instance == expected.instance &&
                        search.AnyHit(ray, tMax, mask) == (expected.primitive != None);
      wrong += same ? 0 : 1;
    }
  }
  // The t of a sliver that is met edge-on is so inexact that it may lie before the sliver's box
  EXPECT_LE(wrong, GetParam().name == "Slivers" ? 1 + rays / 100000 : 0) << "of " << rays;
  EXPECT_GT(hits, rays / 50);
}

INSTANTIATE_TEST_SUITE_P(Of, Search, testing::ValuesIn(test::SoupKinds()),
                         [](const auto& soup) { return soup.param.name; });

}  // namespace

}  // namespace snell::gpu
