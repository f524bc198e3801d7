// SPDX-License-Identifier: Apache-2.0
//
// Finer meshes of meshes that change their shape: each of their keys is treated as a mesh of its own.
#pragma once

#include <functional>

#include "scene/scene.h"

namespace snell::tessellate {

// Let `change` act on the mesh as it is at each of its moments, and put the results together. False if it says so once, or
// if the results do not connect the same vertices: then `mesh` is as it was. Quadrilaterals are cut as at first.
bool ChangeAllKeys(scene::Mesh& mesh, const std::function<bool(scene::Mesh& mesh)>& change);

}  // namespace snell::tessellate
