// SPDX-License-Identifier: Apache-2.0
#include "agree/kernel_vulkan.h"

#include <cstdlib>

#include "gpu/choose.h"

namespace snell::agree {

const gpu::PhysicalDevice& DeviceToCompare(const gpu::VulkanInstance& instance) {
  if (const char* wanted = std::getenv("SNELL_VULKAN_DEVICE"))
    return gpu::ChooseDevice(instance, wanted);
  for (const gpu::PhysicalDevice& device : instance.devices()) {
    if (device.Software() && device.Capable()) return device;
  }
  throw Error("there is no software Vulkan device on this machine", {},
              "Debian has one in mesa-vulkan-drivers");
}

KernelOnVulkan::KernelOnVulkan(const gpu::VulkanDevice& device, scene::Integrator integrator)
    : device_(device),
      program_(device, gpu::WithNoContraction(gpu::ShaderOf(integrator)), nullptr) {}

void KernelOnVulkan::Upload(const cpu::FlatScene& scene, const gpu::TraceArrays& tree) {
  resolution_ = scene.params.camera.resolution;
  tracer_ = std::make_unique<gpu::SampleTracer>(device_, program_, scene, tree,
                                                std::uint64_t(resolution_.x) * resolution_.y);
}

std::vector<kernel::Spectrum> KernelOnVulkan::Render(std::uint32_t sample,
                                                     std::vector<kernel::AovSample>& aovs) {
  std::vector<kernel::SampleRequest> requests;
  for (kernel::uint y = 0; y < resolution_.y; ++y) {
    for (kernel::uint x = 0; x < resolution_.x; ++x)
      requests.push_back({kernel::uvec2(x, y), sample});
  }
  tracer_->Start(0, requests);
  const gpu::SampleTracer::Results results = tracer_->Finish(0);
  std::vector<kernel::Spectrum> radiance;
  for (const kernel::SampleResult& result : results.samples) radiance.push_back(result.L);
  aovs.assign(results.aovs.begin(), results.aovs.end());
  return radiance;
}

}  // namespace snell::agree
