// SPDX-License-Identifier: Apache-2.0
//
// glTF's tree of nodes: where each one is in the world, at rest or at a moment of its animations.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/gltf/data.h"

namespace snell::io {

// A node's properties that may be animated.
struct GltfNodeState {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1, 0, 0, 0};  // w first
  glm::dvec3 scale{1.0};
  std::optional<glm::dmat4> matrix;  // instead of the three above
  std::vector<double> weights;       // of morph targets; empty: the mesh's own
};

// The nodes at a moment: where they are in the world, and the weights of their morph targets.
struct GltfMoment {
  double time = 0;
  std::vector<glm::dmat4> worlds;
  std::vector<std::vector<double>> weights;
};

class GltfNodes {
 public:
  // Throws Error if a node is its own ancestor. `time` in seconds moves what animations
  // move. `scene` is the name of the one to show, empty for the default. Throws Error if there is none.
  GltfNodes(GltfData& data, std::optional<double> time, const std::string& scene);

  // The nodes of the scene to show, parents first: the default scene, else the first, else all nodes.
  const std::vector<int>& visible() const { return visible_; }
  const glm::dmat4& World(int node) const { return world_[std::size_t(node)]; }
  // All nodes as they are here, and at a moment.
  GltfMoment Here(double time) const;
  GltfMoment At(GltfData& data, double time) const;
  const GltfNodeState& State(int node) const { return states_[std::size_t(node)]; }
  std::string NameOf(int node) const;
  bool Exists(int node) const { return node >= 0 && std::size_t(node) < states_.size(); }

 private:
  void FindParents();
  void PlaceAll();
  int FindScene(const std::string& name) const;
  void FindVisible(int scene);

  const GltfDocument& document_;
  std::vector<GltfNodeState> states_;
  std::vector<int> parents_;
  std::vector<std::vector<int>> children_;
  std::vector<glm::dmat4> world_;
  std::vector<int> visible_;
};

// The state of each node at rest.
std::vector<GltfNodeState> GltfRestStates(const GltfDocument& document);

// Set what the document's animations move to what it is at `time`. Where several move the same property,
// the first one counts.
void Animate(GltfData& data, double time, std::vector<GltfNodeState>& states);

// Translation · rotation · scale, or the matrix.
glm::dmat4 GltfMatrix(const GltfNodeState& state);

// Whether an object may have it: finite, and its columns span space.
bool IsInvertible(const glm::dmat4& matrix);

}  // namespace snell::io
