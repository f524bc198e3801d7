// SPDX-License-Identifier: Apache-2.0
//
// Which of the devices to render on.
#pragma once

#include <string>

#include "gpu/instance.h"

namespace snell::gpu {

// False if the system has no GPU that is hardware for certain: then Vulkan, whose software drivers take their time to
// load, need not be asked.
bool MayHaveHardware();

// The best of the devices that can render, if there is one.
const PhysicalDevice* BestDevice(const VulkanInstance& instance, bool orSoftware);

// The device for a wish: "auto", the best that is hardware; "gpu", the best one; "gpu:N", number N of the
// instance's; else one whose name contains the wish. Throws Error if there is none, or if it lacks something.
const PhysicalDevice& ChooseDevice(const VulkanInstance& instance, const std::string& wish);

}  // namespace snell::gpu
