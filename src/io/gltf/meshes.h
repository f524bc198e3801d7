// SPDX-License-Identifier: Apache-2.0
//
// The meshes of a glTF document in the scene: each primitive once, however many nodes show it; once more
// for each node that bends it.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "io/gltf/data.h"
#include "io/gltf/nodes.h"
#include "io/gltf/primitive.h"
#include "scene/scene.h"

namespace snell::io {

class GltfMeshes {
 public:
  // `variant` is the name of the materials' variant to show, empty for the default. Throws Error if there is
  // none.
  GltfMeshes(GltfData& data, scene::Scene& scene, const std::string& variant);

  struct Part {
    scene::MeshIndex mesh = -1;
    int material = -1;  // glTF's
  };
  // The parts that a node shows, as they are at some moments. `isSkinned` says whether they are in the world already.
  std::vector<Part> Of(int node, const GltfNodes& nodes, std::span<const GltfMoment> moments,
                       bool& isSkinned);

 private:
  using Joints = std::vector<std::vector<glm::dmat4>>;  // of the joints, for each moment
  const Joints& JointsOf(int skin, const GltfNodes& nodes, std::span<const GltfMoment> moments);
  std::vector<Part> Read(int mesh, std::span<const GltfDeformation> moments);

  int MaterialOf(const tinygltf::Primitive& primitive) const;

  GltfData& data_;
  scene::Scene& scene_;
  std::map<int, std::vector<Part>> shared_;  // by glTF's mesh
  std::map<int, Joints> joints_;             // by glTF's skin
  std::size_t triangles_ = 0;
  int variant_ = -1;
};

}  // namespace snell::io
