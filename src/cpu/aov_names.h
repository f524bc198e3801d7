// SPDX-License-Identifier: Apache-2.0
//
// Names for the numbers of objects that samples tell.
#pragma once

#include "cpu/flatten.h"
#include "render/aov_film.h"

namespace snell::cpu {

// What has no name is called by its number: "object_3", "light_1", "material_0".
render::AovNames AovNamesOf(const scene::Scene& scene, const FlatScene& flat);

}  // namespace snell::cpu
