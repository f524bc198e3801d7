// SPDX-License-Identifier: Apache-2.0
//
// The BVH alone: a pyramid over a floor, the nearest hit of a ray, and whether a light is seen from there.
#include <cstdio>
#include <vector>

#include "bvh/bvh.h"

using snell::kernel::Ray;
using snell::kernel::vec3;

int main() {
  // Plain arrays, which must outlive the BVH: positions, and triangles that name three of them
  const std::vector<vec3> positions = {{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5},  {5, 0, -5}, {-1, 0, -1},
                                       {-1, 0, 1},  {1, 0, 1},  {1, 0, -1}, {0, 2, 0}};
  const std::vector<snell::kernel::Triangle> triangles = {{0, 1, 2, 0}, {0, 2, 3, 0}, {4, 5, 8, 0},
                                                          {5, 6, 8, 0}, {6, 7, 8, 0}, {7, 4, 8, 0}};
  snell::bvh::Geometry geometry;
  geometry.positions = positions;
  geometry.triangles = triangles;
  geometry.worldTriangles = 6;
  const snell::bvh::Bvh bvh(geometry);

  const vec3 light(6, 3, 0);
  for (const float x : {-4.0f, -1.5f, 0.5f, 3.0f}) {
    const Ray ray{vec3(x, 5, 0.25f), vec3(0, -1, 0), 0};
    const auto hit = bvh.Closest(ray, snell::kernel::Infinite);

    // A shadow ray from just above the surface; it ends at the light, where t = 1
    const vec3 p = ray.o + ray.d * (hit.t - 1e-4f);
    const bool dark = bvh.Any({p, light - p, 0}, 1);
    std::printf("x = %4.1f: triangle %u at height %.2f, %s\n", double(x), hit.primitive,
                double(p.y), dark ? "in shadow" : "lit");
  }
}
