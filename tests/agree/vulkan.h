// SPDX-License-Identifier: Apache-2.0
//
// As much of Vulkan 1.2 as it takes to run one compute shader: a device, buffers that the host can see, a
// program over them. The loader is opened at run time, so that a machine without one builds and runs the
// other tests. All functions throw Error with the call that failed.
#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace snell::agree {

// The functions that are used, loaded by name.
#define SNELL_VULKAN_FUNCTIONS(X)           \
  X(AllocateCommandBuffers)                 \
  X(AllocateDescriptorSets)                 \
  X(AllocateMemory)                         \
  X(BeginCommandBuffer)                     \
  X(BindBufferMemory)                       \
  X(CmdBindDescriptorSets)                  \
  X(CmdBindPipeline)                        \
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
  X(DestroyPipelineLayout)                  \
  X(DestroyShaderModule)                    \
  X(EndCommandBuffer)                       \
  X(EnumeratePhysicalDevices)               \
  X(FreeMemory)                             \
  X(GetBufferMemoryRequirements)            \
  X(GetDeviceQueue)                         \
  X(GetPhysicalDeviceFeatures2)             \
  X(GetPhysicalDeviceMemoryProperties)      \
  X(GetPhysicalDeviceProperties2)           \
  X(GetPhysicalDeviceQueueFamilyProperties) \
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

// Throw Error unless `call` succeeded.
void RequireSuccess(VkResult result, const char* call);

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

// One device and its queue for computing.
class VulkanDevice {
 public:
  // The first software device, whose arithmetic is the processor's; or any device whose name contains the
  // environment variable SNELL_VULKAN_DEVICE. Throws Error if there is no loader or no such device.
  VulkanDevice();
  VulkanDevice(const VulkanDevice&) = delete;
  VulkanDevice& operator=(const VulkanDevice&) = delete;

  // "llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6".
  const std::string& name() const { return name_; }
  // Whether it is a software device.
  bool software() const { return software_; }

  // For Buffer and Program.
  const VulkanFunctions& vk() const { return vk_; }
  VkDevice handle() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queueFamily() const { return queueFamily_; }
  // The index of a type of memory among `allowed` that the host sees without flushing.
  std::uint32_t HostMemoryType(std::uint32_t allowed) const;

 private:
  void CreateInstance(PFN_vkGetInstanceProcAddr getProcAddr);
  void ChooseDevice();
  void CreateDevice();

  VulkanFunctions vk_;
  std::string name_;
  bool software_ = false;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  std::uint32_t queueFamily_ = 0;
  VkQueue queue_ = VK_NULL_HANDLE;
  Cleanup cleanup_;
};

// Storage that shader and host share. Holds at least one byte, since Vulkan has no empty buffers.
class VulkanBuffer {
 public:
  // Uninitialised.
  VulkanBuffer(const VulkanDevice& device, std::size_t bytes);
  // A copy of `content`.
  VulkanBuffer(const VulkanDevice& device, std::span<const std::byte> content);

  std::byte* data() const { return data_; }
  VkBuffer handle() const { return buffer_; }

 private:
  VkBuffer buffer_ = VK_NULL_HANDLE;
  std::byte* data_ = nullptr;
  Cleanup cleanup_;
};

// A compute shader over storage buffers at the bindings 0, 1, … of set 0, with one 32-bit push constant.
class VulkanProgram {
 public:
  VulkanProgram(const VulkanDevice& device, std::span<const std::uint32_t> spirv,
                std::uint32_t bufferCount);
  VulkanProgram(const VulkanProgram&) = delete;
  VulkanProgram& operator=(const VulkanProgram&) = delete;

  // Use these buffers, one for each binding, from now on.
  void Bind(std::span<const VulkanBuffer> buffers);
  // Run groupsX × groupsY work groups and wait until what they wrote can be read.
  void Run(std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t pushConstant);

 private:
  void CreatePipeline(std::span<const std::uint32_t> spirv);
  void CreateDescriptorSet();
  void CreateCommands();

  const VulkanDevice& device_;
  std::uint32_t bufferCount_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  Cleanup cleanup_;
};

}  // namespace snell::agree
