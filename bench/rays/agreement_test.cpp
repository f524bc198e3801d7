// SPDX-License-Identifier: Apache-2.0
//
// Snell beside Embree's robust mode in the benchmark's scenes, made small: rays anywhere, and rays aimed
// exactly at vertices and edges. Where the two differ, and for a sample of all rays, double precision decides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "kernel/transform.h"
#include "rays/brute_force.h"
#include "support/random.h"

namespace snell::bench {
namespace {

using glm::dvec3;
using test::Random;

// One of so many rays is judged even if Snell and Embree agree.
constexpr std::size_t SampleStride = 1000;

class Course {
 public:
  explicit Course(const Scene& scene) : scene_(scene), bruteForce_(scene) {
    const std::size_t count = std::max<std::size_t>(scene.placements.size(), 1);
    for (std::size_t i = 0; i < count; ++i) {
      for (const vec3& p : scene.positions) {
        const vec3 world = Placed(p, i);
        lower_ = glm::min(lower_, dvec3(world));
        upper_ = glm::max(upper_, dvec3(world));
      }
    }
  }

  Query RandomQuery(Random& random) const {
    const vec3 o(lower_ + (upper_ - lower_) * (random.InCube() * 0.5 + 0.5));
    if (random.Chance(0.5)) return {{o, vec3(random.Direction()), 0}, kernel::Infinite};

    // At a vertex or at a point of an edge
    const kernel::Triangle& t = scene_.triangles[random.Index(unsigned(scene_.triangles.size()))];
    const std::size_t placement = random.Index(std::max(unsigned(scene_.placements.size()), 1u));
    const vec3 a = Placed(scene_.positions[t.v0], placement);
    const vec3 b = Placed(scene_.positions[t.v1], placement);
    const vec3 target =
        random.Chance(0.5) ? a : vec3(dvec3(a) + (dvec3(b) - dvec3(a)) * random.Uniform());
    return {{o, target - o, 0}, kernel::Infinite};
  }

  // Whether the nearest hit at t, or none if t is infinite, differs from the truth by no more than rounding.
  bool IsRight(const Query& query, float t) const {
    const Truth truth = bruteForce_.Trace(query);
    if (!truth.Allows(t)) return false;

    // Rounding excuses a ray that passes a surface only if one of its neighbours does too
    const dvec3 o(query.ray.o), d = glm::normalize(dvec3(query.ray.d));
    const dvec3 side =
        glm::normalize(glm::cross(d, std::abs(d.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    const double distance = 32 * 0x1p-24 * glm::length(upper_ - lower_);
    const double passed = truth.nearest + distance / glm::length(dvec3(query.ray.d));
    bool excused = double(t) <= passed;
    for (int i = 0; i < 8 && !excused; ++i) {
      const double angle = i * 0.7853981633974483;
      const dvec3 out = side * std::cos(angle) + glm::cross(d, side) * std::sin(angle);
      const Query neighbour{{vec3(o + out * distance), query.ray.d, 0}, query.tMax};
      excused = bruteForce_.Trace(neighbour).nearest >= (passed + double(t)) / 2;
    }
    return excused;
  }

 private:
  vec3 Placed(vec3 p, std::size_t placement) const {
    return scene_.placements.empty() ? p : kernel::ToWorldPoint(scene_.placements[placement], p);
  }

  const Scene& scene_;
  BruteForce bruteForce_;
  dvec3 lower_{std::numeric_limits<double>::infinity()};
  dvec3 upper_{-std::numeric_limits<double>::infinity()};
};

// Both hit at about the same distance, or neither does.
bool AreAlike(float a, float b) {
  if (std::isinf(a) || std::isinf(b)) return a == b;
  return std::abs(a - b) <= 1e-4f * std::max(a, b);
}

class WithEmbree : public testing::TestWithParam<std::string_view> {};

TEST_P(WithEmbree, HitsAreTheSame) {
  // The mesh of the instances is small, since there are ten thousand
  const Scene scene = MakeScene(GetParam(), GetParam() == "instances" ? 18 : 20000);
  const Course course(scene);
  const auto fast = MakeSnell(Quality::Medium), high = MakeSnell(Quality::High);
  const auto embree = MakeEmbree(Quality::Medium, true);
  fast->Build(scene);
  high->Build(scene);
  embree->Build(scene);

  Random random(770);
  std::uint64_t rays = 0, hits = 0, differences = 0, judged = 0, wrong = 0, wrongEmbree = 0;
  std::uint64_t wrongHigh = 0, wrongAny = 0;
  for (std::uint64_t round = 0; round < test::Scaled(10); ++round) {
    std::vector<Query> queries(10000);
    for (Query& query : queries) query = course.RandomQuery(random);
    std::vector<Answer> ours(queries.size()), highs = ours, anys = ours, theirs = ours;
    fast->Closest(queries, ours.data());
    high->Closest(queries, highs.data());
    fast->Any(queries, anys.data());
    embree->Closest(queries, theirs.data());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ++rays;
      hits += std::isfinite(ours[i].t);
      wrongHigh += ours[i].t != highs[i].t || ours[i].primitive != highs[i].primitive;
      wrongAny += std::isfinite(ours[i].t) != std::isfinite(anys[i].t);
      const bool differs = !AreAlike(ours[i].t, theirs[i].t);
      differences += differs;
      if (!differs && i % SampleStride != 0) continue;
      ++judged;
      wrongEmbree += !course.IsRight(queries[i], theirs[i].t);
      if (!course.IsRight(queries[i], ours[i].t) && wrong++ == 0) {
        const auto& [o, d, time] = queries[i].ray;
        ADD_FAILURE() << "ray from " << std::hexfloat << o.x << " " << o.y << " " << o.z
                      << " towards " << d.x << " " << d.y << " " << d.z << std::defaultfloat
                      << ": Snell " << ours[i].t << ", Embree " << theirs[i].t;
      }
    }
  }
  EXPECT_EQ(wrong, 0u) << "of " << judged << " judged";
  EXPECT_EQ(wrongHigh, 0u) << "of " << rays;
  EXPECT_EQ(wrongAny, 0u) << "of " << rays;
  EXPECT_GT(hits, rays / 10);
  std::printf("%llu rays, %llu hits, %llu differ from Embree, %llu judged, wrong: Embree %llu\n",
              (unsigned long long)rays, (unsigned long long)hits, (unsigned long long)differences,
              (unsigned long long)judged, (unsigned long long)wrongEmbree);
}

INSTANTIATE_TEST_SUITE_P(In, WithEmbree, testing::ValuesIn(SceneNames()), [](const auto& scene) {
  std::string name(scene.param);
  std::ranges::replace(name, ' ', '_');
  return name;
});

}  // namespace
}  // namespace snell::bench
