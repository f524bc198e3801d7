// SPDX-License-Identifier: Apache-2.0
//
// Vertex normals for meshes that come without. The normal at a corner is the sum of the normals of the
// faces around the vertex that differ from the corner's own face by no more than the crease angle, each
// weighted by the angle of its corner (Thürmer and Wüthrich 1998, "Computing vertex normals from polygonal
// facets"), so that it does not depend on how polygons were cut into triangles.
#pragma once

#include <cstdint>
#include <span>

#include "scene/scene.h"

namespace snell::io {

// What a file says of a triangle: nothing, that it is flat, or otherwise the number of the smoothing group
// within which it is smooth at any angle.
inline constexpr std::uint32_t SmoothByAngle = 0xffffffffu;
inline constexpr std::uint32_t SmoothNever = 0;

// Whether any triangle has an area, and by it a normal.
bool HasArea(const scene::Mesh& mesh);

// Replace the mesh's normals. Faces that meet at more than `creaseDegrees` share no vertex afterwards;
// those that meet at less share one if their uvs agree. Vertices count as one where their positions are
// equal, so that a seam between uvs does not show. Vertices that no triangle uses are dropped. With 0 or
// less the mesh becomes flat: its normals are removed. Takes nearly linear time for any mesh, because of
// more than 64 faces around a vertex those of nearly the same direction act as one; gives the same result
// at any number of threads. `smoothing` has a word for each triangle, or is empty; triangles of different
// words do not smooth each other. The triangles keep their order.
void SmoothNormals(scene::Mesh& mesh, float creaseDegrees,
                   std::span<const std::uint32_t> smoothing = {});

// Give normals to the triangles that lack some (have zero as a normal) in a mesh with others that are
// complete; flat ones where the angle is 0 or less. If no triangle is complete, removes the normals.
void CompleteNormals(scene::Mesh& mesh, float creaseDegrees,
                     std::span<const std::uint32_t> smoothing = {});

}  // namespace snell::io
