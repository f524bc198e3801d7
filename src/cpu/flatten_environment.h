// SPDX-License-Identifier: Apache-2.0
//
// The background: its gradient, or its map with the tables from which directions are sampled, and the directional
// lights that have a disc in the sky.
#pragma once

#include "cpu/flatten.h"

namespace snell::cpu {

// Fill the environment when pictures, lights and emitters are flat already. Throws Error if a map has more texels than
// the kernel can number.
void FlattenEnvironment(const scene::Environment& environment, FlatScene& flat);

}  // namespace snell::cpu
