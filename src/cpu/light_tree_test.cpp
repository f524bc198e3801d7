// SPDX-License-Identifier: Apache-2.0
//
// The light tree: at any point the probabilities of all sources add up to one, none that shines there is left out,
// choices fall as the probabilities say (χ²), and light over probability is the light of all sources together.
#include "cpu/light_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "cpu/flatten_light_tree.h"
#include "kernel/values.h"
#include "support/random.h"
#include "support/statistics.h"

namespace snell::cpu {

using namespace kernel;

namespace {

// The part of the kernel that goes down the tree (cpu/kernel.h binds all of it).
struct TreeKernel {
  const RenderParams& params;
  const Light* lights;
  const LightNode* lightNodes;

#include "kernel/scene_light_tree.h"
};

TreeKernel Bind(const FlatScene& flat) {
  return {flat.params, flat.lights.data(), flat.lightNodes.data()};
}

// A light of any kind but directional, with any falloff, near a place.
Light RandomLight(test::Random& random, vec3 place) {
  constexpr uint Kinds[] = {LIGHT_POINT,    LIGHT_SPOT, LIGHT_RECTANGLE,
                            LIGHT_TRIANGLE, LIGHT_DISK, LIGHT_SPHERE};
  Light light = {};
  light.kind = Kinds[random.Index(6)];
  light.profile = kernel::None;
  const bool isPhysical = random.Chance(0.7);
  light.falloff = isPhysical ? FALLOFF_INVERSE_SQUARE : random.Index(2);
  light.factor = float(random.LogUniform(0.3, 3));
  light.range = random.Chance(0.2) ? float(random.LogUniform(0.5, 10)) : 0;
  light.emission = Spectrum(1, 0.5f, 0.2f) * float(random.LogUniform(0.1, 10));
  light.position = place;
  light.direction = vec3(random.Direction());
  const float size = float(random.LogUniform(0.01, 1));
  CoordinateSystem(light.direction, light.edgeU, light.edgeV);
  light.edgeU *= size;
  light.edgeV *= size * 0.6f;
  light.area = Length(Cross(light.edgeU, light.edgeV));
  if (light.kind == LIGHT_TRIANGLE) light.area *= 0.5f;
  if (light.kind == LIGHT_DISK) {
    light.edgeV *= 1 / 0.6f;
    light.radius = size;
    light.area = Pi * size * size;
  }
  if (light.kind == LIGHT_SPHERE || (light.kind <= LIGHT_SPOT && random.Chance(0.3)))
    light.radius = size;
  const float outer = float(random.Uniform(0.05, 3));
  light.cosOuter = std::cos(outer);
  light.cosInner = random.Chance(0.5) ? light.cosOuter : std::cos(outer * 0.7f);
  return light;
}

// So many in clusters.
FlatScene RandomLights(int count, std::uint64_t seed) {
  test::Random random(seed);
  FlatScene flat;
  flat.params = {};
  glm::dvec3 cluster(0.0);
  for (int i = 0; i < count; ++i) {
    if (i % 16 == 0) cluster = random.InCube() * 10.0;
    flat.lights.push_back(RandomLight(random, vec3(cluster + random.InCube())));
  }
  flat.params.lightCount = uint(count);
  FlattenLightTree(flat);
  return flat;
}

// A place and its normal, which is 0 for every third.
struct Receiver {
  vec3 p;
  vec3 n;
};
Receiver RandomReceiver(test::Random& random) {
  Receiver at = {vec3(random.InCube() * random.LogUniform(1, 30)), vec3(random.Direction())};
  if (random.Index(3) == 0) at.n = vec3(0.0f);
  return at;
}

// What one sample of a light brings.
double Brought(const Light& light, const Receiver& at, vec2 u) {
  const LightLiSample li = SampleLi(light, at.p, u);
  const float cosine = LengthSquared(at.n) > 0 ? Dot(at.n, li.wi) : 1;
  return double(li.irradiance.y * std::max(cosine, 0.0f));
}

TEST(LightTree, ProbabilitiesOfAllSourcesAddUpToOne) {
  test::Random random(301);
  for (const int count : {1, 2, 3, 40, 300}) {
    const FlatScene flat = RandomLights(count, 77);
    TreeKernel kernel = Bind(flat);
    for (int i = 0; i < 200; ++i) {
      const Receiver at = RandomReceiver(random);
      double sum = 0;
      for (const Light& light : flat.lights)
        sum += double(kernel.PdfLightTree(at.p, at.n, light.node));
      // Less where a bound is bright whose children are both dark
      EXPECT_LE(sum, 1 + 1e-5);
      float pick;
      const bool isFound =
          kernel.SampleLightTree(at.p, at.n, vec2(0.37f, 0.5f), pick) != kernel::None;
      EXPECT_TRUE(sum > 0 || !isFound);
      if (sum > 0 && count <= 2) {
        EXPECT_NEAR(sum, 1, 1e-5);
      }
    }
  }
}

TEST(LightTree, LeavesNothingOutThatShines) {
  test::Random random(302);
  const FlatScene flat = RandomLights(300, 78);
  TreeKernel kernel = Bind(flat);
  std::uint64_t shining = 0;
  for (std::uint64_t i = 0; i < test::Scaled(300); ++i) {
    const Receiver at = RandomReceiver(random);
    for (const Light& light : flat.lights) {
      const double brought = Brought(light, at, vec2(random.UniformFloat(), random.UniformFloat()));
      if (brought <= 1e-6) continue;
      ++shining;
      ASSERT_GT(kernel.PdfLightTree(at.p, at.n, light.node), 0)
          << "kind " << light.kind << ", falloff " << light.falloff << ", range " << light.range;
    }
  }
  EXPECT_GT(shining, 10000u);
}

TEST(LightTree, ChoicesFallAsTheProbabilitiesSay) {
  test::Random random(303);
  const FlatScene flat = RandomLights(200, 79);
  TreeKernel kernel = Bind(flat);
  constexpr int Tests = 8;
  for (int test = 0; test < Tests; ++test) {
    const Receiver at = RandomReceiver(random);
    const std::uint64_t count = test::Scaled(200000);
    std::vector<double> observed(flat.lights.size() + 1, 0), expected;
    for (std::uint64_t i = 0; i < count; ++i) {
      float pick;
      const uint source = kernel.SampleLightTree(
          at.p, at.n, vec2(random.UniformFloat(), random.UniformFloat()), pick);
      if (source == kernel::None) {
        observed.back() += 1;
        continue;
      }
      observed[source] += 1;
      ASSERT_NEAR(kernel.PdfLightTree(at.p, at.n, flat.lights[source].node), pick, 1e-5f * pick);
    }
    double none = 1;
    for (const Light& light : flat.lights) {
      const double pdf = double(kernel.PdfLightTree(at.p, at.n, light.node));
      expected.push_back(pdf * double(count));
      none -= pdf;
    }
    expected.push_back(std::max(none, 0.0) * double(count));
    EXPECT_GT(test::ChiSquarePValue(observed, expected), test::Sidak(0.01, Tests)) << test;
  }
}

TEST(LightTree, LightOverProbabilityIsThatOfAllSources) {
  test::Random random(304);
  const FlatScene flat = RandomLights(100, 80);
  TreeKernel kernel = Bind(flat);
  for (int i = 0; i < 20; ++i) {
    const Receiver at = RandomReceiver(random);
    const vec2 u(random.UniformFloat(), random.UniformFloat());
    double expected = 0;
    for (const Light& light : flat.lights) expected += Brought(light, at, u);
    test::Moments moments;
    const std::uint64_t count = test::Scaled(100000);
    for (std::uint64_t sample = 0; sample < count; ++sample) {
      float pick;
      const vec2 choice(random.UniformFloat(), random.UniformFloat());
      const uint source = kernel.SampleLightTree(at.p, at.n, choice, pick);
      moments.Add(source == kernel::None ? 0 : Brought(flat.lights[source], at, u) / double(pick));
    }
    const double error = std::sqrt(moments.Variance() / double(count));
    EXPECT_NEAR(moments.Mean(), expected, 5 * error + 1e-4 * expected) << i;
    // One sample is worth something, too
    EXPECT_LT(error, 0.03 * expected + 1e-9) << i;
  }
}

TEST(LightTree, ByPowerIsProportionalToIt) {
  FlatScene flat;
  flat.params = {};
  for (int i = 0; i < 10; ++i) {
    Light light = {};
    light.profile = kernel::None;
    light.falloff = FALLOFF_INVERSE_SQUARE;
    light.emission = Spectrum(float(i));
    light.position = vec3(float(i * i), 0, 0);
    flat.lights.push_back(light);
  }
  flat.params.lightCount = 10;
  flat.params.lightSampling = LIGHTS_BY_POWER;
  FlattenLightTree(flat);
  EXPECT_EQ(flat.lights[0].node, kernel::None) << "a dark light takes no samples";
  EXPECT_EQ(flat.lightNodes.size(), 17u);
  TreeKernel kernel = Bind(flat);
  for (uint i = 0; i < 10; ++i)
    EXPECT_NEAR(kernel.PdfLightTree(vec3(3, 1, 0), vec3(0, 1, 0), flat.lights[i].node),
                float(i) / 45, 1e-6f);
}

TEST(LightTree, HoldsEverySourceOnceAndStaysShallow) {
  // In a row, on one spot, and anywhere
  for (const int arrangement : {0, 1, 2}) {
    test::Random random(305);
    FlatScene flat;
    flat.params = {};
    for (int i = 0; i < 20000; ++i) {
      const double x = std::pow(1.002, double(i));
      Light light = RandomLight(random, arrangement == 0   ? vec3(float(x), 0, 0)
                                        : arrangement == 1 ? vec3(1, 2, 3)
                                                           : vec3(random.InCube()));
      flat.lights.push_back(light);
    }
    flat.params.lightCount = uint(flat.lights.size());
    FlattenLightTree(flat);
    ASSERT_EQ(flat.lightNodes.size(), 2 * flat.lights.size() - 1);
    std::set<uint> found;
    for (uint i = 0; i < flat.lightNodes.size(); ++i) {
      const LightNode& node = flat.lightNodes[i];
      if ((node.flags & LIGHT_NODE_LEAF) != 0) {
        found.insert(node.first);
        ASSERT_EQ(flat.lights[node.first].node, i);
        int depth = 0;
        for (uint at = i; at != 0; at = flat.lightNodes[at].parent) ++depth;
        ASSERT_LE(depth, 60);
        continue;
      }
      for (const uint child : {node.first, node.first + 1}) {
        ASSERT_EQ(flat.lightNodes[child].parent, i);
        ASSERT_EQ(child % 2, child - node.first == 0 ? 1u : 0u);
      }
    }
    EXPECT_EQ(found.size(), flat.lights.size());
  }
}

TEST(LightCone, HoldsBoth) {
  test::Random random(306);
  for (int i = 0; i < 20000; ++i) {
    const auto cone = [&] {
      return LightCone{random.Direction(),
                       random.Chance(0.3) ? 0 : random.Uniform(0, std::numbers::pi),
                       random.Uniform(0, 1.5), random.Chance(0.5)};
    };
    const LightCone a = cone(), b = cone();
    const LightCone both = LightCone::Union(a, b);
    EXPECT_GE(both.thetaE, std::max(a.thetaE, b.thetaE));
    for (const LightCone& part : {a, b}) {
      double cosine = glm::dot(both.axis, part.axis);
      if (both.twoSided && part.twoSided) cosine = std::abs(cosine);
      const double between = std::acos(std::clamp(cosine, -1.0, 1.0));
      ASSERT_LE(std::min(between + part.thetaO, std::numbers::pi), both.thetaO + 1e-6);
    }
  }
}

TEST(LightCone, MeasuresWhatItCovers) {
  const glm::dvec3 up(0, 1, 0);
  EXPECT_NEAR((LightCone{up, std::numbers::pi, std::numbers::pi / 2, false}).Measure(),
              4 * std::numbers::pi, 1e-12);
  // A flat source: the projected hemisphere
  EXPECT_NEAR((LightCone{up, 0, std::numbers::pi / 2, false}).Measure(), std::numbers::pi, 1e-12);
  EXPECT_NEAR((LightCone{up, 0, std::numbers::pi / 2, true}).Measure(), 2 * std::numbers::pi,
              1e-12);
}

}  // namespace

}  // namespace snell::cpu
