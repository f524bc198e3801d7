// SPDX-License-Identifier: Apache-2.0
//
// The geometric half of flattening: objects, shapes, meshes and instances.
#pragma once

#include "cpu/flatten.h"
#include "cpu/flatten_motion.h"
#include "tessellate/tessellate.h"

namespace snell::cpu {

// Append the scene's objects with their shapes, meshes and instances. Triangles in world space must come
// first: those of lights are there already.
// What clear objects do to shadow rays: block them, tint them as if they went straight on, or, as the path tracer
// wants it, let those pass that do go straight on, through smooth thin sheets.
enum class ShadowRays { Opaque, Tinted, Path };

void FlattenObjects(const scene::Scene& scene, const tessellate::FinerMeshes& finer,
                    ShadowRays shadowRays, const Shutter& shutter, FlatScene& flat);

// Append a mesh's vertices and triangles as seen through `toWorld`, or in its own space if that is null. The keys of one
// that changes its shape are at even steps (scene/deformation.h); it stays in its own space.
// Returns the index of its first triangle.
kernel::uint AppendMesh(const scene::Mesh& mesh, const scene::Affine* toWorld, kernel::uint object,
                        FlatScene& flat);

// The kernel's form of an analytic shape; `geometry` must not be a mesh.
kernel::Shape FlattenShape(const scene::Geometry& geometry, const scene::Affine& toWorld,
                           kernel::uint object);

}  // namespace snell::cpu
