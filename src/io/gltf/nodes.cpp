// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "io/gltf/value.h"
#include "util/text.h"

namespace snell::io {
namespace {

bool AreFinite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

// Set a vector from an array of the file that may be absent or malformed.
template <typename V>
void Set(V& to, const std::vector<double>& from, const GltfDocument& document, std::size_t node) {
  if (from.empty()) return;
  if (int(from.size()) == to.length() && AreFinite(from)) {
    for (int i = 0; i < to.length(); ++i) to[i] = from[std::size_t(i)];
  } else {
    document.findings.Note("a node's malformed transform is ignored", GltfPart("node", node));
  }
}

}  // namespace

glm::dmat4 GltfMatrix(const GltfNodeState& state) {
  if (state.matrix) return *state.matrix;
  return glm::scale(glm::translate(glm::dmat4(1.0), state.translation) *
                        glm::mat4_cast(glm::normalize(state.rotation)),
                    state.scale);
}

bool IsInvertible(const glm::dmat4& m) {
  double size = 1;
  for (int column = 0; column < 3; ++column) size *= glm::length(glm::dvec3(m[column]));
  const double determinant = glm::determinant(glm::dmat3(m));
  return std::isfinite(determinant) && std::isfinite(glm::length(glm::dvec3(m[3]))) && size > 0 &&
         std::abs(determinant) > 1e-12 * size;
}

std::vector<GltfNodeState> GltfRestStates(const GltfDocument& document) {
  std::vector<GltfNodeState> states(document.model.nodes.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const tinygltf::Node& node = document.model.nodes[i];
    GltfNodeState& state = states[i];
    Set(state.translation, node.translation, document, i);
    Set(state.scale, node.scale, document, i);
    glm::dvec4 rotation(0, 0, 0, 1);
    Set(rotation, node.rotation, document, i);
    state.rotation = glm::dquat(rotation.w, rotation.x, rotation.y, rotation.z);
    if (node.matrix.size() == 16 && AreFinite(node.matrix)) {
      glm::dmat4 matrix = glm::make_mat4(node.matrix.data());
      for (int column = 0; column < 4; ++column) matrix[column][3] = column == 3 ? 1.0 : 0.0;
      state.matrix = matrix;
    } else if (!node.matrix.empty()) {
      document.findings.Note("a node's malformed transform is ignored", GltfPart("node", i));
    }
    state.weights = node.weights;
  }
  return states;
}

GltfNodes::GltfNodes(GltfData& data, std::optional<double> time, const std::string& scene)
    : document_(data.document()), states_(GltfRestStates(data.document())) {
  FindParents();
  if (time) {
    Animate(data, *time, states_);
  } else if (!document_.model.animations.empty()) {
    document_.findings.Note("animations are not played; everything is shown at rest");
  }
  PlaceAll();
  FindVisible(FindScene(scene));
}

GltfMoment GltfNodes::Here(double time) const {
  GltfMoment moment{time, world_, {}};
  for (const GltfNodeState& state : states_) moment.weights.push_back(state.weights);
  return moment;
}

GltfMoment GltfNodes::At(GltfData& data, double time) const {
  GltfNodes moved = *this;
  moved.states_ = GltfRestStates(document_);
  Animate(data, time, moved.states_);
  moved.PlaceAll();
  return moved.Here(time);
}

std::string GltfNodes::NameOf(int node) const {
  return GltfPart("node", std::size_t(node), document_.model.nodes[std::size_t(node)].name);
}

void GltfNodes::FindParents() {
  parents_.assign(states_.size(), -1);
  children_.resize(states_.size());
  for (int i = 0; i < int(states_.size()); ++i) {
    for (const int child : document_.model.nodes[std::size_t(i)].children) {
      if (!Exists(child)) {
        document_.findings.Note("a child node does not exist", NameOf(i));
      } else if (child == i) {
        throw document_.Fault(NameOf(i), "the node is its own child");
      } else if (parents_[std::size_t(child)] >= 0) {
        document_.findings.Note("a node with two parents stays with the first", NameOf(child));
      } else {
        parents_[std::size_t(child)] = i;
        children_[std::size_t(i)].push_back(child);
      }
    }
  }
}

// Place all nodes, parents first. What no root leads to goes round in a circle.
void GltfNodes::PlaceAll() {
  world_.assign(states_.size(), glm::dmat4(1.0));
  std::vector<int> order;
  for (int i = 0; i < int(states_.size()); ++i)
    if (parents_[std::size_t(i)] < 0) order.push_back(i);
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::size_t node = std::size_t(order[at]);
    const int parent = parents_[node];
    world_[node] = GltfMatrix(states_[node]);
    if (parent >= 0) world_[node] = world_[std::size_t(parent)] * world_[node];
    order.insert(order.end(), children_[node].begin(), children_[node].end());
  }
  if (order.size() == states_.size()) return;
  std::vector<bool> isPlaced(states_.size(), false);
  for (const int node : order) isPlaced[std::size_t(node)] = true;
  const auto first = std::ranges::find(isPlaced, false) - isPlaced.begin();
  throw document_.Fault(NameOf(int(first)), "the node is its own ancestor, or below one that is");
}

// The scene to show; -1 if there is none, and all nodes are shown.
int GltfNodes::FindScene(const std::string& name) const {
  const tinygltf::Model& model = document_.model;
  if (!name.empty()) {
    std::vector<std::string> names;
    for (const tinygltf::Scene& scene : model.scenes) names.push_back(scene.name);
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return int(found - names.begin());
    throw document_.Fault("", fmt::format("there is no scene '{}'", name), DidYouMean(name, names));
  }
  const bool hasDefault =
      model.defaultScene >= 0 && std::size_t(model.defaultScene) < model.scenes.size();
  if (model.defaultScene >= 0 && !hasDefault)
    document_.findings.Note("the default scene does not exist; the first one is shown");
  if (model.scenes.size() > 1) document_.findings.Note("only one of several scenes is shown");
  return hasDefault ? model.defaultScene : model.scenes.empty() ? -1 : 0;
}

void GltfNodes::FindVisible(int scene) {
  // Begin with the scene's roots, or with all
  std::vector<int> waiting;
  if (scene >= 0) {
    waiting = document_.model.scenes[std::size_t(scene)].nodes;
  } else {
    for (int i = 0; i < int(states_.size()); ++i)
      if (parents_[std::size_t(i)] < 0) waiting.push_back(i);
  }
  std::ranges::reverse(waiting);

  // Go down the tree in the file's order
  std::vector<bool> isSeen(states_.size(), false);
  while (!waiting.empty()) {
    const int node = waiting.back();
    waiting.pop_back();
    if (!Exists(node)) {
      document_.findings.Note("a node of the scene does not exist");
      continue;
    }
    if (isSeen[std::size_t(node)]) continue;
    isSeen[std::size_t(node)] = true;
    const auto& extensions = document_.model.nodes[std::size_t(node)].extensions;
    if (!GltfValue(extensions, "KHR_node_visibility").Bool("visible", true)) continue;
    visible_.push_back(node);
    const std::vector<int>& children = children_[std::size_t(node)];
    waiting.insert(waiting.end(), children.rbegin(), children.rend());
  }
}

}  // namespace snell::io
