// SPDX-License-Identifier: Apache-2.0
//
// Opening a device (vulkan.h): loader, instance, physical device, queue.
#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>

#include "agree/vulkan.h"
#include "util/error.h"

namespace snell::agree {

namespace {

constexpr const char* DriverHint = "Debian has a software driver in mesa-vulkan-drivers";

// The loader under the names that Linux and macOS know it by; it stays open to the end of the program, since
// drivers leave threads and handlers behind.
PFN_vkGetInstanceProcAddr OpenLoader() {
  for (const char* name : {"libvulkan.so.1", "libvulkan.so", "libvulkan.1.dylib"}) {
    void* library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!library) continue;
    if (void* symbol = ::dlsym(library, "vkGetInstanceProcAddr"))
      return reinterpret_cast<PFN_vkGetInstanceProcAddr>(symbol);
  }
  throw Error("there is no Vulkan loader on this machine", {}, "Debian has it in libvulkan1");
}

}  // namespace

void RequireSuccess(VkResult result, const char* call) {
  if (result != VK_SUCCESS) throw Error(fmt::format("Vulkan: {} returned {}", call, int(result)));
}

VulkanDevice::VulkanDevice() {
  CreateInstance(OpenLoader());
  ChooseDevice();
  CreateDevice();
}

void VulkanDevice::CreateInstance(PFN_vkGetInstanceProcAddr getProcAddr) {
  auto application = VulkanRecord<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.pApplicationName = "snell";
  application.apiVersion = VK_API_VERSION_1_2;
  auto info = VulkanRecord<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  info.pApplicationInfo = &application;
  const auto create =
      reinterpret_cast<PFN_vkCreateInstance>(getProcAddr(nullptr, "vkCreateInstance"));
  const VkResult created = create(&info, nullptr, &instance_);
  if (created == VK_ERROR_INCOMPATIBLE_DRIVER)
    throw Error("there is no Vulkan driver on this machine", {}, DriverHint);
  RequireSuccess(created, "vkCreateInstance");

#define SNELL_LOAD(name) \
  vk_.name = reinterpret_cast<PFN_vk##name>(getProcAddr(instance_, "vk" #name));
  SNELL_VULKAN_FUNCTIONS(SNELL_LOAD)
#undef SNELL_LOAD
  cleanup_.Add([this] { vk_.DestroyInstance(instance_, nullptr); });
}

void VulkanDevice::ChooseDevice() {
  std::uint32_t count = 0;
  RequireSuccess(vk_.EnumeratePhysicalDevices(instance_, &count, nullptr),
                 "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> devices(count);
  RequireSuccess(vk_.EnumeratePhysicalDevices(instance_, &count, devices.data()),
                 "vkEnumeratePhysicalDevices");

  // Take the first that fits, and remember the names of the others for the message
  const char* wanted = std::getenv("SNELL_VULKAN_DEVICE");
  std::string others;
  for (const VkPhysicalDevice device : devices) {
    auto driver = VulkanRecord<VkPhysicalDeviceDriverProperties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    auto properties =
        VulkanRecord<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    properties.pNext = &driver;
    vk_.GetPhysicalDeviceProperties2(device, &properties);
    software_ = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    name_ = fmt::format("{}, {}", properties.properties.deviceName, driver.driverInfo);
    const bool fits = wanted ? name_.find(wanted) != std::string::npos : software_;
    if (fits && properties.properties.apiVersion >= VK_API_VERSION_1_2) {
      physical_ = device;
      return;
    }
    others += fmt::format("{}'{}'", others.empty() ? "" : ", ", name_);
  }
  throw Error(wanted ? fmt::format("no Vulkan 1.2 device is called '{}'", wanted)
                     : "there is no software Vulkan 1.2 device on this machine",
              {}, others.empty() ? DriverHint : "there is " + others);
}

void VulkanDevice::CreateDevice() {
  // Find a queue for computing
  std::uint32_t count = 0;
  vk_.GetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vk_.GetPhysicalDeviceQueueFamilyProperties(physical_, &count, families.data());
  while (queueFamily_ < count && !(families[queueFamily_].queueFlags & VK_QUEUE_COMPUTE_BIT))
    ++queueFamily_;
  if (queueFamily_ == count) throw Error(fmt::format("Vulkan: {} cannot compute", name_));

  // The buffers have the layout of the C++ records
  auto features12 = VulkanRecord<VkPhysicalDeviceVulkan12Features>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
  auto features =
      VulkanRecord<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
  features.pNext = &features12;
  vk_.GetPhysicalDeviceFeatures2(physical_, &features);
  if (features12.scalarBlockLayout == VK_FALSE)
    throw Error(fmt::format("Vulkan: {} lacks the scalar block layout", name_));
  features12 = VulkanRecord<VkPhysicalDeviceVulkan12Features>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
  features12.scalarBlockLayout = VK_TRUE;

  const float priority = 1;
  auto queueInfo =
      VulkanRecord<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queueInfo.queueFamilyIndex = queueFamily_;
  queueInfo.queueCount = 1;
  queueInfo.pQueuePriorities = &priority;
  auto info = VulkanRecord<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
  info.pNext = &features12;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queueInfo;
  RequireSuccess(vk_.CreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
  cleanup_.Add([this] { vk_.DestroyDevice(device_, nullptr); });
  vk_.GetDeviceQueue(device_, queueFamily_, 0, &queue_);
}

std::uint32_t VulkanDevice::HostMemoryType(std::uint32_t allowed) const {
  VkPhysicalDeviceMemoryProperties properties;
  vk_.GetPhysicalDeviceMemoryProperties(physical_, &properties);
  const VkMemoryPropertyFlags needed =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i) {
    const bool fits = (properties.memoryTypes[i].propertyFlags & needed) == needed;
    if (fits && (allowed >> i & 1u) != 0) return i;
  }
  throw Error(fmt::format("Vulkan: {} has no memory that the host sees", name_));
}

}  // namespace snell::agree
