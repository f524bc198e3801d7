// SPDX-License-Identifier: Apache-2.0
#include "gpu/vulkan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

namespace snell::gpu {

void RequireSuccess(VkResult result, const char* call) {
  if (result == VK_SUCCESS) return;
  if (result == VK_ERROR_DEVICE_LOST)
    throw DeviceLost("the GPU was lost: its driver has stopped working", {},
                     "the system's log may say why; --device cpu does without");
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
    throw Error(fmt::format("the GPU has too little memory left ({})", call), {},
                "close what else uses it, or use --device cpu");
  throw Error(fmt::format("Vulkan: {} returned {}", call, int(result)));
}

std::optional<std::uint64_t> SimulatedFault(std::string_view name) {
  const char* const text = std::getenv("SNELL_GPU_FAULT");
  std::istringstream faults(text ? text : "");
  for (std::string fault; std::getline(faults, fault, ',');) {
    const std::size_t colon = std::min(fault.find(':'), fault.size());
    if (std::string_view(fault).substr(0, colon) != name) continue;
    return colon == fault.size() ? 1 : std::strtoull(fault.c_str() + colon + 1, nullptr, 10);
  }
  return std::nullopt;
}

}  // namespace snell::gpu
