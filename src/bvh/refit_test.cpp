// SPDX-License-Identifier: Apache-2.0
//
// Refitting: after everything has moved, near or far, rays find what the search that asks every primitive
// finds; where nothing has moved, not a byte changes.
#include <gtest/gtest.h>

#include "bvh/bvh.h"
#include "bvh/tree_bytes.h"
#include "support/soups.h"
#include "util/threads.h"

namespace snell::bvh {
namespace {

using kernel::Hit;
using kernel::Infinite;
using kernel::Ray;
using test::Random;
using test::Soup;

constexpr float Inf = std::numeric_limits<float>::infinity();
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

// Move vertices by up to `distance`; with `anew`, shapes and instances become others somewhere else.
void Move(Soup& soup, Random& random, double distance, bool anew) {
  for (vec3& p : soup.positions()) p = vec3(glm::dvec3(p) + random.InCube() * distance);
  const auto shift = [&](kernel::Transform& m) {
    m.origin = vec3(glm::dvec3(m.origin) + random.InCube() * distance);
  };
  for (kernel::Shape& shape : soup.shapes()) {
    if (anew) {
      // Infinite planes alone stay what they are
      const kernel::Shape old = shape;
      do {
        shape = test::RandomShape(random, test::ShapeKinds[random.Index(9)],
                                  {test::MapKinds[random.Index(4)], 0.2, 5});
      } while ((shape.kind == kernel::SHAPE_PLANE) != (old.kind == kernel::SHAPE_PLANE));
      shape.object = old.object;
    } else {
      shift(shape.toWorld);
    }
  }
  for (kernel::Instance& instance : soup.instances()) {
    if (anew) {
      instance.toWorld =
          test::ToKernel(test::RandomMap(random, test::MapKinds[random.Index(4)], 0.2, 5));
    } else {
      shift(instance.toWorld);
    }
  }
}

class Refit : public testing::TestWithParam<test::SoupKind> {};

TEST_P(Refit, FindsWhatHasMoved) {
  Random random(740);
  std::uint64_t rays = 0, hits = 0, wrong = 0;
  for (std::uint64_t round = 0; round < test::Scaled(8); ++round) {
    Soup soup;
    if (round % 4 == 3) soup.DeformMeshes(random);
    GetParam().fill(soup, random, round % 4 == 0 ? 9 : 200);
    if (soup.PrimitiveCount() == 0) continue;
    Bvh bvh(soup.Geometry());
    // Several times, for nothing of the former places may be left
    for (int move = 0; move < 3; ++move) {
      Move(soup, random, random.LogUniform(1e-4, 10), round % 2 == 1);
      bvh.Refit();
      test::search::BruteForce brute = soup.BruteForce();
      for (int i = 0; i < 300; ++i) {
        Ray ray = test::RandomRay(random, soup);
        if (round % 4 == 3) ray.time = random.UniformFloat();
        const unsigned mask = random.Chance(0.5) ? kernel::MASK_ALL : 1u << random.Index(5);
        const float tMax = random.Chance(0.7) ? Infinite : float(random.LogUniform(1e-3, 1e3));
        const Hit expected = brute.ClosestHit(ray, tMax, mask);
        ++rays;
        hits += expected.primitive != None;
        for (const InstructionSet set : SupportedInstructionSets()) {
          bvh.Use(set);
          const Intersection found = bvh.Closest(ray, tMax, mask);
          wrong += found.primitive != expected.primitive || found.instance != expected.instance ||
                   bvh.Any(ray, tMax, mask) != (expected.primitive != None);
        }
      }
    }
  }
  // The t of a sliver that is met edge-on is so inexact that it may lie before the sliver's box
  const std::uint64_t allowed = GetParam().name == "Slivers" ? 1 + rays / 100000 : 0;
  EXPECT_LE(wrong, allowed * SupportedInstructionSets().size()) << "of " << rays;
  EXPECT_GT(hits, rays / 50);
}

TEST_P(Refit, ChangesNothingWhereNothingMoved) {
  Random random(741);
  for (const unsigned count : {1u, 9u, 300u, 20000u}) {
    Soup soup;
    GetParam().fill(soup, random, count);
    Bvh bvh(soup.Geometry());
    const std::string built = BytesOf(bvh);
    bvh.Refit();
    EXPECT_TRUE(BytesOf(bvh) == built) << count;
  }
}

TEST_P(Refit, GivesTheSameBytesAtAnyNumberOfThreads) {
  Random random(742);
  Soup soup;
  GetParam().fill(soup, random, 20000);
  Bvh bvh(soup.Geometry());
  Move(soup, random, 0.1, true);
  std::string one;
  for (const int threads : {1, 2, 4, 0}) {
    const ThreadLimit limit(threads);
    bvh.Refit();
    if (threads == 1) one = BytesOf(bvh);
    EXPECT_TRUE(BytesOf(bvh) == one) << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Refit, testing::ValuesIn(test::SoupKinds()),
                         [](const auto& soup) { return soup.param.name; });

// How often a ray from above the middle of a flat triangle, whose vertices lie where `sound` says, does not
// hit it although none of its vertices is `gone`, or hits something although one is.
std::uint64_t WrongHits(Bvh& bvh, const Geometry& geometry, const std::vector<vec3>& sound,
                        const std::vector<bool>& gone) {
  std::uint64_t wrong = 0;
  for (const InstructionSet set : SupportedInstructionSets()) {
    bvh.Use(set);
    for (std::uint32_t i = 0; i < geometry.triangles.size(); ++i) {
      const kernel::Triangle& t = geometry.triangles[i];
      const vec3 middle = (sound[t.v0] + sound[t.v1] + sound[t.v2]) / 3.0f;
      const Ray ray{middle + vec3(0, 1, 0), vec3(0, -1, 0), 0};
      const bool isGone = gone[t.v0] || gone[t.v1] || gone[t.v2];
      wrong += bvh.Closest(ray, Infinite).primitive != (isGone ? None : i);
      wrong += bvh.Any(ray, Infinite) == isGone;
    }
  }
  return wrong;
}

// Neither does a triangle that is gone take others along, whatever pair or leaf it shares with them, nor
// does a ray hit it.
TEST(RefitWithoutNumbers, LosesOnlyTheTrianglesThatHaveNone) {
  Random random(743);
  std::uint64_t wrong = 0, wrongAgain = 0;
  for (const unsigned cells : {1u, 2u, 3u, 20u}) {
    Soup soup;
    soup.AddWorldMesh(test::Grid(cells));
    const std::span<vec3> positions = soup.positions();
    const std::vector<vec3> sound(positions.begin(), positions.end());
    Bvh bvh(soup.Geometry());
    for (int round = 0; round < 40; ++round) {
      std::vector<bool> gone(sound.size(), false);
      for (std::uint32_t i = 0; i < 1 + cells / 4; ++i) {
        const std::uint32_t vertex = random.Index(std::uint32_t(sound.size()));
        const float values[] = {NaN, Inf, -Inf};
        gone[vertex] = true;
        positions[vertex][int(random.Index(3))] = values[random.Index(3)];
      }
      bvh.Refit();
      wrong += WrongHits(bvh, soup.Geometry(), sound, gone);

      // And back
      std::ranges::copy(sound, positions.begin());
      bvh.Refit();
      wrongAgain += WrongHits(bvh, soup.Geometry(), sound, std::vector<bool>(sound.size(), false));
    }
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(wrongAgain, 0u);
}

TEST(RefitWithoutNumbers, LosesOnlyTheShapesAndInstancesThatHaveNone) {
  std::uint64_t wrongShapes = 0, wrongInstances = 0;
  Soup soup;
  const kernel::Instance cube = soup.AddMesh(test::Cube());
  for (int i = 0; i < 6; ++i) {
    const glm::dmat4 map = glm::translate(glm::dmat4(1.0), glm::dvec3(4 * i, 0, 0));
    kernel::Shape sphere = {};
    sphere.kind = kernel::SHAPE_SPHERE;
    sphere.a = 1;
    sphere.toWorld = test::ToKernel(map);
    soup.AddShape(sphere);
    soup.AddInstance(cube, glm::translate(map, glm::dvec3(0, 0, 4)));
  }
  Bvh bvh(soup.Geometry());
  for (std::uint32_t gone = 0; gone < 6; ++gone) {
    const kernel::Transform shapeBefore = soup.shapes()[gone].toWorld;
    const kernel::Transform instanceBefore = soup.instances()[gone].toWorld;
    for (const float bad : {NaN, Inf}) {
      soup.shapes()[gone].toWorld.origin.y = bad;
      soup.instances()[gone].toWorld.origin.y = bad;
      bvh.Refit();
      for (const InstructionSet set : SupportedInstructionSets()) {
        bvh.Use(set);
        for (std::uint32_t i = 0; i < 6; ++i) {
          const float x = 4 * float(i) + 0.25f;
          const Intersection onShape = bvh.Closest({vec3(x, 9, 0.1f), vec3(0, -1, 0), 0}, Infinite);
          wrongShapes += onShape.primitive != (i == gone ? None : i);
          const Intersection onCube = bvh.Closest({vec3(x, 9, 4.1f), vec3(0, -1, 0), 0}, Infinite);
          wrongInstances += onCube.instance != (i == gone ? None : i);
        }
      }
    }
    soup.shapes()[gone].toWorld = shapeBefore;
    soup.instances()[gone].toWorld = instanceBefore;
  }
  EXPECT_EQ(wrongShapes, 0u);
  EXPECT_EQ(wrongInstances, 0u);
}

}  // namespace
}  // namespace snell::bvh
