// SPDX-License-Identifier: Apache-2.0
//
// The kernel as GLSL on Mesa's software Vulkan driver against the kernel as C++: the same bits in every pixel
// of every sample of every scene. On a GPU, whose division and square root need not be exact, only nearly the
// same picture. Without a device the tests are skipped, or fail if SNELL_REQUIRE_VULKAN is 1.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string_view>

#include "agree/bvh_reference.h"
#include "agree/difference.h"
#include "agree/kernel_vulkan.h"
#include "agree/scenes.h"

namespace snell::agree {

namespace {

constexpr std::uint32_t Samples = 4;

// Opens the device and compiles the shader once for all scenes.
class OnDevice : public testing::TestWithParam<std::string> {
 protected:
  static void Open(scene::Integrator integrator) {
    try {
      instance_ = std::make_unique<gpu::VulkanInstance>();
      device_ = std::make_unique<gpu::VulkanDevice>(*instance_, DeviceToCompare(*instance_));
    } catch (const Error& error) {
      whyNot_ = error.what();
      return;
    }
    kernel_ = std::make_unique<KernelOnVulkan>(*device_, integrator);
  }
  static void TearDownTestSuite() {
    kernel_.reset();
    device_.reset();
    instance_.reset();
  }

  void SetUp() override {
    if (!device_) {
      const char* required = std::getenv("SNELL_REQUIRE_VULKAN");
      if (required && std::string_view(required) == "1") FAIL() << whyNot_;
      GTEST_SKIP() << whyNot_;
    }
    ASSERT_TRUE(kernel_) << "the shader did not compile";
  }

  void ExpectTheCpusPicture(scene::Integrator integrator) const {
    scene::Scene source = SceneNamed(GetParam());
    source.settings.integrator = integrator;
    source.settings.aovs.Add(scene::Aov::All);
    cpu::FlatScene scene = cpu::Flatten(source, source.settings, source.cameras[0]);
    const bvh::Bvh bvh(scene.Geometry());
    kernel_->Upload(scene, gpu::ToTraceArrays(bvh, scene.Geometry()));
    const std::string name = device_->physical().name;
    for (std::uint32_t sample = 0; sample < Samples; ++sample) {
      SCOPED_TRACE("sample " + std::to_string(sample));
      std::vector<kernel::AovSample> aovs;
      const auto onCpu = RenderByBvh(scene, bvh, sample, &aovs);
      std::vector<kernel::AovSample> aovsOnDevice;
      const auto onDevice = kernel_->Render(sample, aovsOnDevice);
      EXPECT_EQ(CountNonFinite(onCpu), 0u);
      if (device_->physical().Software()) {
        EXPECT_EQ(Difference("CPU", onCpu, name.c_str(), onDevice, 64), "");
        EXPECT_EQ(Difference("CPU", aovs, name.c_str(), aovsOnDevice, 64), "");
      } else {
        EXPECT_EQ(DifferenceBeyondRounding(onCpu, onDevice), "") << name;
      }
    }
  }

  static inline std::unique_ptr<gpu::VulkanInstance> instance_;
  static inline std::unique_ptr<gpu::VulkanDevice> device_;
  static inline std::unique_ptr<KernelOnVulkan> kernel_;
  static inline std::string whyNot_;
};

class WhittedOnDevice : public OnDevice {
 protected:
  static void SetUpTestSuite() { Open(scene::Integrator::Whitted); }
};
class PathOnDevice : public OnDevice {
 protected:
  static void SetUpTestSuite() { Open(scene::Integrator::Path); }
};

TEST_P(WhittedOnDevice, GivesTheCpusPicture) { ExpectTheCpusPicture(scene::Integrator::Whitted); }
TEST_P(PathOnDevice, GivesTheCpusPicture) { ExpectTheCpusPicture(scene::Integrator::Path); }

INSTANTIATE_TEST_SUITE_P(Whitted, WhittedOnDevice, testing::ValuesIn(SceneNames()),
                         [](const auto& scene) { return scene.param; });
INSTANTIATE_TEST_SUITE_P(Path, PathOnDevice, testing::ValuesIn(SceneNames()),
                         [](const auto& scene) { return scene.param; });

}  // namespace

}  // namespace snell::agree
