// SPDX-License-Identifier: Apache-2.0
//
// Where a render runs: the list of devices, a GPU's picture, and what happens when a GPU is missing or fails. Without a
// software Vulkan device only what needs none is tested.
#include <cstdlib>

#include "api/snell.h"
#include "scratch.h"

namespace snell::test {
namespace {

// Simulated faults of GPUs for the programs that are started while it lives.
class GpuFault {
 public:
  explicit GpuFault(const char* name) { ::setenv("SNELL_GPU_FAULT", name, 1); }
  ~GpuFault() { ::unsetenv("SNELL_GPU_FAULT"); }
};

class OnDevices : public InScratchFolder {
 protected:
  OnDevices() {
    Write("spheres.nff", SpheresScene());
    // A cache of the tests' own, while the driver keeps its one
    const char* const home = std::getenv("HOME");
    if (home) ::setenv("MESA_SHADER_CACHE_DIR", (std::string(home) + "/.cache").c_str(), 0);
    ::setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
  }
  ~OnDevices() override { ::unsetenv("XDG_CACHE_HOME"); }

  // The driver takes longer to compile the shader than a program of the tests may run; it keeps what it has compiled.
  static void CompileOnce() {
    static const bool compiled = [] {
      const ScratchFolder folder;
      folder.Write("spheres.nff", SpheresScene());
      RenderOptions options;
      options.spp = 1;
      options.device = "gpu";
      snell::Render(LoadScene(folder.Path("spheres.nff")), options);
      return true;
    }();
    EXPECT_TRUE(compiled);
  }
  static bool HasSoftwareGpu() {
    for (const DeviceInfo& device : Devices().devices) {
      if (device.type == "software" && device.missing.empty()) return true;
    }
    return false;
  }
  Result RenderOn(const std::string& device, const std::string& output,
                  const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"render", "spheres.nff", "--spp",    "4",
                                      "-o",     output,        "--device", device};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }
  void ExpectSamePictures(const std::string& a, const std::string& b) const {
    EXPECT_EQ(Run({"compare", a, b, "--metric", "max", "--tolerance", "0"}).status, 0);
  }
};

TEST_F(OnDevices, AreListedWithTheProcessorFirst) {
  const Result result = Run({"devices"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find(" cpu    processor "), std::string::npos) << result.out;
  EXPECT_NE(Run({"devices", "--json"}).out.find("\"device\": \"cpu\""), std::string::npos);
}

TEST_F(OnDevices, AMissingLoaderOrDriverIsAnErrorOnlyIfAGpuIsAskedFor) {
  for (const auto& [fault, message] :
       {std::pair("no-loader", "there is no Vulkan loader on this machine"),
        std::pair("no-driver", "there is no Vulkan driver on this machine")}) {
    const GpuFault simulated(fault);
    const Result result = RenderOn("gpu", "a.exr");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(RenderOn("auto", "b.exr").status, 0);
    EXPECT_NE(Run({"devices"}).out.find(message), std::string::npos);
    if (std::string(fault) == "no-driver" && !HasSoftwareGpu()) break;
  }
}

TEST_F(OnDevices, AnUnknownDeviceIsAnError) {
  if (!HasSoftwareGpu()) GTEST_SKIP() << "there is no software Vulkan device";
  const Result result = RenderOn("Voodoo", "a.exr");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("there is no device 'Voodoo'; 'snell devices' lists them"),
            std::string::npos)
      << result.err;
}

TEST_F(OnDevices, SoftwareGivesTheProcessorsPicture) {
  if (!HasSoftwareGpu()) GTEST_SKIP() << "there is no software Vulkan device";
  CompileOnce();
  RenderOn("cpu", "cpu.exr", {"--float"});
  const Result result = RenderOn("gpu", "gpu.exr", {"--float"});
  EXPECT_EQ(result.status, 0) << result.err;
  ExpectSamePictures("cpu.exr", "gpu.exr");
}

TEST_F(OnDevices, ALostDeviceLeavesPictureAndCheckpoint) {
  if (!HasSoftwareGpu()) GTEST_SKIP() << "there is no software Vulkan device";
  CompileOnce();
  RenderOn("cpu", "cpu.exr", {"--float"});
  {
    const GpuFault simulated("lost:2");
    const Result result = RenderOn("gpu", "gpu.exr", {"--float"});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("the GPU was lost"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("--resume goes on with it"), std::string::npos) << result.err;
  }
  EXPECT_EQ(RenderOn("cpu", "gpu.exr", {"--float", "--resume"}).status, 0);
  ExpectSamePictures("cpu.exr", "gpu.exr");
}

TEST_F(OnDevices, AutomaticallyTheProcessorGoesOn) {
  if (!HasSoftwareGpu()) GTEST_SKIP() << "there is no software Vulkan device";
  CompileOnce();
  RenderOn("cpu", "cpu.exr", {"--float"});
  for (const auto& [fault, message] :
       {std::pair("software-is-hardware,lost:2", "the GPU was lost"),
        std::pair("software-is-hardware,memory", "of memory on the GPU")}) {
    const GpuFault simulated(fault);
    const Result result = RenderOn("auto", "auto.exr", {"--float"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("the processor has rendered instead"), std::string::npos);
    ExpectSamePictures("cpu.exr", "auto.exr");
  }
}

TEST_F(OnDevices, ADamagedCacheOfShadersIsMadeAnew) {
  if (!HasSoftwareGpu()) GTEST_SKIP() << "there is no software Vulkan device";
  CompileOnce();
  ASSERT_EQ(RenderOn("gpu", "a.exr").status, 0);
  std::string name;
  for (const auto& file : std::filesystem::directory_iterator(folder_ / "snell"))
    name = "snell/" + file.path().filename().string();
  ASSERT_NE(name, "") << "no cache was written";
  Write(name, "rubbish");
  const Result damaged = RenderOn("gpu", "b.exr");
  EXPECT_EQ(damaged.status, 0);
  EXPECT_NE(damaged.err.find("the cache of compiled shaders is damaged"), std::string::npos);
  EXPECT_EQ(RenderOn("gpu", "c.exr").err.find("damaged"), std::string::npos);
}

}  // namespace
}  // namespace snell::test
