// SPDX-License-Identifier: Apache-2.0
//
// What glows becomes emitters with the area, the place in the light tree and the power that it has in the scene.
#include "cpu/flatten_emitters.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "kernel/math.h"
#include "scene/validate.h"

namespace snell::cpu {
namespace {

using namespace kernel;
using scene::Affine;

// A scene for the path tracer whose first material glows with 1, 2 and 3, and whose second is dark.
scene::Scene Glowing() {
  scene::Scene scene;
  scene.settings.integrator = scene::Integrator::Path;
  scene.cameras.resize(1);
  scene.materials.resize(2);
  scene.materials[0].emission.value = Spectrum(1, 2, 3);
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

// Two triangles of 1 m² and 3 m² in the plane z = 0; their uv is x / 4 and y / 2.
scene::Mesh TwoTriangles() {
  scene::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {4, 0, 0}, {1, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 4}};
  for (const vec3& p : mesh.positions) mesh.uvs.push_back({p.x / 4, p.y / 2});
  return mesh;
}

const Emitter& EmitterOf(const FlatScene& flat, uint object, uint primitive) {
  return flat.emitters.at(flat.objects[object].emitters + primitive);
}

TEST(FlattenEmitters, TrianglesInTheWorldAndOfInstances) {
  scene::Scene scene = Glowing();
  scene.meshes = {TwoTriangles(), TwoTriangles()};
  Add(scene, scene::MeshGeometry{0}, 1);
  Add(scene, scene::MeshGeometry{1}, 0, glm::scale(Affine(1.0), glm::dvec3(1, 2, 1)));
  const FlatScene one = Flat(scene);
  ASSERT_EQ(one.emitters.size(), 2u);
  EXPECT_FLOAT_EQ(EmitterOf(one, 1, 2).area, 2);
  EXPECT_FLOAT_EQ(EmitterOf(one, 1, 3).area, 6);
  EXPECT_EQ(EmitterOf(one, 1, 3).primitive, 3u);
  EXPECT_EQ(EmitterOf(one, 1, 3).instance, kernel::None);

  Add(scene, scene::MeshGeometry{1}, 0, glm::scale(Affine(1.0), glm::dvec3(3, 1, 1)));
  const FlatScene two = Flat(scene);
  ASSERT_EQ(two.emitters.size(), 4u);
  const uint first = two.instances[0].firstTriangle;
  EXPECT_FLOAT_EQ(EmitterOf(two, 1, first).area, 2);
  EXPECT_FLOAT_EQ(EmitterOf(two, 2, first + 1).area, 9);
  EXPECT_EQ(EmitterOf(two, 2, first + 1).instance, 1u);
  EXPECT_EQ(two.lightNodes.size(), 7u);
  EXPECT_FLOAT_EQ(two.lightNodes[EmitterOf(two, 2, first + 1).node].power.z, 9.0f / 20);
}

TEST(FlattenEmitters, ShapesByTheirArea) {
  scene::Scene scene = Glowing();
  const Affine stretched = glm::scale(Affine(1.0), glm::dvec3(2, 1, 1));
  Add(scene, scene::Sphere{{1, 2, 3}, 2});
  Add(scene, scene::Disk{{0, 0, 0}, {0, 1, 0}, 2, 1}, 0, stretched);
  Add(scene, scene::Rectangle{{0, 0, 0}, {2, 0, 0}, {0, 0, -1}}, 0, stretched);
  Add(scene, scene::Box{});
  Add(scene, scene::Sphere{{1, 2, 3}, 2}).visibleToSecondary = false;
  const FlatScene flat = Flat(scene);
  ASSERT_EQ(flat.emitters.size(), 5u);
  EXPECT_FLOAT_EQ(EmitterOf(flat, 0, 0).area, 4 * Pi);
  EXPECT_FLOAT_EQ(EmitterOf(flat, 1, 1).area, 6 * Pi);
  EXPECT_FLOAT_EQ(EmitterOf(flat, 2, 2).area, 4);
  for (const uint i : {0u, 1u, 2u}) EXPECT_NE(EmitterOf(flat, i, i).node, kernel::None);
  // Boxes are met by chance, and what only the camera sees lights nothing
  EXPECT_EQ(EmitterOf(flat, 3, 3).node, kernel::None);
  EXPECT_EQ(EmitterOf(flat, 4, 4).node, kernel::None);
}

// A picture that is white in its left quarter: all of the first triangle, none of the second.
TEST(FlattenEmitters, CountTheirTexture) {
  for (const scene::TextureFilter filter :
       {scene::TextureFilter::Nearest, scene::TextureFilter::Mipmap}) {
    scene::Scene scene = Glowing();
    scene::Image image;
    image.width = 32;
    image.height = 4;
    for (int i = 0; i < 32 * 4; ++i) {
      const std::uint8_t value = i % 32 < 8 ? 255 : 0;
      image.bytes.insert(image.bytes.end(), {value, value, value, 255});
    }
    scene.images = {image};
    scene::Texture texture;
    texture.kind = scene::TextureKind::Image;
    texture.image = 0;
    texture.filter = filter;
    texture.wrapU = scene::Wrap::Clamp;
    scene.textures = {texture};
    scene.materials[0].emission.texture = 0;
    scene.meshes = {TwoTriangles()};
    Add(scene, scene::MeshGeometry{0});
    Add(scene, scene::Rectangle{{0, 0, 0}, {4, 0, 0}, {0, 0, -1}});
    const FlatScene flat = Flat(scene);
    const auto power = [&](const Emitter& emitter) {
      return emitter.node == kernel::None ? 0 : flat.lightNodes[emitter.node].power.z;
    };
    // The triangle glows as a whole and the rectangle in a quarter of 4 m²: as much
    EXPECT_NEAR(power(EmitterOf(flat, 0, 0)), 0.5, 0.08);
    EXPECT_LT(power(EmitterOf(flat, 0, 1)), 0.06);
    EXPECT_NEAR(power(EmitterOf(flat, 1, 0)), 0.5, 0.08);
  }
}

TEST(FlattenEmitters, AreOfThePathTracerAlone) {
  scene::Scene scene = Glowing();
  Add(scene, scene::Sphere{});
  scene.settings.integrator = scene::Integrator::Whitted;
  const FlatScene flat = Flat(scene);
  EXPECT_TRUE(flat.emitters.empty());
  EXPECT_TRUE(flat.lightNodes.empty());
}

}  // namespace
}  // namespace snell::cpu
