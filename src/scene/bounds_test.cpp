// SPDX-License-Identifier: Apache-2.0
//
// Boxes of objects against points on them, and the camera that these boxes place: everything within the
// picture at any scale and aspect ratio, and valid whatever the scene.
#include "scene/bounds.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "scene/framing.h"
#include "scene/validate.h"
#include "support/transforms.h"

namespace snell::scene {
namespace {

using glm::dvec3;
using test::Random;

dvec3 OnCircle(Random& random, vec3 center, vec3 axis, double radius) {
  const dvec3 n = glm::normalize(dvec3(axis));
  const dvec3 a =
      glm::normalize(glm::cross(n, std::abs(n.y) < 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
  const double angle = random.Uniform(0, 6.283185307179586);
  return dvec3(center) + (a * std::cos(angle) + glm::cross(n, a) * std::sin(angle)) * radius;
}

// A random geometry of a kind and points on it, extreme ones among them.
struct Sampled {
  Geometry geometry;
  std::vector<dvec3> points;
};
Sampled RandomGeometry(Random& random, int kind) {
  Sampled s;
  const vec3 at(random.InCube() * 3.0);
  const vec3 axis(random.Direction() * random.LogUniform(0.1, 10));
  const float r = float(random.LogUniform(0.1, 3));
  const auto add = [&](const auto& point) {
    for (int i = 0; i < 4000; ++i) s.points.push_back(point());
  };
  switch (kind) {
    case 0:
      s.geometry = Sphere{at, r};
      add([&] { return dvec3(at) + random.Direction() * double(r); });
      break;
    case 1:
      s.geometry = Disk{at, axis, r, r / 3};
      add([&] { return OnCircle(random, at, axis, double(r)); });
      break;
    case 2: {
      const vec3 u(random.InCube()), v(random.InCube());
      s.geometry = Rectangle{at, u, v};
      for (const vec3 p : {at, at + u, at + v, at + u + v}) s.points.push_back(dvec3(p));
      break;
    }
    case 3: {
      const vec3 size = kernel::Abs(axis);
      s.geometry = Box{at - size, at + size};
      for (int corner = 0; corner < 8; ++corner)
        s.points.push_back(
            dvec3(at + size * vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
      break;
    }
    case 4: {
      const float top = r * random.UniformFloat();
      s.geometry = Cone{at, at + axis, r, top, true};
      add([&] { return OnCircle(random, at, axis, double(r)); });
      add([&] { return OnCircle(random, at + axis, axis, double(top)); });
      break;
    }
    default: {
      const float minor = r * float(random.Uniform(0.05, 1));
      s.geometry = Torus{at, axis, r, minor};
      add([&] {
        const dvec3 ring = OnCircle(random, vec3(0), axis, 1);
        const double angle = random.Uniform(0, 6.283185307179586);
        return dvec3(at) + ring * (double(r) + double(minor) * std::cos(angle)) +
               glm::normalize(dvec3(axis)) * (double(minor) * std::sin(angle));
      });
    }
  }
  return s;
}

TEST(BoundsOf, HoldsEveryShapeTightly) {
  Random random(730);
  for (int i = 0; i < 300; ++i) {
    const int kind = i % 6;
    const Sampled sampled = RandomGeometry(random, kind);
    Object object;
    object.geometry = sampled.geometry;
    object.toWorld =
        test::RandomMap(random, test::MapKinds[random.Index(4)], random.LogUniform(0.01, 100), 5);
    const Box3 box = BoundsOf(Scene{}, object);
    Box3 seen;
    for (const dvec3 p : sampled.points) seen.Extend(dvec3(object.toWorld * glm::dvec4(p, 1)));
    for (int axis = 0; axis < 3; ++axis) {
      const double slack = 1e-5 * (std::abs(box.lower[axis]) + std::abs(box.upper[axis]));
      EXPECT_LE(box.lower[axis], seen.lower[axis] + slack) << "kind " << kind;
      EXPECT_GE(box.upper[axis], seen.upper[axis] - slack) << "kind " << kind;
      // A torus gets the box of the cylinder around it
      const double loose = kind == 5 ? 1.0 : 0.02;
      EXPECT_LE(box.Size()[axis], seen.Size()[axis] * (1 + loose) + slack) << "kind " << kind;
    }
  }
}

TEST(BoundsOf, LeavesOutWhatHasNone) {
  constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float Inf = std::numeric_limits<float>::infinity();
  Scene scene;
  scene.meshes.resize(1);
  scene.meshes[0].positions = {vec3(1, 2, 3), vec3(NaN, 0, 0), vec3(-1, 0, 5), vec3(0, 0, Inf)};
  Object plane, mesh;
  plane.geometry = Plane{};
  mesh.geometry = MeshGeometry{0};
  EXPECT_TRUE(BoundsOf(scene).Empty());
  scene.objects = {plane};
  EXPECT_TRUE(BoundsOf(scene).Empty());
  scene.objects = {plane, mesh};
  EXPECT_EQ(BoundsOf(scene).lower, dvec3(-1, 0, 3));
  EXPECT_EQ(BoundsOf(scene).upper, dvec3(1, 2, 5));
}

// Where a point appears: x and y within ±1 are in the picture; z is the distance.
dvec3 Seen(const Camera& camera, double aspect, dvec3 p) {
  const dvec3 eye(camera.position);
  const dvec3 forward = glm::normalize(dvec3(camera.lookAt) - eye);
  const dvec3 right = glm::normalize(glm::cross(forward, dvec3(camera.up)));
  const dvec3 up = glm::cross(right, forward);
  const double z = glm::dot(p - eye, forward), y = std::tan(double(camera.fov) / 2);
  return {glm::dot(p - eye, right) / (z * y * aspect), glm::dot(p - eye, up) / (z * y), z};
}

TEST(DefaultCamera, ShowsEveryCornerAtAnyScaleAndAspect) {
  Random random(731);
  for (int i = 0; i < 2000; ++i) {
    const double size = random.LogUniform(1e-4, 1e5);
    const vec3 center(random.InCube() * (size * random.LogUniform(0.01, 10)));
    const auto half = [&] { return float(size * random.LogUniform(1e-3, 1)); };
    const float x = half(), y = half();
    const vec3 reach(x, y, half());
    Scene scene;
    scene.objects.resize(1);
    scene.objects[0].geometry = Box{center - reach, center + reach};
    const Box3 box = BoundsOf(scene);
    for (const double aspect : {0.1, 0.5, 1.0, 16.0 / 9, 5.0}) {
      const Camera camera = DefaultCamera(scene, aspect);
      double widest = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p(corner & 1 ? box.lower.x : box.upper.x,
                      corner & 2 ? box.lower.y : box.upper.y,
                      corner & 4 ? box.lower.z : box.upper.z);
        const dvec3 seen = Seen(camera, aspect, p);
        ASSERT_GT(seen.z, 0);
        widest = std::max({widest, std::abs(seen.x), std::abs(seen.y)});
      }
      ASSERT_LT(widest, 0.99);
      ASSERT_GT(widest, 0.6);
    }
  }
}

TEST(DefaultCamera, IsValidWhateverTheScene) {
  for (const Geometry& geometry :
       {Geometry(Plane{}), Geometry(MeshGeometry{0}), Geometry(Sphere{vec3(3), 1e-30f}),
        Geometry(Sphere{vec3(0), 1e30f})}) {
    Scene scene;
    scene.meshes.resize(1);
    scene.meshes[0].positions = {vec3(5, 6, 7)};  // one point: no size
    scene.materials = {DefaultMaterial()};
    scene.objects.resize(1);
    scene.objects[0].geometry = geometry;
    scene.objects[0].material = 0;
    scene.cameras = {DefaultCamera(scene, 1.5)};
    EXPECT_NO_THROW(Validate(scene, nullptr)) << geometry.index();
    AddStudio(scene);
    EXPECT_NO_THROW(Validate(scene, nullptr)) << geometry.index();
  }
  Scene empty;
  AddStudio(empty);
  empty.cameras = {DefaultCamera(empty, 1.5)};
  EXPECT_NO_THROW(Validate(empty, nullptr));
}

}  // namespace
}  // namespace snell::scene
