// SPDX-License-Identifier: Apache-2.0
//
// Tangents for normal maps, by Mikkelsen's method (2008, "Simulation of wrinkled surfaces revisited", appendix
// A), in which most such maps are made: at a vertex, the directions of rising u of the triangles around it,
// projected onto the normal's plane and weighted by their angles. Mirrored uvs and corners that share no edge
// part: there the vertex becomes several.
#pragma once

#include "scene/scene.h"

namespace snell::tessellate {

// Gives tangents by the coordinates `uvSet` to a mesh that has these and normals. The triangles keep their
// order.
void MakeTangents(scene::Mesh& mesh, int uvSet);

}  // namespace snell::tessellate
