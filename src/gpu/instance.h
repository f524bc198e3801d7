// SPDX-License-Identifier: Apache-2.0
//
// Vulkan itself: the loader, opened at run time, the validation layer if it is asked for, and the devices that there
// are, with what each lacks.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace snell::gpu {

// Storage buffers that the shaders bind (shaders/buffers.glsl).
inline constexpr std::uint32_t BufferCount = 31;

// A device as it presents itself.
struct PhysicalDevice {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  std::string name;
  std::string driver;  // "Mesa 22.3.6"
  VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  std::uint32_t apiVersion = 0;
  std::uint64_t memoryBytes = 0;     // of its own, or that it shares with the processor
  std::vector<std::string> missing;  // that Snell needs; empty: it can render

  bool Software() const { return type == VK_PHYSICAL_DEVICE_TYPE_CPU; }
  bool Capable() const { return missing.empty(); }
  const char* TypeName() const;  // "discrete", "integrated", "virtual", "software", "other"
};

class VulkanInstance {
 public:
  // Throws Error if there is no loader or no driver, or, for `validate`, no validation layer.
  explicit VulkanInstance(bool validate = false);
  VulkanInstance(const VulkanInstance&) = delete;
  VulkanInstance& operator=(const VulkanInstance&) = delete;

  const VulkanFunctions& vk() const { return vk_; }
  // In the driver's order.
  const std::vector<PhysicalDevice>& devices() const { return devices_; }
  // What the validation layer has found so far.
  std::vector<std::string> TakeFindings();

 private:
  struct Findings;

  void Create(PFN_vkGetInstanceProcAddr getProcAddr, bool validate);
  void ListenToFindings(PFN_vkGetInstanceProcAddr getProcAddr);
  PhysicalDevice Describe(VkPhysicalDevice handle) const;

  VulkanFunctions vk_;
  VkInstance instance_ = VK_NULL_HANDLE;
  std::vector<PhysicalDevice> devices_;
  std::shared_ptr<Findings> findings_;
  Cleanup cleanup_;
};

}  // namespace snell::gpu
