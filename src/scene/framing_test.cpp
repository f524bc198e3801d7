// SPDX-License-Identifier: Apache-2.0
//
// The default camera shows everything and wastes no room; the studio stands under its objects.
#include "scene/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/bounds.h"
#include "support/random.h"

namespace snell::scene {
namespace {

Scene SceneOf(const std::vector<vec3>& points) {
  Scene scene;
  Mesh mesh;
  mesh.positions = points;
  scene.meshes.push_back(mesh);
  Object object;
  object.geometry = MeshGeometry{0};
  scene.objects.push_back(object);
  return scene;
}

// Where a point lies in the picture: ±1 is its upper or lower edge, ±aspect its right or left one.
glm::dvec2 InPicture(const Camera& camera, glm::dvec3 point) {
  const glm::dvec3 position(camera.position);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.lookAt) - position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  const glm::dvec3 up = glm::cross(right, forward), d = point - position;
  const double depth = glm::dot(d, forward);
  EXPECT_GT(depth, 0);
  const double scale = 1 / (depth * std::tan(double(camera.fov) / 2));
  return {glm::dot(d, right) * scale, glm::dot(d, up) * scale};
}

TEST(DefaultCamera, FitsAnyMeshTightlyAndInTheMiddle) {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    // Points of any scale, place and proportions
    const double scale = random.LogUniform(1e-4, 1e4);
    const glm::dvec3 middle = random.InCube() * 5.0 * scale;
    const glm::dvec3 size = glm::dvec3(random.LogUniform(0.05, 2), random.LogUniform(0.05, 2),
                                       random.LogUniform(0.05, 2)) *
                            scale;
    std::vector<vec3> points;
    for (int k = 0; k < 12; ++k) points.push_back(vec3(middle + random.InCube() * size));
    const double aspect = random.Uniform(0.3, 3);
    const Camera camera = DefaultCamera(SceneOf(points), aspect);

    glm::dvec2 lower(9), upper(-9);
    for (const vec3 p : points) {
      const glm::dvec2 seen = InPicture(camera, glm::dvec3(p)) / glm::dvec2(aspect, 1);
      lower = glm::min(lower, seen);
      upper = glm::max(upper, seen);
    }
    EXPECT_LT(std::max(upper.x, upper.y), 0.86);
    EXPECT_GT(std::max(upper.x, upper.y), 0.83);
    const int way = upper.x - lower.x > upper.y - lower.y ? 0 : 1;
    EXPECT_NEAR(lower[way], -upper[way], 1e-2);
  }
}

TEST(DefaultCamera, FitsABallToItsRim) {
  Scene scene;
  Object object;
  object.geometry = Sphere{vec3(10, 20, 30), 3};
  scene.objects.push_back(object);
  const Camera camera = DefaultCamera(scene, 2);

  // A ball at distance d is seen under the half angle asin(r / d)
  const double distance = glm::length(glm::dvec3(camera.position) - glm::dvec3(10, 20, 30));
  const double rim = std::tan(std::asin(3 / distance)) / std::tan(double(camera.fov) / 2);
  EXPECT_NEAR(rim, 1 / 1.18, 1e-4);
}

TEST(DefaultCamera, LooksAtTheOriginIfNothingHasASize) {
  const Camera camera = DefaultCamera(Scene{}, 1);
  EXPECT_EQ(camera.lookAt, vec3(0.0f));
  EXPECT_GT(glm::length(camera.position), 1);

  const Camera close = DefaultCamera(SceneOf({vec3(1, 2, 3)}), 1);
  EXPECT_EQ(close.lookAt, vec3(1, 2, 3));
  EXPECT_GT(glm::length(close.position - close.lookAt), 0);
}

TEST(Studio, StandsUnderTheLowestPoint) {
  Scene scene = SceneOf({vec3(0, -3, 0), vec3(1, 4, 0), vec3(0, 2, 1)});
  AddStudio(scene);
  // Just below the objects, whose own lowest faces are to be seen
  EXPECT_LT(std::get<Plane>(scene.objects.back().geometry).point.y, -3);
  EXPECT_NEAR(std::get<Plane>(scene.objects.back().geometry).point.y, -3, 0.01);
  EXPECT_EQ(scene.lights.size(), 4u);
}

}  // namespace
}  // namespace snell::scene
