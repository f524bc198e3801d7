// SPDX-License-Identifier: Apache-2.0
#include "api/devices.h"

#include <fmt/format.h>

#include "bvh/instruction_set.h"
#include "gpu/choose.h"
#include "util/threads.h"
#include "util/timer.h"

namespace snell {

DeviceList Devices() {
  DeviceList list;
  list.devices.push_back(
      {"cpu",
       fmt::format("{} threads, {}", HardwareThreads(), bvh::NameOf(bvh::BestInstructionSet())),
       "processor",
       AvailableMemoryBytes(),
       {},
       {},
       {}});
  list.automatic = "cpu";
  try {
    const gpu::VulkanInstance instance;
    for (const gpu::PhysicalDevice& device : instance.devices()) {
      list.devices.push_back({fmt::format("gpu:{}", list.devices.size() - 1), device.name,
                              device.TypeName(), device.memoryBytes, device.driver,
                              fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(device.apiVersion),
                                          VK_API_VERSION_MINOR(device.apiVersion),
                                          VK_API_VERSION_PATCH(device.apiVersion)),
                              device.missing});
    }
    if (const gpu::PhysicalDevice* best = gpu::BestDevice(instance, false))
      list.automatic = fmt::format("gpu:{}", best - instance.devices().data());
  } catch (const Error& error) {
    list.noGpus = error.what();
  }
  return list;
}

}  // namespace snell
