// SPDX-License-Identifier: Apache-2.0
//
// Moves a mesh's vertices along their smooth normals by a texture of heights. Vertices at one place, which
// seams of uvs and hard edges part, move as one, by their mean height along their mean normal: closed
// surfaces stay closed. The new normals are those of the moved triangles, smooth where the old ones were.
#pragma once

#include <functional>

#include "scene/scene.h"
#include "tessellate/measure.h"

namespace snell::tessellate {

// The height at a vertex in metres, averaged over `width` of uv space.
using Height = std::function<float(std::size_t vertex, float width)>;

// `uvSet` says by which coordinates the width is measured. Heights that are not finite count as 0. Drops
// tangents.
void Displace(scene::Mesh& mesh, const Measure& measure, int uvSet, const Height& height);

}  // namespace snell::tessellate
