// SPDX-License-Identifier: Apache-2.0
//
// One device with its queue for computing, and memory on it.
#pragma once

#include <cstddef>
#include <span>

#include "gpu/instance.h"

namespace snell::gpu {

class VulkanDevice {
 public:
  // `physical` is Capable and one of the instance's, which must outlive the device. Throws Error.
  VulkanDevice(const VulkanInstance& instance, const PhysicalDevice& physical);
  VulkanDevice(const VulkanDevice&) = delete;
  VulkanDevice& operator=(const VulkanDevice&) = delete;

  const PhysicalDevice& physical() const { return physical_; }
  const VkPhysicalDeviceProperties& properties() const { return properties_; }
  const VulkanFunctions& vk() const { return vk_; }
  VkDevice handle() const { return device_; }

  // A command buffer of its own pool, and a fence; they live as long as the device.
  VkCommandBuffer NewCommands() const;
  VkFence NewFence() const;
  // Hand in what was recorded, and wait until it is done. Throws DeviceLost.
  void Submit(VkCommandBuffer commands, VkFence fence) const;
  void Wait(VkFence fence) const;

  // The index of a type of memory among `allowed` with all of `needed`, and `wished` if possible.
  std::uint32_t MemoryType(std::uint32_t allowed, VkMemoryPropertyFlags needed,
                           VkMemoryPropertyFlags wished) const;
  // Bytes that can still be taken for buffers, about.
  std::uint64_t AvailableBytes() const;

 private:
  const VulkanFunctions& vk_;
  PhysicalDevice physical_;
  VkPhysicalDeviceProperties properties_;
  bool tellsBudget_ = false;
  VkDevice device_ = VK_NULL_HANDLE;
  std::uint32_t queueFamily_ = 0;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  mutable Cleanup cleanup_;
};

// Where a buffer lies, and who reaches it.
enum class Memory {
  Device,    // fast for shaders; copies lead in and out
  Upload,    // written by the host
  Readback,  // read by the host
};

// Storage; holds at least one byte, since Vulkan has no empty buffers.
class VulkanBuffer {
 public:
  VulkanBuffer(const VulkanDevice& device, std::uint64_t bytes, Memory memory);

  std::byte* data() const { return data_; }  // none on the device
  VkBuffer handle() const { return buffer_; }

 private:
  VkBuffer buffer_ = VK_NULL_HANDLE;
  std::byte* data_ = nullptr;
  Cleanup cleanup_;
};

// Copies arrays into buffers on the device, part by part.
class Uploader {
 public:
  explicit Uploader(const VulkanDevice& device);
  void Copy(std::span<const std::byte> content, const VulkanBuffer& to);

 private:
  const VulkanDevice& device_;
  VulkanBuffer staging_;
  VkCommandBuffer commands_;
  VkFence fence_;
};

}  // namespace snell::gpu
