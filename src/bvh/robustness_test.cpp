// SPDX-License-Identifier: Apache-2.0
//
// What no scene should hold and some do: nothing at all, coordinates that are not finite or enormous, and
// rays that are not numbers. Nothing may crash, and what is sound must still be found.
#include <gtest/gtest.h>

#include "bvh/bvh.h"
#include "support/soups.h"

namespace snell::bvh {
namespace {

using kernel::Hit;
using kernel::Infinite;
using kernel::Instance;
using kernel::MASK_ALL;
using kernel::Ray;
using test::Random;
using test::Soup;

constexpr float Inf = std::numeric_limits<float>::infinity();
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

// Ask with every instruction set; all must agree.
std::uint32_t PrimitiveHit(Bvh& bvh, const Ray& ray, float tMax = Infinite) {
  std::uint32_t first = 0;
  bool isFirst = true;
  for (const InstructionSet set : SupportedInstructionSets()) {
    bvh.Use(set);
    const std::uint32_t primitive = bvh.Closest(ray, tMax, MASK_ALL).primitive;
    EXPECT_EQ(bvh.Any(ray, tMax, MASK_ALL), primitive != None) << NameOf(set);
    if (!isFirst) {
      EXPECT_EQ(primitive, first) << NameOf(set);
    }
    first = primitive;
    isFirst = false;
  }
  return first;
}

TEST(EmptyBvh, IsMissedByEveryRay) {
  Soup soup;
  Bvh bvh(soup.Geometry());
  EXPECT_EQ(bvh.droppedPrimitives(), 0u);
  Random random(720);
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(PrimitiveHit(bvh, {vec3(random.InCube()), vec3(random.Direction()), 0}), None);
}

TEST(EmptyBvh, MayHoldInstancesOfNothing) {
  Soup soup;
  soup.AddInstance(soup.AddMesh(test::TriangleMesh{}), glm::dmat4(1.0));
  soup.AddInstance(soup.AddMesh(test::TriangleMesh{{vec3(NaN)}, {{0, 0, 0}}}), glm::dmat4(1.0));
  Bvh bvh(soup.Geometry());
  EXPECT_EQ(bvh.droppedPrimitives(), 1u);
  EXPECT_EQ(PrimitiveHit(bvh, {vec3(0, 0, -5), vec3(0, 0, 1), 0}), None);
}

TEST(EmptyBvh, MayHoldPlanesAlone) {
  Soup soup;
  kernel::Shape plane = {};
  plane.kind = kernel::SHAPE_PLANE;
  plane.toWorld = test::ToKernel(glm::dmat4(1.0));
  soup.AddShape(plane);
  Bvh bvh(soup.Geometry());
  EXPECT_EQ(PrimitiveHit(bvh, {vec3(1e5f, 2, -1e5f), vec3(0, -1, 0), 0}), 0u);
  EXPECT_EQ(PrimitiveHit(bvh, {vec3(1e5f, 2, -1e5f), vec3(0, -1, 0), 0}, 1.99f), None);
  EXPECT_EQ(PrimitiveHit(bvh, {vec3(0, 2, 0), vec3(0, 1, 0), 0}), None);
}

TEST(DroppedPrimitives, AreThoseWithoutFiniteCoordinates) {
  // A sound triangle after each bad one
  Soup soup;
  std::uint32_t bad = 0;
  for (const float value : {NaN, Inf, -Inf}) {
    for (int vertex = 0; vertex < 3; ++vertex) {
      for (int axis = 0; axis < 3; ++axis) {
        vec3 v[3] = {vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)};
        v[vertex][axis] = value;
        soup.AddTriangle(v[0], v[1], v[2]);
        const float x = 2 * float(++bad);
        soup.AddTriangle(vec3(x, 0, 0), vec3(x + 1, 0, 0), vec3(x, 1, 0));
      }
    }
  }
  // In a mesh of two instances, bad triangles count once; an instance that is nowhere counts itself
  test::TriangleMesh mesh = test::Cube();
  mesh.positions[7].x = NaN;
  std::uint32_t spoilt = 0;
  for (const kernel::uvec3 t : mesh.triangles) spoilt += t.x == 7 || t.y == 7 || t.z == 7;
  const Instance instance = soup.AddMesh(mesh);
  soup.AddInstance(instance, glm::dmat4(1.0));
  soup.AddInstance(instance, glm::dmat4(2.0));
  glm::dmat4 nowhere(1.0);
  nowhere[3][1] = std::numeric_limits<double>::quiet_NaN();
  soup.AddInstance(instance, nowhere);

  Bvh bvh(soup.Geometry());
  EXPECT_EQ(bvh.droppedPrimitives(), bad + spoilt + 1);
  for (std::uint32_t i = 1; i <= bad; ++i)
    EXPECT_EQ(PrimitiveHit(bvh, {vec3(2 * float(i) + 0.2f, 0.2f, 9), vec3(0, 0, -1), 0}, 10.0f),
              2 * i - 1);
}

// Triangles of the size of the coordinates, few enough to leave places of nodes empty.
Soup TrianglesOfSize(Random& random, double size, unsigned count) {
  Soup soup;
  for (unsigned i = 0; i < count; ++i)
    test::AddRandomTriangle(soup, random, random.InCube() * (0.1 * size), 0.05 * size);
  return soup;
}

TEST(HugeCoordinates, NeverCrash) {
  Random random(721);
  for (double size = 1e6; size < 3e38; size *= 30) {
    for (const unsigned count : {1u, 9u, 30u, 200u}) {
      Soup soup = TrianglesOfSize(random, size, count);
      Bvh bvh(soup.Geometry());
      for (int i = 0; i < 200; ++i) {
        Ray ray = test::RandomRay(random, soup);
        if (random.Chance(0.5)) ray.o = vec3(random.InCube() * std::min(size * 10, 3e38));
        const std::uint32_t primitive = PrimitiveHit(bvh, ray);
        EXPECT_TRUE(primitive == None || primitive < count);
      }
    }
  }
}

TEST(HugeCoordinates, AreStillHitUpTo1e12) {
  Random random(722);
  for (const double size : {1e-12, 1e-9, 1e-4, 1e5, 1e9, 1e12}) {
    Soup soup = TrianglesOfSize(random, size, 100);
    Bvh bvh(soup.Geometry());
    test::search::BruteForce brute = soup.BruteForce();
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 o = random.Direction() * (2 * size);
      const Ray ray{vec3(o), vec3(glm::normalize(soup.PointOnSurface(random) - o)), 0};
      const Hit expected = brute.ClosestHit(ray, Infinite, MASK_ALL);
      hits += expected.primitive != None;
      EXPECT_EQ(PrimitiveHit(bvh, ray), expected.primitive) << size;
    }
    EXPECT_GT(hits, 250) << size;
  }
}

TEST(BadRays, NeverCrashAndHitNothing) {
  Random random(723);
  for (const unsigned count : {1u, 9u, 30u, 200u}) {
    Soup soup = TrianglesOfSize(random, 10, count);
    test::AddRandomShapes(soup, random, 5, 1, false);
    const test::TriangleMesh mesh = test::Icosphere(0);
    soup.AddInstance(soup.AddMesh(mesh), glm::dmat4(1.0));
    Bvh bvh(soup.Geometry());
    for (const float bad : {NaN, Inf, -Inf}) {
      for (int places = 1; places < 64; ++places) {
        // Any set of the six numbers
        Ray ray{vec3(random.InCube()), vec3(random.Direction()), 0};
        for (int i = 0; i < 6; ++i) {
          if (places >> i & 1) (i < 3 ? ray.o : ray.d)[i % 3] = bad;
        }
        EXPECT_EQ(PrimitiveHit(bvh, ray), None) << bad << " at " << places;
      }
    }
    EXPECT_EQ(PrimitiveHit(bvh, {vec3(0, 0, -9), vec3(0), 0}), None);
  }
}

TEST(Ranges, ThatAreEmptyHoldNoHit) {
  Soup soup;
  soup.AddTriangle(vec3(-1, -1, 0), vec3(1, -1, 0), vec3(0, 1, 0));
  Bvh bvh(soup.Geometry());
  const Ray ray{vec3(0, 0, -2), vec3(0, 0, 1), 0};
  EXPECT_EQ(PrimitiveHit(bvh, ray, 2.0f), 0u);
  for (const float tMax : {0.0f, -0.0f, -1.0f, -Inf, NaN, 1e-45f, 1.9999998f})
    EXPECT_EQ(PrimitiveHit(bvh, ray, tMax), None) << tMax;
  EXPECT_EQ(PrimitiveHit(bvh, ray, Inf), 0u);
}

}  // namespace
}  // namespace snell::bvh
