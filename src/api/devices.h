// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: the devices that it can render on. Installed as <snell/api/devices.h>.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../util/error.h"

namespace snell {

struct DeviceInfo {
  std::string wish;  // what RenderOptions::device calls it: "cpu", "gpu:0"
  std::string name;
  std::string type;  // "processor", "discrete", "integrated", "virtual", "software", "other"
  std::uint64_t memoryBytes = 0;     // 0: unknown
  std::string driver;                // of a GPU
  std::string vulkan;                // the version that it offers: "1.3.224"
  std::vector<std::string> missing;  // that rendering needs; empty: it can render
};

struct DeviceList {
  std::vector<DeviceInfo> devices;  // the processor first
  std::string noGpus;               // why GPUs cannot be listed; "" if they can
  std::string automatic;            // the wish of the device that "auto" takes
};

SNELL_EXPORT DeviceList Devices();

}  // namespace snell
