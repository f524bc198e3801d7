// SPDX-License-Identifier: Apache-2.0
//
// A primitive of a glTF mesh becomes a mesh of the scene: attributes, morph targets, skin, triangles.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/gltf/data.h"
#include "scene/scene.h"

namespace snell::io {

// How a mesh is bent at a moment: the weights of its morph targets, and for each joint of its skin the matrix from the
// mesh at rest to the world.
struct GltfDeformation {
  double time = 0;
  std::vector<double> weights;
  std::vector<glm::dmat4> joints;
};

// The mesh as it is at some moments, one at least. Nothing if there is nothing to show, which is noted. `triangleLimit` is how many it may have. Throws Error
// if indices or accessors are out of bounds.
std::optional<scene::Mesh> ReadGltfPrimitive(GltfData& data, const tinygltf::Primitive& primitive,
                                             std::span<const GltfDeformation> moments,
                                             std::size_t triangleLimit, const std::string& part);

// What is still to be done once triangles and attributes are there: drop triangles with undefined corners
// and vertices that are not used, and make normals and tangents of unit length. Nothing if no triangle is
// left.
std::optional<scene::Mesh> FinishGltfMesh(scene::Mesh mesh, GltfFindings& findings,
                                          const std::string& part);

// Bend the mesh at rest; if it changes from moment to moment, it gets keys.
class GltfAttributes;
void Bend(GltfData& data, const tinygltf::Primitive& primitive, GltfAttributes& attributes,
          std::span<const GltfDeformation> moments, scene::Mesh& mesh, const std::string& part);

}  // namespace snell::io
