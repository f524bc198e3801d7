// SPDX-License-Identifier: Apache-2.0
#include "tessellate/tessellate.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tessellate/test_meshes.h"

namespace snell::tessellate {
namespace {

using scene::Affine;
using scene::Object;
using scene::SubdivisionScheme;

// A cube under two materials: 0 is plain, 1 is displaced by the texture 0.
scene::Scene CubeScene() {
  scene::Scene scene;
  scene.meshes = {Cube()};
  scene.textures.resize(1);
  scene.materials.resize(2);
  scene.materials[1].displacement = {0, 0, 0.5f, 0, {0, 0.2f}};
  return scene;
}

Object CubeAt(const glm::dvec3& place, int material, double scale = 1) {
  Object object;
  object.geometry = scene::MeshGeometry{0};
  object.material = material;
  object.toWorld = glm::scale(glm::translate(Affine(1.0), place), glm::dvec3(scale));
  return object;
}

FinerMeshes Finer(const scene::Scene& scene, std::uint64_t most = MostTriangles) {
  const auto half = [](int, int, const TexturePoint&) { return 0.5f; };
  return Tessellate(scene, {}, {}, half, most);
}

TEST(Tessellate, LeavesPlainMeshesAlone) {
  scene::Scene scene = CubeScene();
  scene.objects = {CubeAt({0, 0, 0}, 0), CubeAt({3, 0, 0}, 0)};
  scene.objects.emplace_back().material = 0;
  const FinerMeshes finer = Finer(scene);
  EXPECT_TRUE(finer.meshes.empty());
  EXPECT_EQ(finer.meshOf, (std::vector<int>{0, 0, -1}));
}

TEST(Tessellate, InstancesShareWhatIsTheSameForThem) {
  scene::Scene scene = CubeScene();
  Object smooth = CubeAt({9, 0, 0}, 0);
  smooth.subdivision.scheme = SubdivisionScheme::CatmullClark;
  Object turned = CubeAt({6, 0, 0}, 1);
  turned.toWorld = glm::rotate(turned.toWorld, 1.0, glm::dvec3(1, 2, 3));
  scene.objects = {
      CubeAt({0, 0, 0}, 0), CubeAt({3, 0, 0}, 1), turned, CubeAt({0, 5, 0}, 1, 2), smooth, smooth};
  FinerMeshes finer = Finer(scene);
  EXPECT_EQ(finer.meshOf, (std::vector<int>{0, 1, 1, 2, 3, 3}));
  // Half of half a metre outward in the world, which is less in a space twice as large
  const auto reach = [&](std::size_t object) {
    float most = 0;
    for (const vec3& p : finer.MeshOf(scene, object).positions) most = std::max(most, p.x);
    return most;
  };
  EXPECT_FLOAT_EQ(reach(1), 1.25f);
  EXPECT_FLOAT_EQ(reach(3), 1.125f);

  // A texture of the world differs from place to place
  scene.textures[0].space = scene::TextureSpace::World;
  EXPECT_EQ(Finer(scene).meshOf, (std::vector<int>{0, 1, 2, 3, 4, 4}));
}

TEST(Tessellate, LevelsFollowTheTarget) {
  scene::Scene scene = CubeScene();
  scene.objects = {CubeAt({0, 0, 0}, 0)};
  scene.objects[0].subdivision.scheme = SubdivisionScheme::CatmullClark;
  scene.objects[0].subdivision.target.length = 0.3f;
  EXPECT_EQ(Finer(scene).meshes.at(0).triangles.size(), 12u * 64);  // 2 m in eight parts
}

TEST(Tessellate, SaysWhatItCannotDo) {
  scene::Scene scene = CubeScene();
  scene.objects = {CubeAt({0, 0, 0}, 0), CubeAt({0, 0, 0}, 1)};
  scene.objects[0].subdivision.scheme = SubdivisionScheme::CatmullClark;
  scene.objects[0].subdivision.levels = 10;
  scene.objects.emplace_back().material = 1;
  const FinerMeshes finer = Finer(scene, 20000);
  ASSERT_EQ(finer.meshes.size(), 2u);
  EXPECT_EQ(finer.meshes[0].triangles.size(), 12288u);
  EXPECT_LE(finer.meshes[1].triangles.size(), 20000u - 12288);
  ASSERT_EQ(finer.warnings.size(), 2u);
  EXPECT_EQ(finer.warnings[0].substr(0, 24), "1 mesh coarser than aske");
  EXPECT_EQ(finer.warnings[1].substr(0, 21), "1 shape with a displa");
}

TEST(Tessellate, NormalMapsGetTangents) {
  scene::Scene scene = CubeScene();
  scene.materials[0].normalMap.texture = 0;
  scene.objects = {CubeAt({0, 0, 0}, 0)};
  const Mesh mesh = Finer(scene).meshes.at(0);
  EXPECT_EQ(mesh.tangents.size(), 24u);
  // Meshes that bring tangents keep them
  scene.meshes[0] = mesh;
  EXPECT_TRUE(Finer(scene).meshes.empty());
}

}  // namespace
}  // namespace snell::tessellate
