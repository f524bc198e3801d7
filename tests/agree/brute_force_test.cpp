// SPDX-License-Identifier: Apache-2.0
//
// The CPU's BVH against the GPUs' search and the plainest one, all in C++, over whole pictures: the same bits. And the
// loop budget of software drivers: after 65,535 passes through loop bodies Mesa's driver (22.3) ends all
// loops of an invocation without a word. It runs eight invocations at a time in the lanes of vectors, which
// pass through a loop together as long as one of them wants to and share the counter, so the sum over such
// a group bounds what counts.
#include "agree/brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "agree/bvh_reference.h"
#include "agree/difference.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

constexpr std::uint32_t Samples = 4;  // as many as lavapipe_test.cpp compares
constexpr std::uint32_t LoopBudget = 65535;

constexpr std::size_t GroupSize = 8;  // in a row of a work group; divides the pictures' width

class Searches : public testing::TestWithParam<std::tuple<scene::Integrator, std::string>> {
 protected:
  cpu::FlatScene Flat() const {
    scene::Scene scene = SceneNamed(std::get<1>(GetParam()));
    scene.settings.integrator = std::get<0>(GetParam());
    scene.settings.aovs.Add(scene::Aov::All);
    return cpu::Flatten(scene, scene.settings, scene.cameras[0]);
  }
};

TEST_P(Searches, FindWhatTheBvhFinds) {
  cpu::FlatScene scene = Flat();
  const bvh::Bvh bvh(scene.Geometry());
  const gpu::TraceArrays tree = gpu::ToTraceArrays(bvh, scene.Geometry());
  for (std::uint32_t sample = 0; sample < Samples; ++sample) {
    SCOPED_TRACE("sample " + std::to_string(sample));
    std::vector<kernel::AovSample> aovs;
    const std::vector<kernel::Spectrum> radiance = RenderByBvh(scene, bvh, sample, &aovs);
    const CountedSample plain = RenderByBruteForce(scene, sample);
    EXPECT_EQ(Difference("brute force", plain.radiance, "BVH", radiance, 64), "");
    EXPECT_EQ(Difference("brute force", plain.aovs, "BVH", aovs, 64), "");
    const CountedSample gpus = RenderByGpuSearch(scene, tree, sample);
    EXPECT_EQ(Difference("GPUs' search", gpus.radiance, "BVH", radiance, 64), "");
    EXPECT_EQ(Difference("GPUs' search", gpus.aovs, "BVH", aovs, 64), "");
  }
}

TEST_P(Searches, StayWithinTheLoopBudget) {
  cpu::FlatScene scene = Flat();
  const bvh::Bvh bvh(scene.Geometry());
  const gpu::TraceArrays tree = gpu::ToTraceArrays(bvh, scene.Geometry());
  for (std::uint32_t sample = 0; sample < Samples; ++sample) {
    const std::vector<std::uint32_t> loops = RenderByGpuSearch(scene, tree, sample).loops;
    for (auto group = loops.begin(); group != loops.end(); group += GroupSize) {
      const std::size_t pixel = std::size_t(group - loops.begin());
      ASSERT_LE(std::accumulate(group, group + GroupSize, 0u), LoopBudget)
          << "sample " << sample << " of the pixels from " << pixel % 64 << "," << pixel / 64;
      ASSERT_GT(*std::min_element(group, group + GroupSize), 0u) << "loops are not counted";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Whitted, Searches,
                         testing::Combine(testing::Values(scene::Integrator::Whitted),
                                          testing::ValuesIn(SceneNames())),
                         [](const auto& scene) { return std::get<1>(scene.param); });
INSTANTIATE_TEST_SUITE_P(Path, Searches,
                         testing::Combine(testing::Values(scene::Integrator::Path),
                                          testing::ValuesIn(SceneNames())),
                         [](const auto& scene) { return std::get<1>(scene.param); });

}  // namespace

}  // namespace snell::agree
