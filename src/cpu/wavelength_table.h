// SPDX-License-Identifier: Apache-2.0
//
// The wavelengths that paths choose where light is dispersed, as the kernel reads them (kernel/albedo.h).
#pragma once

#include <span>

namespace snell::cpu {

// Fill WavelengthNodes times four numbers. The mean of each weight over the nodes' linear interpolation is 1.
void FillWavelengthTable(std::span<float> table);

}  // namespace snell::cpu
