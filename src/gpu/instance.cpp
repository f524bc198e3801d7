// SPDX-License-Identifier: Apache-2.0
#include "gpu/instance.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <string_view>

namespace snell::gpu {

namespace {

constexpr const char* ValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr std::size_t FindingsKept = 20;

// The loader under the names that Linux and macOS know it by; it stays open to the end of the program, since
// drivers leave threads and handlers behind.
PFN_vkGetInstanceProcAddr OpenLoader() {
  for (const char* name : {"libvulkan.so.1", "libvulkan.so", "libvulkan.1.dylib"}) {
    if (SimulatedFault("no-loader")) break;
    void* library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!library) continue;
    if (void* symbol = ::dlsym(library, "vkGetInstanceProcAddr"))
      return reinterpret_cast<PFN_vkGetInstanceProcAddr>(symbol);
  }
  throw Error("there is no Vulkan loader on this machine", {}, "Debian has it in libvulkan1");
}

bool HasValidationLayer(PFN_vkGetInstanceProcAddr getProcAddr) {
  const auto enumerate = reinterpret_cast<PFN_vkEnumerateInstanceLayerProperties>(
      getProcAddr(nullptr, "vkEnumerateInstanceLayerProperties"));
  std::uint32_t count = 0;
  if (enumerate(&count, nullptr) != VK_SUCCESS) return false;
  std::vector<VkLayerProperties> layers(count);
  if (enumerate(&count, layers.data()) != VK_SUCCESS) return false;
  return std::ranges::any_of(layers, [](const VkLayerProperties& layer) {
    return std::string_view(layer.layerName) == ValidationLayer;
  });
}

}  // namespace

struct VulkanInstance::Findings {
  std::mutex mutex;
  std::vector<std::string> texts;

  static VKAPI_ATTR VkBool32 VKAPI_CALL Add(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                            VkDebugUtilsMessageTypeFlagsEXT,
                                            const VkDebugUtilsMessengerCallbackDataEXT* data,
                                            void* self) {
    Findings& findings = *static_cast<Findings*>(self);
    const std::lock_guard lock(findings.mutex);
    if (findings.texts.size() < FindingsKept) findings.texts.emplace_back(data->pMessage);
    return VK_FALSE;
  }
};

const char* PhysicalDevice::TypeName() const {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return "software";
    default: return "other";
  }
}

VulkanInstance::VulkanInstance(bool validate) : findings_(std::make_shared<Findings>()) {
  const PFN_vkGetInstanceProcAddr getProcAddr = OpenLoader();
  if (validate && !HasValidationLayer(getProcAddr))
    throw Error("there is no Vulkan validation layer on this machine", {},
                "Debian has it in vulkan-validationlayers");
  Create(getProcAddr, validate);
  if (validate) ListenToFindings(getProcAddr);

  std::uint32_t count = 0;
  RequireSuccess(vk_.EnumeratePhysicalDevices(instance_, &count, nullptr),
                 "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> handles(count);
  RequireSuccess(vk_.EnumeratePhysicalDevices(instance_, &count, handles.data()),
                 "vkEnumeratePhysicalDevices");
  for (const VkPhysicalDevice handle : handles) devices_.push_back(Describe(handle));
}

void VulkanInstance::Create(PFN_vkGetInstanceProcAddr getProcAddr, bool validate) {
  auto application = VulkanRecord<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.pApplicationName = "snell";
  application.apiVersion = VK_API_VERSION_1_2;
  auto info = VulkanRecord<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  info.pApplicationInfo = &application;
  const char* const extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  if (validate) {
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &ValidationLayer;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
  }
  const auto create =
      reinterpret_cast<PFN_vkCreateInstance>(getProcAddr(nullptr, "vkCreateInstance"));
  const VkResult created = SimulatedFault("no-driver") ? VK_ERROR_INCOMPATIBLE_DRIVER
                                                       : create(&info, nullptr, &instance_);
  if (created == VK_ERROR_INCOMPATIBLE_DRIVER)
    throw Error("there is no Vulkan driver on this machine", {},
                "install that of the GPU's vendor; Debian has open ones in mesa-vulkan-drivers");
  RequireSuccess(created, "vkCreateInstance");

#define SNELL_LOAD(name) \
  vk_.name = reinterpret_cast<PFN_vk##name>(getProcAddr(instance_, "vk" #name));
  SNELL_VULKAN_FUNCTIONS(SNELL_LOAD)
#undef SNELL_LOAD
  cleanup_.Add([this] { vk_.DestroyInstance(instance_, nullptr); });
}

void VulkanInstance::ListenToFindings(PFN_vkGetInstanceProcAddr getProcAddr) {
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      getProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
      getProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
  auto info = VulkanRecord<VkDebugUtilsMessengerCreateInfoEXT>(
      VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
  info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                         VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = Findings::Add;
  info.pUserData = findings_.get();
  VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
  RequireSuccess(create(instance_, &info, nullptr, &messenger), "vkCreateDebugUtilsMessengerEXT");
  cleanup_.Add([=, this] { destroy(instance_, messenger, nullptr); });
}

std::vector<std::string> VulkanInstance::TakeFindings() {
  const std::lock_guard lock(findings_->mutex);
  return std::move(findings_->texts);
}

PhysicalDevice VulkanInstance::Describe(VkPhysicalDevice handle) const {
  auto driver = VulkanRecord<VkPhysicalDeviceDriverProperties>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
  auto properties =
      VulkanRecord<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
  properties.pNext = &driver;
  vk_.GetPhysicalDeviceProperties2(handle, &properties);
  PhysicalDevice device;
  device.handle = handle;
  device.name = properties.properties.deviceName;
  device.driver = driver.driverInfo;
  if (device.driver.empty()) device.driver = driver.driverName;
  device.type = properties.properties.deviceType;
  device.apiVersion = properties.properties.apiVersion;

  auto memory = VulkanRecord<VkPhysicalDeviceMemoryProperties2>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2);
  vk_.GetPhysicalDeviceMemoryProperties2(handle, &memory);
  for (std::uint32_t i = 0; i < memory.memoryProperties.memoryHeapCount; ++i) {
    const VkMemoryHeap& heap = memory.memoryProperties.memoryHeaps[i];
    if ((heap.flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0)
      device.memoryBytes = std::max<std::uint64_t>(device.memoryBytes, heap.size);
  }

  // What it lacks
  if (device.apiVersion < VK_API_VERSION_1_2) {
    device.missing.emplace_back("Vulkan 1.2");
    return device;
  }
  auto features12 = VulkanRecord<VkPhysicalDeviceVulkan12Features>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
  auto features =
      VulkanRecord<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
  features.pNext = &features12;
  vk_.GetPhysicalDeviceFeatures2(handle, &features);
  if (features12.scalarBlockLayout == VK_FALSE)
    device.missing.emplace_back("the scalar block layout");
  const VkPhysicalDeviceLimits& limits = properties.properties.limits;
  if (limits.maxPerStageDescriptorStorageBuffers < BufferCount ||
      limits.maxDescriptorSetStorageBuffers < BufferCount)
    device.missing.push_back(fmt::format("{} storage buffers", BufferCount));
  std::uint32_t count = 0;
  vk_.GetPhysicalDeviceQueueFamilyProperties(handle, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vk_.GetPhysicalDeviceQueueFamilyProperties(handle, &count, families.data());
  if (std::ranges::none_of(families, [](const VkQueueFamilyProperties& family) {
        return (family.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0;
      }))
    device.missing.emplace_back("a queue for computing");
  return device;
}

}  // namespace snell::gpu
