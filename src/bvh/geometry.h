// SPDX-License-Identifier: Apache-2.0
//
// What a BVH is built over: views of the kernel's records, owned by the caller, which must outlive the BVH.
#pragma once

#include <span>

#include "kernel/math.h"
#include "kernel/types.h"

namespace snell::bvh {

// Plain triangles need positions, triangles and worldTriangles only: without meshes all triangles, and without
// objects all shapes and instances too, are seen by every ray.
struct Geometry {
  std::span<const kernel::vec3> positions;
  std::span<const kernel::Triangle> triangles;
  std::span<const kernel::Mesh> meshes;
  std::span<const kernel::Shape> shapes;
  // Place ranges of triangles, each of one mesh if meshes change their shape; the build sets their `root`s
  std::span<kernel::Instance> instances;
  std::span<const kernel::Object> objects;
  std::uint32_t worldTriangles = 0;  // the first so many triangles are in world space
  std::span<const kernel::MotionKey> motions =
      {};  // of objects that move, which have shapes or instances

  // Whether a triangle's mesh changes its shape. Only instances place such meshes.
  bool IsDeforming(std::uint32_t triangle) const {
    return !meshes.empty() && meshes[triangles[triangle].mesh].steps != 0;
  }
  bool IsMoving(std::uint32_t object) const {
    return !motions.empty() && objects[object].motion != kernel::None;
  }
};

}  // namespace snell::bvh
