// SPDX-License-Identifier: Apache-2.0
//
// A primitive of a glTF mesh becomes a mesh of the scene: attributes, morph targets, skin, triangles.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/gltf/data.h"
#include "scene/scene.h"

namespace snell::io {

// How a mesh is bent: the weights of its morph targets, and for each joint of its skin the matrix from the
// mesh at rest to the world.
struct GltfDeformation {
  std::vector<double> weights;
  std::vector<glm::dmat4> joints;
};

// Nothing if there is nothing to show, which is noted. `triangleLimit` is how many it may have. Throws Error
// if indices or accessors are out of bounds.
std::optional<scene::Mesh> ReadGltfPrimitive(GltfData& data, const tinygltf::Primitive& primitive,
                                             const GltfDeformation& deformation,
                                             std::size_t triangleLimit, const std::string& part);

// What is still to be done once triangles and attributes are there: drop triangles with undefined corners
// and vertices that are not used, and make normals and tangents of unit length. Nothing if no triangle is
// left.
std::optional<scene::Mesh> FinishGltfMesh(scene::Mesh mesh, GltfFindings& findings,
                                          const std::string& part);

// Bend the mesh.
void Morph(GltfData& data, const tinygltf::Primitive& primitive, const std::vector<double>& weights,
           scene::Mesh& mesh);
class GltfAttributes;
void Skin(GltfAttributes& attributes, const std::vector<glm::dmat4>& joints, scene::Mesh& mesh,
          GltfFindings& findings, const std::string& part);

}  // namespace snell::io
