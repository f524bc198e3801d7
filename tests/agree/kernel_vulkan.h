// SPDX-License-Identifier: Apache-2.0
//
// An integrator on a Vulkan device: src/gpu/shaders/whitted.comp or path.comp over the buffers of a flattened
// scene, one sample of every pixel a dispatch.
#pragma once

#include <vector>

#include "agree/vulkan.h"
#include "cpu/flatten.h"
#include "kernel/aov.h"

namespace snell::agree {

class KernelOnVulkan {
 public:
  // Compiles the shader, with NoContraction on its arithmetic. Throws Error, as all functions do.
  KernelOnVulkan(const VulkanDevice& device, scene::Integrator integrator);

  // Copy the scene to the device.
  void Upload(const cpu::FlatScene& scene);

  // Radiance of sample number `sample` of every pixel of the scene, row by row from the top.
  std::vector<kernel::Spectrum> Render(std::uint32_t sample);

  // What else the sample rendered last tells, if the scene asks for it.
  std::vector<kernel::AovSample> Aovs();

 private:
  const VulkanDevice& device_;
  VulkanProgram program_;
  std::vector<VulkanBuffer> buffers_;  // by binding
  kernel::uvec2 resolution_{0u, 0u};
  bool tellsMore_ = false;
};

}  // namespace snell::agree
