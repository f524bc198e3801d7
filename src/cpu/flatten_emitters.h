// SPDX-License-Identifier: Apache-2.0
//
// The triangles that glow, for the path tracer to sample in proportion to their power.
#pragma once

#include "cpu/flatten.h"

namespace snell::cpu {

// Fill the emitters from the objects and materials that are flat already. Those that only the camera sees light
// nothing.
void FlattenEmitters(FlatScene& flat);

}  // namespace snell::cpu
