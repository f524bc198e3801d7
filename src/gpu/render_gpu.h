// SPDX-License-Identifier: Apache-2.0
//
// A GPU as a device: the kernel as a shader, samples traced in short batches and added to the film by the host, so
// that checkpoints, layers and noise work as on the CPU.
#pragma once

#include "gpu/device.h"
#include "render/renderer.h"

namespace snell::gpu {

struct GpuOptions {
  std::string device = "gpu";  // as ChooseDevice takes it
  bool validate = false;       // by Vulkan's validation layer; what it finds are warnings
};

class GpuRenderer : public render::Renderer {
 public:
  // Opens the device. Throws Error if there is none.
  explicit GpuRenderer(const GpuOptions& options);

  const PhysicalDevice& physical() const { return device_.physical(); }

  // A fault of the device after the first batch throws nothing: it ends the render, and the film keeps what it has
  // (Statistics::fault).
  render::Statistics Render(const scene::Scene& scene, const render::RenderRequest& request,
                            render::Film& film, Progress* progress, const StopFlag* stop) override;

 private:
  VulkanInstance instance_;
  VulkanDevice device_;
};

}  // namespace snell::gpu
