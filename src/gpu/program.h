// SPDX-License-Identifier: Apache-2.0
//
// Compute shaders: compiled programs, and the buffers that one run of them reads and writes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "gpu/pipeline_cache.h"
#include "scene/scene.h"

namespace snell::gpu {

using SpirvModule = std::vector<std::uint32_t>;

// The shader that this build was made with.
std::span<const std::uint32_t> ShaderOf(scene::Integrator integrator);

// The module with every result of floating-point arithmetic decorated as NoContraction, so that a compiler
// must not fuse or regroup operations: software devices then give the CPU's bits. Functions are left as they are.
SpirvModule WithNoContraction(std::span<const std::uint32_t> module);

// A shader over storage buffers at the bindings 0 … BufferCount−1 of set 0, with one 32-bit push constant.
class VulkanProgram {
 public:
  VulkanProgram(const VulkanDevice& device, std::span<const std::uint32_t> spirv,
                PipelineCache* cache);
  VulkanProgram(const VulkanProgram&) = delete;
  VulkanProgram& operator=(const VulkanProgram&) = delete;

  VkDescriptorSetLayout setLayout() const { return setLayout_; }
  // Record a run over `buffers` with so many work groups.
  void Record(VkCommandBuffer commands, VkDescriptorSet buffers, std::uint32_t groups,
              std::uint32_t pushConstant) const;

 private:
  const VulkanDevice& device_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  Cleanup cleanup_;
};

// Buffers, one for each binding of a program.
class BufferSet {
 public:
  BufferSet(const VulkanDevice& device, const VulkanProgram& program,
            std::span<const VkBuffer> buffers);
  VkDescriptorSet handle() const { return set_; }

 private:
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  Cleanup cleanup_;
};

}  // namespace snell::gpu
