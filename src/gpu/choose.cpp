// SPDX-License-Identifier: Apache-2.0
#include "gpu/choose.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>

namespace snell::gpu {

namespace {

int RankOf(const PhysicalDevice& device) {
  switch (device.type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 4;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 3;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return 0;
    default: return 1;
  }
}

std::string LowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

const PhysicalDevice& RequireCapable(const PhysicalDevice& device) {
  if (!device.Capable())
    throw Error(fmt::format("the GPU '{}' lacks {}", device.name, fmt::join(device.missing, ", ")));
  return device;
}

}  // namespace

bool MayHaveHardware() {
#ifdef __linux__
  // Drivers work through one of these
  for (const char* node :
       {"/dev/dri", "/dev/nvidiactl", "/dev/dxg", "/dev/kgsl-3d0", "/dev/mali0"}) {
    std::error_code ignored;
    if (std::filesystem::exists(node, ignored)) return true;
  }
  return SimulatedFault("software-is-hardware").has_value();
#else
  return true;
#endif
}

const PhysicalDevice* BestDevice(const VulkanInstance& instance, bool orSoftware) {
  const PhysicalDevice* best = nullptr;
  for (const PhysicalDevice& device : instance.devices()) {
    const bool hardware = !device.Software() || SimulatedFault("software-is-hardware");
    if (!device.Capable() || !(hardware || orSoftware)) continue;
    if (!best || RankOf(device) > RankOf(*best)) best = &device;
  }
  return best;
}

const PhysicalDevice& ChooseDevice(const VulkanInstance& instance, const std::string& wish) {
  const std::vector<PhysicalDevice>& devices = instance.devices();
  if (wish == "auto" || wish == "gpu") {
    if (const PhysicalDevice* best = BestDevice(instance, wish == "gpu")) return *best;
    throw Error("there is no GPU that can render on this machine", {},
                "'snell devices' tells what is missing");
  }
  if (wish.starts_with("gpu:")) {
    std::size_t number = 0;
    const auto [end, fault] = std::from_chars(wish.data() + 4, wish.data() + wish.size(), number);
    if (fault == std::errc() && end == wish.data() + wish.size() && number < devices.size())
      return RequireCapable(devices[number]);
  } else {
    for (const PhysicalDevice& device : devices) {
      if (LowerCase(device.name).find(LowerCase(wish)) != std::string::npos)
        return RequireCapable(device);
    }
  }
  throw Error(fmt::format("there is no device '{}'", wish), {}, "'snell devices' lists them");
}

}  // namespace snell::gpu
