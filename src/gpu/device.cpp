// SPDX-License-Identifier: Apache-2.0
#include "gpu/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace snell::gpu {

namespace {

// Longer than any dispatch takes, on a busy machine and a software device too.
constexpr std::uint64_t TimeoutNanoseconds = 1200'000'000'000;

constexpr std::uint64_t StagingBytes = std::uint64_t(16) << 20;

}  // namespace

VulkanDevice::VulkanDevice(const VulkanInstance& instance, const PhysicalDevice& physical)
    : vk_(instance.vk()), physical_(physical) {
  auto properties =
      VulkanRecord<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
  vk_.GetPhysicalDeviceProperties2(physical_.handle, &properties);
  properties_ = properties.properties;

  // Find a queue for computing, best one that does nothing else for the screen
  std::uint32_t count = 0;
  vk_.GetPhysicalDeviceQueueFamilyProperties(physical_.handle, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vk_.GetPhysicalDeviceQueueFamilyProperties(physical_.handle, &count, families.data());
  bool found = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) continue;
    const bool alone = (families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) == 0;
    if (!found || alone) queueFamily_ = i;
    found = true;
    if (alone) break;
  }

  // See whether it tells how much memory is free
  count = 0;
  vk_.EnumerateDeviceExtensionProperties(physical_.handle, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vk_.EnumerateDeviceExtensionProperties(physical_.handle, nullptr, &count, extensions.data());
  tellsBudget_ = std::ranges::any_of(extensions, [](const VkExtensionProperties& extension) {
    return std::string_view(extension.extensionName) == VK_EXT_MEMORY_BUDGET_EXTENSION_NAME;
  });

  // The buffers have the layout of the C++ records
  auto features = VulkanRecord<VkPhysicalDeviceVulkan12Features>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
  features.scalarBlockLayout = VK_TRUE;
  const float priority = 1;
  auto queueInfo =
      VulkanRecord<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queueInfo.queueFamilyIndex = queueFamily_;
  queueInfo.queueCount = 1;
  queueInfo.pQueuePriorities = &priority;
  const char* const budget = VK_EXT_MEMORY_BUDGET_EXTENSION_NAME;
  auto info = VulkanRecord<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
  info.pNext = &features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queueInfo;
  info.enabledExtensionCount = tellsBudget_ ? 1 : 0;
  info.ppEnabledExtensionNames = &budget;
  RequireSuccess(vk_.CreateDevice(physical_.handle, &info, nullptr, &device_), "vkCreateDevice");
  cleanup_.Add([this] { vk_.DestroyDevice(device_, nullptr); });
  vk_.GetDeviceQueue(device_, queueFamily_, 0, &queue_);

  auto poolInfo = VulkanRecord<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  poolInfo.queueFamilyIndex = queueFamily_;
  RequireSuccess(vk_.CreateCommandPool(device_, &poolInfo, nullptr, &pool_), "vkCreateCommandPool");
  cleanup_.Add([this] { vk_.DestroyCommandPool(device_, pool_, nullptr); });
  cleanup_.Add([this] { vk_.DeviceWaitIdle(device_); });
}

VkCommandBuffer VulkanDevice::NewCommands() const {
  auto info =
      VulkanRecord<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  info.commandPool = pool_;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  RequireSuccess(vk_.AllocateCommandBuffers(device_, &info, &commands), "vkAllocateCommandBuffers");
  return commands;
}

VkFence VulkanDevice::NewFence() const {
  auto info = VulkanRecord<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
  VkFence fence = VK_NULL_HANDLE;
  RequireSuccess(vk_.CreateFence(device_, &info, nullptr, &fence), "vkCreateFence");
  cleanup_.Add([=, this] {
    vk_.DeviceWaitIdle(device_);
    vk_.DestroyFence(device_, fence, nullptr);
  });
  return fence;
}

void VulkanDevice::Submit(VkCommandBuffer commands, VkFence fence) const {
  auto submit = VulkanRecord<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  RequireSuccess(vk_.QueueSubmit(queue_, 1, &submit, fence), "vkQueueSubmit");
}

void VulkanDevice::Wait(VkFence fence) const {
  const VkResult waited = vk_.WaitForFences(device_, 1, &fence, VK_TRUE, TimeoutNanoseconds);
  RequireSuccess(waited == VK_TIMEOUT ? VK_ERROR_DEVICE_LOST : waited, "vkWaitForFences");
  RequireSuccess(vk_.ResetFences(device_, 1, &fence), "vkResetFences");
}

std::uint32_t VulkanDevice::MemoryType(std::uint32_t allowed, VkMemoryPropertyFlags needed,
                                       VkMemoryPropertyFlags wished) const {
  auto memory = VulkanRecord<VkPhysicalDeviceMemoryProperties2>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2);
  vk_.GetPhysicalDeviceMemoryProperties2(physical_.handle, &memory);
  for (const VkMemoryPropertyFlags flags : {needed | wished, needed}) {
    for (std::uint32_t i = 0; i < memory.memoryProperties.memoryTypeCount; ++i) {
      const bool fits = (memory.memoryProperties.memoryTypes[i].propertyFlags & flags) == flags;
      if (fits && (allowed >> i & 1u) != 0) return i;
    }
  }
  throw Error(fmt::format("Vulkan: {} has no memory that suits", physical_.name));
}

std::uint64_t VulkanDevice::AvailableBytes() const {
  if (SimulatedFault("memory")) return 4096;
  auto budget = VulkanRecord<VkPhysicalDeviceMemoryBudgetPropertiesEXT>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT);
  auto memory = VulkanRecord<VkPhysicalDeviceMemoryProperties2>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2);
  if (tellsBudget_) memory.pNext = &budget;
  vk_.GetPhysicalDeviceMemoryProperties2(physical_.handle, &memory);
  std::uint64_t available = 0;
  for (std::uint32_t i = 0; i < memory.memoryProperties.memoryHeapCount; ++i) {
    const VkMemoryHeap& heap = memory.memoryProperties.memoryHeaps[i];
    if ((heap.flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) == 0) continue;
    // Others than this program want some of it
    std::uint64_t here = heap.size - heap.size / 10;
    if (tellsBudget_)
      here = budget.heapBudget[i] - std::min(budget.heapBudget[i], budget.heapUsage[i]);
    available = std::max(available, here);
  }
  return available;
}

VulkanBuffer::VulkanBuffer(const VulkanDevice& device, std::uint64_t bytes, Memory memory) {
  const VulkanFunctions& vk = device.vk();
  const VkDevice handle = device.handle();
  auto info = VulkanRecord<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
  info.size = std::max<std::uint64_t>(bytes, 4);
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
               VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  RequireSuccess(vk.CreateBuffer(handle, &info, nullptr, &buffer_), "vkCreateBuffer");
  cleanup_.Add([&vk, handle, buffer = buffer_] { vk.DestroyBuffer(handle, buffer, nullptr); });

  // Give it memory of its own
  constexpr VkMemoryPropertyFlags Host =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  VkMemoryRequirements requirements;
  vk.GetBufferMemoryRequirements(handle, buffer_, &requirements);
  auto allocation = VulkanRecord<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
  allocation.allocationSize = requirements.size;
  allocation.memoryTypeIndex =
      device.MemoryType(requirements.memoryTypeBits, memory == Memory::Device ? 0 : Host,
                        memory == Memory::Device     ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
                        : memory == Memory::Readback ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT
                                                     : 0);
  VkDeviceMemory place = VK_NULL_HANDLE;
  RequireSuccess(vk.AllocateMemory(handle, &allocation, nullptr, &place), "vkAllocateMemory");
  cleanup_.Add([&vk, handle, place] { vk.FreeMemory(handle, place, nullptr); });
  RequireSuccess(vk.BindBufferMemory(handle, buffer_, place, 0), "vkBindBufferMemory");
  if (memory == Memory::Device) return;
  void* data = nullptr;
  RequireSuccess(vk.MapMemory(handle, place, 0, VK_WHOLE_SIZE, 0, &data), "vkMapMemory");
  data_ = static_cast<std::byte*>(data);
}

Uploader::Uploader(const VulkanDevice& device)
    : device_(device),
      staging_(device, StagingBytes, Memory::Upload),
      commands_(device.NewCommands()),
      fence_(device.NewFence()) {}

void Uploader::Copy(std::span<const std::byte> content, const VulkanBuffer& to) {
  const VulkanFunctions& vk = device_.vk();
  for (std::uint64_t done = 0; done < content.size(); done += StagingBytes) {
    const std::uint64_t size = std::min<std::uint64_t>(content.size() - done, StagingBytes);
    std::memcpy(staging_.data(), content.data() + done, size);
    auto begin =
        VulkanRecord<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    RequireSuccess(vk.BeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
    const VkBufferCopy region = {0, done, size};
    vk.CmdCopyBuffer(commands_, staging_.handle(), to.handle(), 1, &region);
    RequireSuccess(vk.EndCommandBuffer(commands_), "vkEndCommandBuffer");
    device_.Submit(commands_, fence_);
    device_.Wait(fence_);
  }
}

}  // namespace snell::gpu
