// SPDX-License-Identifier: Apache-2.0
//
// Meshes that change their shape: their vertices at a moment, and at even steps while a shutter is open.
#pragma once

#include "scene/scene.h"

namespace snell::scene {

// The mesh as it is from `open` to `close`: with keys at even steps, the first and the last at these times, or without
// any if it keeps its shape meanwhile. Keys of the mesh's own lie on the steps if 64 suffice.
Mesh ShapeDuring(const Mesh& mesh, double open, double close);

}  // namespace snell::scene
