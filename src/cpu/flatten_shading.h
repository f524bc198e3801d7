// SPDX-License-Identifier: Apache-2.0
//
// The other half of flattening: textures, materials and lights.
#pragma once

#include "cpu/flatten.h"

namespace snell::cpu {

void FlattenMaterials(const scene::Scene& scene, FlatScene& flat);

// Append the lights, and shapes for those area lights that are to be seen.
void FlattenLights(const scene::Scene& scene, FlatScene& flat);

}  // namespace snell::cpu
