// SPDX-License-Identifier: Apache-2.0
//
// Cuts the triangles of a mesh until no edge is longer than its target. Whether an edge is halved depends on
// its ends alone, which neighbours share even across seams: the mesh gets no cracks and no T-junctions.
#pragma once

#include <cstdint>

#include "scene/scene.h"
#include "tessellate/measure.h"

namespace snell::tessellate {

// Halve edges, round by round, as long as the mesh has no more than `mostTriangles`. False if that was too
// few. New vertices lie in the middle of edges and have the mean of what the ends have. Drops tangents.
bool Dice(scene::Mesh& mesh, const Measure& measure, const scene::EdgeTarget& target,
          std::uint64_t mostTriangles);

}  // namespace snell::tessellate
