// SPDX-License-Identifier: Apache-2.0
//
// An integrator on a Vulkan device: the product's shader, made strict, over a scene, one sample of every pixel at a
// time.
#pragma once

#include <memory>
#include <vector>

#include "gpu/sample_tracer.h"
#include "kernel/aov.h"

namespace snell::agree {

// The first software device, whose arithmetic is the processor's; or one whose name contains the environment variable
// SNELL_VULKAN_DEVICE. Throws Error if there is no such device.
const gpu::PhysicalDevice& DeviceToCompare(const gpu::VulkanInstance& instance);

class KernelOnVulkan {
 public:
  // Compiles the shader. Throws Error, as all functions do.
  KernelOnVulkan(const gpu::VulkanDevice& device, scene::Integrator integrator);

  // Copy the scene to the device.
  void Upload(const cpu::FlatScene& scene, const gpu::TraceArrays& tree);

  // Radiance of sample number `sample` of every pixel of the scene, row by row from the top; what else it tells goes
  // to `aovs` if the scene asks for that.
  std::vector<kernel::Spectrum> Render(std::uint32_t sample, std::vector<kernel::AovSample>& aovs);

 private:
  const gpu::VulkanDevice& device_;
  gpu::VulkanProgram program_;
  std::unique_ptr<gpu::SampleTracer> tracer_;
  kernel::uvec2 resolution_{0u, 0u};
};

}  // namespace snell::agree
