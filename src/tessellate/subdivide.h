// SPDX-License-Identifier: Apache-2.0
//
// Subdivision surfaces by OpenSubdiv: a mesh is refined evenly and its vertices are moved to the limit surface
// (Catmull and Clark 1978; Loop 1987; creases: DeRose, Kass and Truong 1998). Texture coordinates and colours
// are interpolated face by face, so that their seams stay.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace snell::tessellate {

// How many triangles `levels` levels of subdivision make of a mesh.
std::uint64_t SubdividedTriangles(const scene::Mesh& mesh, const scene::Subdivision& subdivision,
                                  int levels);

// The mesh after so many levels, with the limit surface's normals. If its faces cannot be put together, for
// one because too many meet at a vertex, false: then `mesh` is as it was.
bool Subdivide(scene::Mesh& mesh, const scene::Subdivision& subdivision, int levels);

}  // namespace snell::tessellate
