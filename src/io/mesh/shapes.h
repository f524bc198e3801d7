// SPDX-License-Identifier: Apache-2.0
//
// Meshes that change their shape, from files of the same faces: each file is a key.
#pragma once

#include "io/mesh/faces.h"
#include "io/mesh/readers.h"

namespace snell::io {

// Add the positions of another file to the faces. Throws Error if its faces connect other vertices.
void AddShape(FaceSet& faces, const MeshFile& file, const FaceSet& shape,
              const MeshFile& shapeFile);

// Make the keys of a mesh whole, which have times and positions alone: normals are made anew of the faces, smooth where
// the mesh's are. Then the first key takes the place of the mesh's own positions and normals.
void CompleteKeys(scene::Mesh& mesh);

}  // namespace snell::io
