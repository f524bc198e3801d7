// SPDX-License-Identifier: Apache-2.0
//
// Filters, as for alpha textures: where one says that a surface has a hole, rays find what is behind; and
// geometry without meshes and objects.
#include <gtest/gtest.h>

#include "bvh/bvh.h"
#include "support/soups.h"

namespace snell::bvh {
namespace {

using kernel::Hit;
using kernel::Infinite;
using kernel::INSTANCE_SHAPE;
using kernel::MASK_ALL;
using kernel::Ray;
using test::Random;
using test::Soup;

std::uint32_t MaskOf(const Geometry& geometry, const Intersection& hit) {
  std::uint32_t object;
  if (hit.instance == INSTANCE_SHAPE) {
    object = geometry.shapes[hit.primitive].object;
  } else if (hit.instance == None) {
    object = geometry.meshes[geometry.triangles[hit.primitive].mesh].object;
  } else {
    object = geometry.instances[hit.instance].object;
  }
  return geometry.objects[object].mask;
}

// Every surface is a chessboard in space whose black fields are holes, and some primitives are none at all.
bool IsThere(const Ray& ray, const Intersection& hit) {
  if (hit.primitive % 5 == 3) return false;
  const vec3 p = ray.o + ray.d * hit.t;
  const auto field = [](float x) { return int(std::floor(kernel::Clamp(x, -1e6f, 1e6f) * 6)); };
  return ((field(p.x) + field(p.y) + field(p.z)) & 1) == 0;
}

// The nearest hit with holes, by asking every primitive.
Intersection ClosestWithHoles(Soup& soup, const Ray& ray, float tMax, std::uint32_t mask) {
  const Geometry geometry = soup.Geometry();
  Intersection best{tMax, None, None};
  const auto offer = [&](std::uint32_t primitive, std::uint32_t instance) {
    const Intersection hit{soup.DistanceOf({primitive, instance}, ray), primitive, instance};
    const bool first = hit.instance < best.instance ||
                       (hit.instance == best.instance && hit.primitive < best.primitive);
    if (!(hit.t > 0) || hit.t > best.t || (hit.t == best.t && !first)) return;
    if ((MaskOf(geometry, hit) & mask) != 0 && IsThere(ray, hit)) best = hit;
  };
  for (std::uint32_t i = 0; i < geometry.worldTriangles; ++i) offer(i, None);
  for (std::uint32_t i = 0; i < geometry.shapes.size(); ++i) offer(i, INSTANCE_SHAPE);
  for (std::uint32_t k = 0; k < geometry.instances.size(); ++k) {
    const kernel::Instance& instance = geometry.instances[k];
    for (std::uint32_t i = 0; i < instance.triangleCount; ++i) offer(instance.firstTriangle + i, k);
  }
  return best;
}

// What the filter is given, and whether it is asked only what it should be.
struct Asked {
  const Soup* soup;
  Geometry geometry;
  Ray ray;
  std::uint32_t mask;
  mutable std::uint64_t questions = 0;
  mutable std::uint64_t faults = 0;
};

bool Answer(const void* data, const Ray& ray, const Intersection& hit) {
  const Asked& asked = *static_cast<const Asked*>(data);
  ++asked.questions;
  const bool right = ray.o == asked.ray.o && ray.d == asked.ray.d && hit.t > 0 &&
                     asked.soup->DistanceOf({hit.primitive, hit.instance}, ray) == hit.t &&
                     (MaskOf(asked.geometry, hit) & asked.mask) != 0;
  asked.faults += !right;
  return IsThere(ray, hit);
}

class Filter : public testing::TestWithParam<test::SoupKind> {};

TEST_P(Filter, LetsRaysThroughHoles) {
  Random random(750);
  std::uint64_t rays = 0, hits = 0, holes = 0, wrong = 0;
  for (std::uint64_t round = 0; round < test::Scaled(6); ++round) {
    Soup soup;
    GetParam().fill(soup, random, round % 3 == 0 ? 9 : 100);
    if (soup.PrimitiveCount() == 0) continue;
    Bvh bvh(soup.Geometry());
    Asked asked{&soup, soup.Geometry(), {}, 0};
    bvh.SetFilter({Answer, &asked});
    test::search::BruteForce brute = soup.BruteForce();
    for (int i = 0; i < 500; ++i) {
      const Ray ray = test::RandomRay(random, soup);
      const std::uint32_t mask = random.Chance(0.5) ? MASK_ALL : 1u << random.Index(5);
      const float tMax = random.Chance(0.7) ? Infinite : float(random.LogUniform(1e-3, 1e3));
      const Intersection expected = ClosestWithHoles(soup, ray, tMax, mask);
      const Hit solid = brute.ClosestHit(ray, tMax, mask);
      ++rays;
      hits += expected.primitive != None;
      holes += solid.primitive != expected.primitive || solid.instance != expected.instance;
      asked.ray = ray;
      asked.mask = mask;
      for (const InstructionSet set : SupportedInstructionSets()) {
        bvh.Use(set);
        const Intersection found = bvh.Closest(ray, tMax, mask);
        wrong += found.primitive != expected.primitive || found.instance != expected.instance ||
                 found.t != expected.t || bvh.Any(ray, tMax, mask) != (expected.primitive != None);
      }
    }
    EXPECT_EQ(asked.faults, 0u) << "of " << asked.questions;
  }
  // The t of a sliver that is met edge-on is so inexact that it may lie before the sliver's box
  const std::uint64_t allowed = GetParam().name == "Slivers" ? 1 + rays / 100000 : 0;
  EXPECT_LE(wrong, allowed * SupportedInstructionSets().size()) << "of " << rays;
  EXPECT_GT(hits, rays / 50);
  EXPECT_GT(holes, rays / 50);
}

// Without meshes and objects, everything is seen by every ray.
TEST_P(Filter, IsAskedAboutPlainGeometryToo) {
  Random random(751);
  std::uint64_t wrong = 0;
  for (const unsigned count : {1u, 9u, 100u}) {
    Soup soup;
    GetParam().fill(soup, random, count);
    if (soup.PrimitiveCount() == 0) continue;
    Geometry plain = soup.Geometry();
    plain.meshes = {};
    plain.objects = {};
    Bvh bvh(plain);
    test::search::BruteForce brute = soup.BruteForce();
    for (int i = 0; i < 300; ++i) {
      const Ray ray = test::RandomRay(random, soup);
      const std::uint32_t mask = 1u << random.Index(32);
      const Hit solid = brute.ClosestHit(ray, Infinite, MASK_ALL);
      const Intersection holed = ClosestWithHoles(soup, ray, Infinite, MASK_ALL);
      for (const InstructionSet set : SupportedInstructionSets()) {
        bvh.Use(set);
        bvh.SetFilter({});
        Intersection found = bvh.Closest(ray, Infinite, mask);
        wrong += found.primitive != solid.primitive || found.instance != solid.instance ||
                 bvh.Any(ray, Infinite, mask) != (solid.primitive != None);
        bvh.SetFilter(
            {[](const void*, const Ray& r, const Intersection& hit) { return IsThere(r, hit); }});
        found = bvh.Closest(ray, Infinite, mask);
        wrong += found.primitive != holed.primitive || found.instance != holed.instance ||
                 bvh.Any(ray, Infinite, mask) != (holed.primitive != None);
      }
    }
  }
  EXPECT_EQ(wrong, 0u);
}

INSTANTIATE_TEST_SUITE_P(Of, Filter, testing::ValuesIn(test::SoupKinds()),
                         [](const auto& soup) { return soup.param.name; });

// Parallel triangles, one behind the other.
TEST(FilterByTriangle, FindsTheFirstThatCounts) {
  Soup soup;
  for (int i = 0; i < 30; ++i) {
    const float z = float(i);
    soup.AddTriangle(vec3(-1, -1, z), vec3(1, -1, z), vec3(0, 1, z));
  }
  Bvh bvh(soup.Geometry());
  std::uint32_t first = 0;
  bvh.SetFilter({[](const void* data, const Ray&, const Intersection& hit) {
                   return hit.primitive >= *static_cast<const std::uint32_t*>(data);
                 },
                 &first});
  const Ray forth{vec3(0, 0, -1), vec3(0, 0, 1), 0};
  const Ray back{vec3(0, 0, 40), vec3(0, 0, -2), 0};
  for (const InstructionSet set : SupportedInstructionSets()) {
    bvh.Use(set);
    for (first = 0; first < 30; ++first) {
      const float t = float(first + 1);
      EXPECT_EQ(bvh.Closest(forth, Infinite).primitive, first);
      EXPECT_EQ(bvh.Closest(forth, t).primitive, first);
      EXPECT_EQ(bvh.Closest(back, Infinite).primitive, 29u);
      EXPECT_TRUE(bvh.Any(forth, t));
      EXPECT_TRUE(bvh.Any(back, Infinite));

      // Nothing is nearer
      const Intersection none = bvh.Closest(forth, kernel::NextFloatDown(t));
      EXPECT_EQ(none.primitive, None);
      EXPECT_EQ(none.t, kernel::NextFloatDown(t));
      EXPECT_FALSE(bvh.Any(forth, kernel::NextFloatDown(t)));
    }
    // Here none counts
    EXPECT_EQ(bvh.Closest(forth, Infinite).primitive, None);
    EXPECT_FALSE(bvh.Any(back, Infinite));
  }
}

}  // namespace
}  // namespace snell::bvh
