// SPDX-License-Identifier: Apache-2.0
//
// Boxes around objects, for framing and for messages. (Devices compute their own, tighter and in floats.)
#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace snell::scene {

// Empty until extended.
struct Box3 {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

  void Extend(glm::dvec3 p);
  void Extend(const Box3& other);
  bool Empty() const { return !(lower.x <= upper.x); }
  glm::dvec3 Center() const { return (lower + upper) * 0.5; }
  glm::dvec3 Size() const { return upper - lower; }
};

// The world-space box of an object; empty for infinite planes and meshes without finite vertices.
Box3 BoundsOf(const Scene& scene, const Object& object);

// The box of all objects that have one; in other coordinates if these come from the world's by `map`, which
// may be any affine map.
Box3 BoundsOf(const Scene& scene, const Affine& map = Affine(1.0));

}  // namespace snell::scene
