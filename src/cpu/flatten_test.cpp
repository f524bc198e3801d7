// SPDX-License-Identifier: Apache-2.0
//
// Flattening: mirrored meshes turned outward still, meshes shared or in world space, masks, lights and cameras
// by their definitions.
#include "cpu/flatten.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "kernel/math.h"
#include "scene/validate.h"
#include "support/meshes.h"
#include "support/transforms.h"

namespace snell::cpu {
namespace {

using namespace kernel;
using glm::dvec3;
using scene::Affine;
using test::Random;

// A scene of meshes and shapes that all have the first of two materials: paint, and glass.
scene::Scene Painted() {
  scene::Scene scene;
  scene.cameras.resize(1);
  scene.materials.resize(2);
  scene.materials[1].transparency.value = Spectrum(1.0f);
  return scene;
}
scene::Object& Add(scene::Scene& scene, const scene::Geometry& geometry, int material = 0,
                   const Affine& toWorld = Affine(1.0)) {
  scene::Object object;
  object.geometry = geometry;
  object.material = material;
  object.toWorld = toWorld;
  scene.objects.push_back(object);
  return scene.objects.back();
}
FlatScene Flat(const scene::Scene& scene) {
  scene::Validate(scene, nullptr);
  return Flatten(scene, scene.settings, scene.cameras[0]);
}
scene::Mesh ToMesh(const test::TriangleMesh& mesh) {
  scene::Mesh out;
  out.positions = mesh.positions;
  out.triangles = mesh.triangles;
  return out;
}

double SignedVolume(const FlatScene& flat) {
  double volume = 0;
  for (const Triangle& t : flat.triangles)
    volume += glm::dot(dvec3(flat.positions[t.v0]),
                       glm::cross(dvec3(flat.positions[t.v1]), dvec3(flat.positions[t.v2])));
  return volume / 6;
}

TEST(FlattenObjects, KeepsMeshesTurnedOutward) {
  Random random(744);
  for (int i = 0; i < 40; ++i) {
    const Affine map = test::RandomMap(random, test::MapKinds[i % 4], 2, 1);
    const double determinant = glm::determinant(glm::dmat3(map));
    scene::Scene scene = Painted();
    scene::Mesh mesh = ToMesh(test::Cube());
    for (const vec3 p : mesh.positions) mesh.normals.push_back(Normalize(p));
    scene.meshes = {mesh};
    Add(scene, scene::MeshGeometry{0}, 0, map);
    const FlatScene flat = Flat(scene);
    EXPECT_NEAR(SignedVolume(flat) / (8 * std::abs(determinant)), 1, 1e-4);
    for (std::size_t v = 0; v < flat.positions.size(); ++v) {
      const dvec3 out = dvec3(flat.positions[v]) - dvec3(map[3]);
      EXPECT_GT(glm::dot(dvec3(flat.normals[v]), out), 0);
      EXPECT_NEAR(double(Length(flat.normals[v])), 1, 1e-6);
      const dvec3 exact =
          glm::normalize(glm::transpose(glm::inverse(glm::dmat3(map))) * dvec3(mesh.normals[v]));
      EXPECT_LT(glm::length(dvec3(flat.normals[v]) - exact), 1e-5);
    }
  }
}

TEST(FlattenObjects, SharesMeshesThatAreUsedTwice) {
  scene::Scene scene = Painted();
  scene.meshes = {ToMesh(test::Cube()), ToMesh(test::Icosphere(0)), ToMesh(test::Grid(2))};
  scene.meshes[0].uvs.resize(8);
  const Affine moved = glm::translate(Affine(1.0), dvec3(5, 0, 0));
  Add(scene, scene::MeshGeometry{0});
  Add(scene, scene::MeshGeometry{1}, 0, moved);  // used once: to world space; the third mesh never
  Add(scene, scene::Sphere{});
  Add(scene, scene::MeshGeometry{0}, 1, moved);
  const FlatScene flat = Flat(scene);
  EXPECT_EQ(flat.worldTriangles, 20u);
  EXPECT_EQ(flat.triangles.size(), 32u);
  EXPECT_EQ(flat.positions.size(), 20u);
  ASSERT_EQ(flat.instances.size(), 2u);
  for (const Instance& instance : flat.instances) {
    EXPECT_EQ(instance.firstTriangle, 20u);
    EXPECT_EQ(instance.triangleCount, 12u);
  }
  EXPECT_EQ(flat.objects[flat.instances[0].object].material, 0u);
  EXPECT_EQ(flat.objects[flat.instances[1].object].material, 1u);
  EXPECT_EQ(flat.instances[1].toWorld.origin, vec3(5, 0, 0));
  EXPECT_EQ(flat.meshes[flat.triangles[0].mesh].object, 1u);
  EXPECT_GT(flat.positions[flat.triangles[0].v0].x, 3.9f) << "in world space";
  // The texture coordinates of the second mesh stand behind nothing of the first's
  const Mesh& cube = flat.meshes[flat.triangles[20].mesh];
  EXPECT_EQ(uint(flat.triangles[20].v0 + cube.uvs), flat.triangles[20].v0 - 12);
  EXPECT_EQ(cube.normals, None);
}

TEST(FlattenObjects, SetsMasksByWhatObjectsAre) {
  scene::Scene scene = Painted();
  scene.materials.push_back(scene.materials[1]);
  scene.materials[2].thin = true;
  const auto maskOf = [&](int material, bool camera, bool secondary, bool shadow, bool tinted) {
    scene.objects.clear();
    scene::Object& object = Add(scene, scene::Sphere{}, material);
    object.visibleToCamera = camera;
    object.visibleToSecondary = secondary;
    object.castsShadow = shadow;
    scene.settings.tintedShadows = tinted;
    const FlatScene flat = Flat(scene);
    EXPECT_EQ(flat.params.tintedShadows, (flat.objects[0].mask & MASK_TINT) != 0 ? 1u : 0u);
    return flat.objects[0].mask;
  };
  EXPECT_EQ(maskOf(0, true, true, true, true), MASK_CAMERA | MASK_SECONDARY | MASK_SHADOW);
  EXPECT_EQ(maskOf(0, false, false, false, true), 0u);
  EXPECT_EQ(maskOf(1, true, false, true, true), MASK_CAMERA | MASK_TINT | MASK_INSIDE);
  EXPECT_EQ(maskOf(1, true, false, true, false), MASK_CAMERA | MASK_SHADOW | MASK_INSIDE);
  EXPECT_EQ(maskOf(1, false, true, false, true), MASK_SECONDARY | MASK_INSIDE);
  EXPECT_EQ(maskOf(2, false, false, true, true), MASK_TINT);
}

TEST(FlattenLights, FollowsTheirDefinitions) {
  scene::Scene scene = Painted();
  scene::Light light;
  light.strength = 3;
  light.color = Spectrum(1, 0.5f, 0);
  const auto flatOf = [&] {
    scene.lights = {light};
    return Flat(scene);
  };
  light.kind = scene::LightKind::Ambient;
  EXPECT_EQ(flatOf().params.ambient, Spectrum(3, 1.5f, 0));
  EXPECT_EQ(flatOf().lights.size(), 0u);

  light.kind = scene::LightKind::Spot;
  light.innerAngle = 0.3f;
  light.outerAngle = 0.5f;
  light.direction = vec3(0, 0, -4);
  EXPECT_FLOAT_EQ(flatOf().lights[0].cosInner, std::cos(0.3f));
  EXPECT_FLOAT_EQ(flatOf().lights[0].cosOuter, std::cos(0.5f));
  EXPECT_EQ(flatOf().lights[0].direction, vec3(0, 0, -1));
  EXPECT_EQ(flatOf().lights[0].samples, 1u) << "a hard shadow needs one";
  light.radius = 1;
  EXPECT_EQ(flatOf().lights[0].samples, 4u);

  light.kind = scene::LightKind::Directional;
  for (const float angle : {0.01f, 1e-4f, 2.0f}) {
    light.angularSize = angle;
    const double exact = 2 * std::pow(std::sin(double(angle) / 4), 2);  // 1 − cos of half of it
    EXPECT_NEAR(double(flatOf().lights[0].oneMinusCos) / exact, 1, 1e-6);
  }

  light.kind = scene::LightKind::Disk;
  light.radius = 2;
  light.direction = Normalize(vec3(1, -2, 3));
  const Light disk = flatOf().lights[0];
  EXPECT_NEAR(disk.area, 4 * Pi, 1e-5f);
  EXPECT_NEAR(Length(disk.edgeU), 2, 1e-5f);
  EXPECT_NEAR(Dot(disk.edgeU, disk.edgeV), 0, 1e-5f);
  EXPECT_NEAR(Dot(disk.edgeU, light.direction), 0, 1e-6f);

  light.kind = scene::LightKind::Triangle;
  light.edgeU = vec3(2, 0, 0);
  light.edgeV = vec3(0, 3, 0);
  EXPECT_FLOAT_EQ(flatOf().lights[0].area, 3);
  EXPECT_EQ(flatOf().lights[0].direction, vec3(0, 0, 1));
  light.kind = scene::LightKind::Rectangle;
  EXPECT_FLOAT_EQ(flatOf().lights[0].area, 6);
}

TEST(FlattenLights, ShowsTheSurfacesOfAreaLights) {
  scene::Scene scene = Painted();
  for (const scene::LightKind kind :
       {scene::LightKind::Point, scene::LightKind::Rectangle, scene::LightKind::Triangle,
        scene::LightKind::Disk, scene::LightKind::Sphere}) {
    scene::Light light;
    light.kind = kind;
    light.radius = 1;
    scene.lights.push_back(light);
    light.visible = false;
    scene.lights.push_back(light);
  }
  scene.meshes = {ToMesh(test::Cube())};
  Add(scene, scene::MeshGeometry{0});
  const FlatScene flat = Flat(scene);
  EXPECT_EQ(flat.lights.size(), 10u);
  EXPECT_EQ(flat.params.lightCount, 10u);
  EXPECT_EQ(flat.shapes.size(), 3u);
  EXPECT_EQ(flat.worldTriangles, 13u);
  ASSERT_EQ(flat.objects.size(), 5u);
  // Each surface knows its light, blocks none, and the mesh's object follows them
  const uint lights[] = {2, 4, 6, 8};
  for (uint i = 0; i < 4; ++i) {
    EXPECT_EQ(flat.objects[i].light, lights[i]);
    EXPECT_EQ(flat.objects[i].mask, MASK_CAMERA | MASK_SECONDARY);
  }
  EXPECT_EQ(flat.objects[4].light, None);
  EXPECT_EQ(flat.meshes[flat.triangles[12].mesh].object, 4u);
}

TEST(FlattenMaterials, AbsorbsToTheColourAtTheDistance) {
  scene::Scene scene = Painted();
  scene.materials[1].attenuationColor = Spectrum(0.5f, 1.0f, 0.01f);
  scene.materials[1].attenuationDistance = 0.2f;
  const Spectrum a = Flat(scene).materials[1].inside.extinction;
  EXPECT_NEAR(std::exp(-a.x * 0.2f), 0.5f, 1e-6f);
  EXPECT_EQ(a.y, 0.0f);
  EXPECT_NEAR(std::exp(-a.z * 0.2f), 0.01f, 1e-6f);
  EXPECT_EQ(Flat(scene).materials[0].inside.extinction, Spectrum(0.0f));
  scene.materials[1].attenuationColor = Spectrum(0.0f);
  EXPECT_TRUE(std::isfinite(Flat(scene).materials[1].inside.extinction.x));
}

TEST(FlattenCamera, SpansThePicture) {
  scene::Scene scene = Painted();
  scene::Camera& camera = scene.cameras[0];
  camera.position = vec3(1, 2, 3);
  camera.lookAt = vec3(-2, 1, 7);
  camera.up = vec3(0.1f, 5, 0);
  camera.fov = 1;
  scene.settings.width = 300;
  scene.settings.height = 200;
  const Camera flat = Flat(scene).params.camera;
  EXPECT_NEAR(flat.extent.y, std::tan(0.5f), 1e-6f);
  EXPECT_NEAR(flat.extent.x, 1.5f * std::tan(0.5f), 1e-6f);
  EXPECT_NEAR(Dot(flat.forward, Normalize(camera.lookAt - camera.position)), 1, 1e-6f);
  EXPECT_NEAR(Length(Cross(flat.forward, flat.up) - flat.right), 0, 1e-6f) << "right-handed";
  EXPECT_GT(flat.up.y, 0.5f);
  camera.kind = scene::CameraKind::Orthographic;
  camera.height = 4;
  EXPECT_FLOAT_EQ(Flat(scene).params.camera.extent.y, 2);
}

TEST(FlattenCamera, KnowsWhetherItMayBeInsideGlass) {
  const auto inside = [](vec3 position, int material, int meshes, scene::CameraKind kind) {
    scene::Scene scene = Painted();
    scene.cameras[0].position = position;
    scene.cameras[0].lookAt = position + vec3(0, 0, -1);
    scene.cameras[0].kind = kind;
    scene.cameras[0].height = 4;
    scene.meshes = {ToMesh(test::Cube())};
    if (meshes == 0) Add(scene, scene::Sphere{}, material);
    for (int i = 0; i < meshes; ++i) Add(scene, scene::MeshGeometry{0}, material);
    return Flat(scene).params.camera.inside == 1;
  };
  for (const int meshes : {0, 1, 2}) {
    const auto pinhole = scene::CameraKind::Pinhole;
    EXPECT_TRUE(inside(vec3(0, 0, 0.9f), 1, meshes, pinhole)) << meshes;
    EXPECT_FALSE(inside(vec3(0, 0, 1.1f), 1, meshes, pinhole)) << meshes;
    EXPECT_FALSE(inside(vec3(0, 0, 0.9f), 0, meshes, pinhole)) << meshes;
    // The rays of a wide view start beside the camera
    EXPECT_TRUE(inside(vec3(2, 0, 0), 1, meshes, scene::CameraKind::Orthographic)) << meshes;
    EXPECT_FALSE(inside(vec3(5, 0, 0), 1, meshes, scene::CameraKind::Orthographic)) << meshes;
  }
}

}  // namespace
}  // namespace snell::cpu
