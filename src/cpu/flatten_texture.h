// SPDX-License-Identifier: Apache-2.0
//
// Flattening of textures and of the pictures that they show, with their levels of detail.
#pragma once

#include "cpu/flatten.h"

namespace snell::cpu {

// Throws Error if the pictures have more texels than the kernel can number.
void FlattenTextures(const scene::Scene& scene, FlatScene& flat);

}  // namespace snell::cpu
