// SPDX-License-Identifier: Apache-2.0
//
// The directional albedos that physical materials need (kernel/albedo.h), integrated once per process.
#pragma once

#include <vector>

namespace snell::cpu {

// AlbedoCount numbers. The first call takes a tenth of a second; the same numbers on every machine.
const std::vector<float>& AlbedoTables();

}  // namespace snell::cpu
