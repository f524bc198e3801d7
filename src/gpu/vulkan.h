// SPDX-License-Identifier: Apache-2.0
//
// Vulkan's functions by name, its results as errors, and undoing in reverse: what the other files of this room
// stand on. The loader is opened at run time (instance.h); nothing links to it.
#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "util/error.h"

namespace snell::gpu {

// The functions that are used, loaded by name.
#define SNELL_VULKAN_FUNCTIONS(X)           \
  X(AllocateCommandBuffers)                 \
  X(AllocateDescriptorSets)                 \
  X(AllocateMemory)                         \
  X(BeginCommandBuffer)                     \
  X(BindBufferMemory)                       \
  X(CmdBindDescriptorSets)                  \
  X(CmdBindPipeline)                        \
  X(CmdCopyBuffer)                          \
  X(CmdDispatch)                            \
  X(CmdPipelineBarrier)                     \
  X(CmdPushConstants)                       \
  X(CreateBuffer)                           \
  X(CreateCommandPool)                      \
  X(CreateComputePipelines)                 \
  X(CreateDescriptorPool)                   \
  X(CreateDescriptorSetLayout)              \
  X(CreateDevice)                           \
  X(CreateFence)                            \
  X(CreatePipelineCache)                    \
  X(CreatePipelineLayout)                   \
  X(CreateShaderModule)                     \
  X(DestroyBuffer)                          \
  X(DestroyCommandPool)                     \
  X(DestroyDescriptorPool)                  \
  X(DestroyDescriptorSetLayout)             \
  X(DestroyDevice)                          \
  X(DestroyFence)                           \
  X(DestroyInstance)                        \
  X(DestroyPipeline)                        \
  X(DestroyPipelineCache)                   \
  X(DestroyPipelineLayout)                  \
  X(DestroyShaderModule)                    \
  X(DeviceWaitIdle)                         \
  X(EndCommandBuffer)                       \
  X(EnumerateDeviceExtensionProperties)     \
  X(EnumeratePhysicalDevices)               \
  X(FreeMemory)                             \
  X(GetBufferMemoryRequirements)            \
  X(GetDeviceQueue)                         \
  X(GetPhysicalDeviceFeatures2)             \
  X(GetPhysicalDeviceMemoryProperties2)     \
  X(GetPhysicalDeviceProperties2)           \
  X(GetPhysicalDeviceQueueFamilyProperties) \
  X(GetPipelineCacheData)                   \
  X(MapMemory)                              \
  X(QueueSubmit)                            \
  X(ResetFences)                            \
  X(UpdateDescriptorSets)                   \
  X(WaitForFences)

struct VulkanFunctions {
#define SNELL_DECLARE(name) PFN_vk##name name = nullptr;
  SNELL_VULKAN_FUNCTIONS(SNELL_DECLARE)
#undef SNELL_DECLARE
};

// A record of Vulkan's whose other members are zero.
template <class T>
T VulkanRecord(VkStructureType type) {
  T record{};
  record.sType = type;
  return record;
}

// The device or its driver has given up in the middle of work.
class DeviceLost : public Error {
 public:
  using Error::Error;
};

// Throw Error, DeviceLost where it is that, unless `call` succeeded.
void RequireSuccess(VkResult result, const char* call);

// Whether the environment variable SNELL_GPU_FAULT asks for a fault (docs/hacking.md): a list of names, with commas
// between them, some with a number, "lost:3", which is returned; 1 without.
std::optional<std::uint64_t> SimulatedFault(std::string_view name);

// Undoes what was done, last things first, also when a constructor throws half way.
class Cleanup {
 public:
  Cleanup() = default;
  Cleanup(Cleanup&&) = default;
  Cleanup& operator=(Cleanup&&) = delete;
  ~Cleanup() {
    for (; !steps_.empty(); steps_.pop_back()) steps_.back()();
  }
  void Add(std::function<void()> step) { steps_.push_back(std::move(step)); }

 private:
  std::vector<std::function<void()>> steps_;
};

}  // namespace snell::gpu
