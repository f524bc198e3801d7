// SPDX-License-Identifier: Apache-2.0
//
// OBJ files as scenes: objects, groups, smoothing, libraries.
#include "io/obj/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "io/mesh/test_files.h"
#include "io/obj/test_scene.h"
#include "io/read_scene.h"

namespace snell::io {
namespace {

using scene::vec3;

const std::string Square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<std::string> ObjectNames(const scene::Scene& scene) {
  std::vector<std::string> names;
  for (const scene::Object& object : scene.objects) names.push_back(object.name);
  return names;
}

TEST(ObjScene, ObjectsByGroupAndMaterial) {
  ObjTestScene test;
  test.Write("a.mtl",
             "newmtl red\nKd 1 0 0\nnewmtl unused\nmap_Kd none.png\nnewmtl blue\nKd 0 0 1\n");
  test.Write("a.obj", "mtllib a.mtl\n" + Square +
                          "o box\ng top\nusemtl blue\nf 1 2 3\nusemtl red\nf 1 3 4\n"
                          "g side\nf 1 2 4\ng top\nf 2 3 4\no ball\nf 1 2 3 4\n");
  const scene::Scene scene = test.Read();
  EXPECT_EQ(test.error, "");
  EXPECT_TRUE(test.warnings.empty());
  EXPECT_EQ(ObjectNames(scene),
            (std::vector<std::string>{"box/top", "box/top", "box/side", "ball"}));
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "blue");
  EXPECT_EQ(scene.materials[0].physical->baseColor.value, vec3(0, 0, 1));
  EXPECT_EQ(scene.objects[0].material, 0);
  EXPECT_EQ(scene.objects[1].material, 1);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
  EXPECT_EQ(scene.meshes[1].triangles.size(), 2u);
  EXPECT_EQ(scene.meshes[3].triangles.size(), 2u);
  for (const scene::Mesh& mesh : scene.meshes) EXPECT_TRUE(IsSound(mesh));
}

TEST(ObjScene, GlassIsNotCutIntoGroups) {
  ObjTestScene test;
  test.Write("a.mtl", "newmtl glass\nillum 7\nd 0.1\n");
  test.Write("a.obj", "mtllib a.mtl\nusemtl glass\n" + Square + "g a\nf 1 2 3\ng b\nf 1 3 4\n");
  EXPECT_EQ(test.Read().objects.size(), 1u);
}

TEST(ObjScene, ThousandsOfGroupsAreMergedByMaterial) {
  ObjTestScene test;
  std::string text = "mtllib a.mtl\n" + Square;
  for (int i = 0; i < 5000; ++i)
    text += "g g" + std::to_string(i) + "\nusemtl m" + std::to_string(i % 3) + "\nf 1 2 3\n";
  test.Write("a.mtl", "newmtl m0\nnewmtl m1\nnewmtl m2\n").Write("a.obj", text);
  const scene::Scene scene = test.Read();
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 1667u);
  ASSERT_EQ(test.warnings.size(), 1u);
  EXPECT_EQ(test.warnings[0],
            "a.obj: 5,000 groups are too many to be kept apart: merged into 3 objects");
}

// The normals at a corner of a roof whose two sides meet at a right angle.
std::set<float> RoofNormals(const std::string& first, const std::string& second) {
  ObjTestScene test;
  test.Write("a.obj", "v 0 0 0\nv 0 0 1\nv 1 -1 1\nv 1 -1 0\nv -1 -1 0\nv -1 -1 1\n" + first +
                          "f 1 2 3 4\n" + second + "f 2 1 5 6\n");
  std::set<float> heights;
  const scene::Scene scene = test.Read();
  for (const scene::Mesh& mesh : scene.meshes)
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      if (mesh.positions[i] == vec3(0))
        heights.insert(mesh.normals.empty() ? 2.0f : std::round(mesh.normals[i].y * 100) / 100);
  return heights;
}

TEST(ObjScene, SmoothingGroups) {
  const std::set<float> smooth = {1.0f}, sharp = {0.71f}, flat = {2.0f};
  EXPECT_EQ(RoofNormals("", ""), sharp);
  EXPECT_EQ(RoofNormals("s 1\n", ""), smooth);
  EXPECT_EQ(RoofNormals("s 1\n", "s 2\n"), sharp);
  EXPECT_EQ(RoofNormals("s 1\n", "s off\n"), sharp);
  EXPECT_EQ(RoofNormals("s 0\n", ""), flat);
  EXPECT_EQ(RoofNormals("s off\n", ""), flat);
  EXPECT_EQ(RoofNormals("", "s 1\n"), sharp);
  EXPECT_EQ(RoofNormals("s on\n", "g other\n"), smooth);
}

TEST(ObjScene, GivenNormalsAndOptionsBeatSmoothingGroups) {
  ObjTestScene test;
  test.Write("a.obj", Square + "v 0 0 1\nvn 1 0 0\ns 1\nf 1//1 2//1 3//1 4//1\nf 1 5 2\n");
  const scene::Scene scene = test.Read();
  EXPECT_EQ(scene.meshes[0].normals[0], vec3(1, 0, 0));
  EXPECT_EQ(scene.meshes[0].normals.back(), vec3(0, 1, 0));

  test.Write("a.obj", Square + "s off\nf 1 2 3 4\n");
  ReadOptions options;
  EXPECT_TRUE(ReadScene(test.folder() / "a.obj", options, nullptr).meshes[0].normals.empty());
  options.smooth = 30.0f;
  EXPECT_FALSE(ReadScene(test.folder() / "a.obj", options, nullptr).meshes[0].normals.empty());
}

TEST(ObjScene, FlatFanOfManyFacesStaysFlat) {
  // A cone of 200 faces around its tip, each with a normal of its own
  std::string text = "s off\nv 0 1 0\n", faces;
  constexpr int Count = 200;
  for (int i = 0; i < Count; ++i) {
    const double angle = 2 * 3.14159265 * i / Count;
    text += "v " + std::to_string(std::cos(angle)) + " 0 " + std::to_string(std::sin(angle)) + "\n";
    faces += "f 1 " + std::to_string((i + 1) % Count + 2) + " " + std::to_string(i + 2) + "\n";
  }
  ObjTestScene test;
  test.Write("a.obj", text + faces + "s 1\nf 2 30 60\n");
  const scene::Scene scene = test.Read();
  const scene::Mesh& mesh = scene.meshes.at(0);
  for (int i = 0; i < Count; ++i) {
    const scene::uvec3 t = mesh.triangles[std::size_t(i)];
    EXPECT_EQ(mesh.normals[t.x], mesh.normals[t.y]) << i;
    EXPECT_EQ(mesh.normals[t.x], mesh.normals[t.z]) << i;
  }
}

TEST(ObjScene, LibrariesAreFoundUnderManyNames) {
  ObjTestScene test;
  test.Write("my first.mtl", "newmtl a\nKd 1 0 0\n")
      .Write("sub/Second.MTL", "newmtl b\nKd 0 1 0\n");
  test.Write("c d.mtl", "newmtl c\nKd 0 0 1\n");
  for (const char* libraries :
       {"my first.mtl SUB\\second.mtl c d.mtl", "My First.mtl C:\\x\\sub\\second.mtl c d.mtl"}) {
    test.WriteTriangles(libraries, {"a", "c"});
    const scene::Scene scene = test.Read();
    ASSERT_EQ(scene.materials.size(), 2u) << libraries;
    EXPECT_EQ(scene.materials[1].physical->baseColor.value, vec3(0, 0, 1));
  }
  test.WriteTriangles("my first.mtl SUB\\second.mtl", {"b"});
  EXPECT_EQ(test.Read().materials.at(0).physical->baseColor.value, vec3(0, 1, 0));
  EXPECT_TRUE(test.warnings.empty());
}

TEST(ObjScene, MissingLibrariesGiveOneWarning) {
  ObjTestScene test;
  test.WriteTriangles("one.mtl two.mtl", {"a", "b"});
  const scene::Scene scene = test.Read();
  EXPECT_EQ(test.error, "");
  EXPECT_EQ(test.warnings, std::vector<std::string>{"a.obj:1: 2 material files not found in the "
                                                    "file's folder, the first one 'one.mtl'"});
  EXPECT_TRUE(scene.materials.empty());
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].material, -1);

  test.Write("one.mtl", "newmtl c\n").WriteTriangles("one.mtl", {"a", "b", "c"}).Read();
  EXPECT_EQ(test.warnings,
            std::vector<std::string>{
                "a.obj:1: 2 materials not defined in any library, the first one 'a'"});
}

TEST(ObjScene, NothingOutsideTheFolderIsRead) {
  ObjTestScene outside;
  outside.Write("x.mtl", "newmtl m\nKd 1 0 0\n");
  ObjTestScene test;
  std::filesystem::create_symlink(outside.folder() / "x.mtl", test.folder() / "link.mtl");
  std::filesystem::create_directory_symlink(outside.folder(), test.folder() / "out");
  const std::string name = outside.folder().filename().string();
  for (const std::string& library :
       {"../" + name + "/x.mtl", (outside.folder() / "x.mtl").string(), std::string("link.mtl"),
        std::string("LINK.MTL"), std::string("out/x.mtl"), std::string("OUT/X.mtl")}) {
    test.WriteTriangles(library, {"m"});
    EXPECT_TRUE(test.Read().materials.empty()) << library;
    EXPECT_EQ(test.warnings.size(), 1u) << library;
  }
}

TEST(ObjScene, ColorsOfVertices) {
  ObjTestScene test;
  test.Write("a.obj", "v 0 0 0 1 0.5 0\nv 1 0 0 nan 0 0\nv 0 1 0\nf 1 2 3\n");
  scene::Scene scene = test.Read();
  ASSERT_EQ(scene.meshes.at(0).colors.size(), 3u);
  EXPECT_NEAR(scene.meshes[0].colors[0].y, 0.2140f, 1e-4f);
  EXPECT_EQ(scene.meshes[0].colors[1], scene::vec4(1.0f));
  EXPECT_EQ(scene.meshes[0].colors[2], scene::vec4(1.0f));

  test.Write("a.obj", "v 0 0 0 1 1 x\nv 1 0 0 more\nv 0 1 0 1\nf 1 2 3\n");
  EXPECT_TRUE(test.Read().meshes.at(0).colors.empty());

  test.Write("a.obj", "v 0 0 0 255 0 127.5\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
  scene = test.Read();
  EXPECT_NEAR(scene.meshes[0].colors[0].z, 0.2140f, 1e-4f);
  EXPECT_EQ(test.warnings.size(), 1u);
}

TEST(ObjScene, EveryCutAndEveryFlippedByteIsSurvived) {
  const std::string obj =
      "mtllib a.mtl\nv 0 0 0 1 0 1\nv 1 0 0\nv 0 1 0\ng a\ns 1\nusemtl m\nf 1 2 3\n"
      "o b\ns off\nusemtl n\nf 1 2 3\n";
  const std::string mtl = "newmtl m\nKd 1 0.5 0\nmap_Kd -s 2 2 -clamp on p.png\nTr 0.5\nNs 10\n";
  ObjTestScene test;
  test.Paint("p.png", vec3(0.5f));
  int good = 0;
  const auto check = [&](const std::string& objText, const std::string& mtlText) {
    test.Write("a.obj", objText).Write("a.mtl", mtlText);
    const scene::Scene scene = test.Read();
    if (!test.error.empty()) return;
    ++good;
    for (const scene::Mesh& mesh : scene.meshes) EXPECT_TRUE(IsSound(mesh));
    for (const scene::Object& object : scene.objects)
      EXPECT_LT(object.material, int(scene.materials.size()));
  };
  for (std::size_t i = 0; i < obj.size(); ++i) {
    check(obj.substr(0, i), mtl);
    for (const int change : {1, 16, 255}) {
      std::string changed = obj;
      changed[i] = char(changed[i] ^ change);
      check(changed, mtl);
    }
  }
  for (std::size_t i = 0; i < mtl.size(); ++i) {
    check(obj, mtl.substr(0, i));
    for (const int change : {1, 16, 255}) {
      std::string changed = mtl;
      changed[i] = char(changed[i] ^ change);
      check(obj, changed);
    }
  }
  EXPECT_GT(good, 100);
}

TEST(ObjScene, FilesOfOthers) {
  const std::filesystem::path meshes =
      std::filesystem::path(SNELL_SOURCE_DIR) / ".." / "shared" / "assets" / "meshes";
  if (!std::filesystem::exists(meshes)) GTEST_SKIP() << "the folder of shared assets is absent";
  const auto read = [&](const char* name) { return ReadObjScene(meshes / name, {}, nullptr); };
  const scene::Scene spider = read("obj-assimp/spider.obj");
  EXPECT_EQ(spider.objects.size(), 19u);
  EXPECT_EQ(spider.images.size(), 4u);
  const scene::Scene fuze = read("obj-trimesh/fuze.obj");
  ASSERT_EQ(fuze.images.size(), 1u);
  EXPECT_TRUE(fuze.images[0].srgb);
  EXPECT_EQ(read("obj-obj2gltf/box-windows-paths/box-windows-paths.obj").images.size(), 1u);
  EXPECT_EQ(read("obj-tinyobj/cornell_box_multimaterial.obj").materials.size(), 4u);
}

TEST(ObjScene, FilesOfOthersGiveErrorsOrValidScenes) {
  namespace fs = std::filesystem;
  const fs::path assets = fs::path(SNELL_SOURCE_DIR) / ".." / "shared" / "assets";
  if (!fs::exists(assets)) GTEST_SKIP() << "the folder of shared assets is absent";
  int good = 0, bad = 0;
  for (const fs::path& folder : {assets / "meshes", assets / "bad"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (LowerExtension(entry.path()) != "obj") continue;
      try {
        const scene::Scene scene = ReadScene(entry.path(), {}, nullptr);
        for (const scene::Mesh& mesh : scene.meshes) EXPECT_TRUE(IsSound(mesh)) << entry.path();
        for (const scene::Texture& texture : scene.textures)
          EXPECT_LT(texture.image, int(scene.images.size())) << entry.path();
        ++good;
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).rfind(entry.path().string(), 0), 0u) << error.what();
        ++bad;
      }
    }
  }
  EXPECT_GT(good, 40);
  EXPECT_GT(bad, 10);
}

}  // namespace
}  // namespace snell::io
