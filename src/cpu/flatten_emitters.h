// SPDX-License-Identifier: Apache-2.0
//
// What glows, for the path tracer to sample: triangles of meshes and instances, and of the analytic shapes spheres,
// disks and rectangles. The light tree (flatten_light_tree.h) says how likely.
#pragma once

#include "cpu/flatten.h"

namespace snell::cpu {

// Fill the emitters, one for each primitive of an object that glows, from the objects and materials that are flat
// already. Those that cannot be sampled have no area.
void FlattenEmitters(FlatScene& flat);

}  // namespace snell::cpu
