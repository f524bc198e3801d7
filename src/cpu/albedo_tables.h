// SPDX-License-Identifier: Apache-2.0
//
// The directional albedos that physical materials need (kernel/albedo.h), integrated while Snell is built, and the
// wavelengths that paths choose.
#pragma once

#include <vector>

namespace snell::cpu {

// AlbedoCount numbers.
const std::vector<float>& AlbedoTables();

}  // namespace snell::cpu
