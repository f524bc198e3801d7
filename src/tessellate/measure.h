// SPDX-License-Identifier: Apache-2.0
//
// How long the edges of a mesh are where its instances stand: in the world and in the picture. Both ends of
// an edge count alike, so that neighbours always agree.
#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "scene/scene.h"

namespace snell::tessellate {

// What the camera tells of sizes.
struct View {
  View(const scene::Camera& camera, int width, int height);

  glm::dvec3 eye;
  bool isOrthographic;
  double
      pixel;  // its height in metres: a metre from the eye, on the line of sight, or anywhere (orthographic)
};

// Instances of a mesh whose transforms differ by no more than rotation, reflection and translation.
class Measure {
 public:
  explicit Measure(const scene::Affine& toWorld);

  // Whether an instance is measured alike.
  bool Fits(const scene::Affine& toWorld) const;
  void AddEye(const View& view, const scene::Affine& toWorld);

  // How many times longer than its target an edge is, for the instance that is nearest to the camera.
  double Excess(const scene::vec3& a, const scene::vec3& b, const scene::EdgeTarget& target) const;

  // The vector of the mesh's space that is a metre along a normal in the world.
  glm::dvec3 AlongNormal(const glm::dvec3& normal) const;

 private:
  glm::dmat3 metric_;   // dot products of vectors in the world
  glm::dmat3 inverse_;  // the same of normals
  bool isOrthographic_ = false;
  double pixel_ = 0;
  std::vector<glm::dvec3> eyes_;  // in the mesh's space
};

}  // namespace snell::tessellate
