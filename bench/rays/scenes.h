// SPDX-License-Identifier: Apache-2.0
//
// The benchmark's scenes, made by formulas: five kinds of geometry on which ray tracers behave differently.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/math.h"
#include "kernel/types.h"

namespace snell::bench {

using kernel::vec3;

struct Scene {
  std::string name;
  std::vector<vec3> positions;
  std::vector<kernel::Triangle> triangles;
  std::vector<kernel::Transform> placements;  // of the mesh; if empty, it is in world space

  // Where primary rays start, what they look at, and half the picture's height at distance 1
  vec3 eye{0};
  vec3 target{0};
  float halfHeight = 0.5f;
  vec3 light{0};  // the point light that shadow rays go to

  std::uint64_t PlacedTriangles() const {
    return triangles.size() * std::max<std::uint64_t>(placements.size(), 1);
  }
};

// The names that MakeScene knows, in the order of the table.
const std::vector<std::string_view>& SceneNames();

// A scene of about `triangles` triangles (the whole mesh for instances); 0: the benchmark's own number.
// Throws Error if there is no such scene.
Scene MakeScene(std::string_view name, std::uint64_t triangles = 0);

// A mesh of a file, seen from outside its bounds. Throws Error if it cannot be read.
Scene ReadScene(const std::string& path);

}  // namespace snell::bench
