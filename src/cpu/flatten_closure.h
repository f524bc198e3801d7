// SPDX-License-Identifier: Apache-2.0
//
// What the path tracer takes a classic material for: its diffuse terms together are the base's albedo, its strongest
// specular term tells the roughness, its reflectivity is that of a smooth metal or of a clear layer, its transparency is
// transmission.
#pragma once

#include "cpu/flatten.h"

namespace snell::cpu {

kernel::Physical ClosureOf(const scene::Material& classic);

// Give the classic materials' textures the roles that they have for the path tracer.
void FlattenClosureTextures(const scene::Scene& scene, FlatScene& flat);

}  // namespace snell::cpu
