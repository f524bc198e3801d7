// SPDX-License-Identifier: Apache-2.0
//
// ReadMesh as a whole: formats by extension and contents, and files that others have made, good and bad.
#include "io/mesh/read_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/mesh/test_files.h"

namespace snell::io {
namespace {

namespace fs = std::filesystem;

const std::string Obj = "# by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string Ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string Stl =
    "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid one\n";

TEST(ReadMesh, ExtensionsInAnyCase) {
  for (const auto& [name, bytes] : {std::pair("a.obj", Obj),
                                    {"a.OBJ", Obj},
                                    {"a.ply", Ply},
                                    {"a.Ply", Ply},
                                    {"a.stl", Stl},
                                    {"b.c.STL", Stl}}) {
    const MeshResult result = ReadText(name, bytes);
    EXPECT_EQ(result.error, "") << name;
    EXPECT_EQ(result.mesh.triangles.size(), 1u) << name;
  }
  EXPECT_EQ(KnownMeshExtensions(), "obj, ply, stl");
}

TEST(ReadMesh, UnknownExtensionsGoByContents) {
  for (const std::string& bytes : {Obj, Ply, Stl}) {
    for (const char* name : {"mesh", "mesh.txt", ".hidden"}) {
      const MeshResult result = ReadText(name, bytes);
      EXPECT_EQ(result.error, "");
      EXPECT_EQ(result.mesh.triangles.size(), 1u);
    }
  }
  EXPECT_EQ(ReadText("mesh", "hello world\n").error,
            "mesh: not a mesh in a known format; meshes are read from obj, ply, stl");
  EXPECT_EQ(ReadText("mesh", "").error,
            "mesh: not a mesh in a known format; meshes are read from obj, ply, stl");
}

TEST(ReadMesh, WarningsAreOptionalAndFilesMustExist) {
  const TemporaryFile file("a.obj", Obj + "bleh\n");
  EXPECT_EQ(ReadMesh(file.path(), {}, nullptr).size(), 1u);
  EXPECT_THROW(ReadMesh(file.path().parent_path() / "none.obj", {}, nullptr), Error);
  EXPECT_THROW(ReadMesh(file.path().parent_path(), {}, nullptr), Error);
}

// The folder with files of many origins; it is not part of the repository.
fs::path Assets() { return fs::path(SNELL_SOURCE_DIR) / ".." / "shared" / "assets"; }

std::vector<fs::path> MeshesIn(const std::vector<fs::path>& folders) {
  std::vector<fs::path> files;
  for (const fs::path& folder : folders) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      const std::string extension = LowerExtension(entry.path());
      const bool known = extension == "obj" || extension == "ply" || extension == "stl";
      if (known || (extension.empty() && entry.is_regular_file())) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ReadMesh, GoodFilesOfOthers) {
  if (!fs::exists(Assets() / "meshes")) GTEST_SKIP() << "the folder of shared assets is absent";

  // Some hold no faces, and one has numbers that are none, as in "3.1+e2"
  const std::map<std::string, std::string> refused = {
      {"testline.obj", "no faces"},
      {"testpoints.obj", "no faces"},
      {"line-prim.obj", "no faces"},
      {"points-prim.obj", "no faces"},
      {"mesh-primitive-lines.obj", "no faces"},
      {"mesh-negative-indices.obj", "no faces"},
      {"mesh-texture-coordinates-normals.obj", "no faces"},
      {"points.ply", "no faces"},
      {"int_point_cloud.ply", "no faces"},
      {"points_ascii.ply", "no faces"},
      {"points_bin.ply", "no faces"},
      {"empty.ply", "no faces"},
      {"number_formats.obj", "'3.1+e2' is not a number"}};
  int good = 0;
  for (const fs::path& path : MeshesIn({Assets() / "meshes"})) {
    const auto expected = refused.find(path.filename().string());
    try {
      const scene::Mesh mesh = ReadMesh(path, {}, nullptr).at(0);
      EXPECT_TRUE(IsSound(mesh)) << path;
      EXPECT_EQ(mesh.normals.size(), mesh.positions.size()) << path;
      EXPECT_EQ(expected, refused.end()) << path;
      ++good;
    } catch (const Error& error) {
      ASSERT_NE(expected, refused.end()) << error.what();
      EXPECT_NE(std::string(error.what()).find(expected->second), std::string::npos)
          << error.what();
    }
  }
  EXPECT_GT(good, 50);
}

TEST(ReadMesh, KnownMeshesHaveTheirSizes) {
  if (!fs::exists(Assets() / "meshes")) GTEST_SKIP() << "the folder of shared assets is absent";
  const std::map<std::string, std::pair<std::size_t, double>> known = {
      // triangles and volume; 0 for meshes that are not closed
      {"bunny/bun_zipper.ply", {69451, 0}},
      {"armadillo.obj", {86482, 0}},
      {"spot/spot_triangulated.obj", {5856, 0}},
      {"stl-trimesh/unit_cube.STL", {12, 1}},
      {"ply-assimp/cube_binary.ply", {12, 1}},
      {"obj-obj2gltf/box-normals/box-normals.obj", {12, 8}}};
  for (const auto& [name, size] : known) {
    const scene::Mesh mesh = ReadMesh(Assets() / "meshes" / name, {}, nullptr).at(0);
    EXPECT_EQ(mesh.triangles.size(), size.first) << name;
    if (size.second > 0) {
      EXPECT_NEAR(Volume(mesh), size.second, 1e-5) << name;
    }
  }
}

TEST(ReadMesh, BadFilesOfOthersGiveErrorsOrSoundMeshes) {
  if (!fs::exists(Assets() / "bad")) GTEST_SKIP() << "the folder of shared assets is absent";
  int bad = 0;
  const fs::path folder = Assets() / "bad";
  for (const fs::path& path :
       MeshesIn({folder / "obj", folder / "ply", folder / "stl", folder / "empty"})) {
    try {
      EXPECT_TRUE(IsSound(ReadMesh(path, {}, nullptr).at(0))) << path;
    } catch (const Error& error) {
      // The message begins with the file's name and a place, or the file's name alone
      EXPECT_EQ(std::string(error.what()).rfind(path.string(), 0), 0u) << error.what();
      ++bad;
    }
  }
  EXPECT_GT(bad, 30);
}

TEST(ReadMesh, EveryCutAndEveryFlippedByteIsSurvived) {
  // Small files of each kind, cut anywhere, and with every byte changed in some ways
  const std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\n"
      "property char z\nelement face 1\nproperty list uchar uchar vertex_indices\nend_header\n" +
      std::string("\0\0\0\1\0\0\0\1\0\3\0\1\2", 13);
  int sound = 0;
  const auto check = [&](const char* name, const std::string& bytes) {
    const MeshResult result = ReadText(name, bytes);
    if (result.error.empty()) {
      EXPECT_TRUE(IsSound(result.mesh)) << bytes;
      ++sound;
    }
  };
  for (const auto& [name, bytes] :
       {std::pair("a.obj", Obj), {"a.ply", Ply}, {"a.stl", Stl}, {"b.ply", binary}}) {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      check(name, bytes.substr(0, i));
      for (const int change : {1, 16, 128, 255}) {
        std::string changed = bytes;
        changed[i] = char(changed[i] ^ change);
        check(name, changed);
      }
    }
  }
  EXPECT_GT(sound, 0);
}

// What reading "a.obj" with a later shape gives.
MeshResult ReadShapes(const std::string& first, const std::string& later) {
  const TemporaryFile file("b.obj", later);
  MeshReadOptions options;
  options.shapes = {{1, file.path()}, {3, file.path()}};
  MeshResult result = ReadText("a.obj", first, options);
  const std::string folder = file.path().parent_path().string() + "/";
  if (const std::size_t at = result.error.find(folder); at != std::string::npos)
    result.error.erase(at, folder.size());
  return result;
}

TEST(ReadMesh, ShapesAreCutAndSmoothedAsTheMeshIs) {
  // Two quadrilaterals that lie flat and then fold beyond the crease angle, and whose shorter diagonals change
  const std::string faces = "f 1 2 5 4\nf 2 3 6 5\n";
  const MeshResult result =
      ReadShapes("v 0 0 0\nv 2 0 0\nv 4 0 0\nv 0.5 1 0\nv 2.1 1 0\nv 4 1 0\n" + faces,
                 "v 0 0 2\nv 2 0 0\nv 4 0 2\nv -0.5 1 2\nv 1.9 1 0\nv 4 1 2\n" + faces);
  ASSERT_EQ(result.error, "");
  const scene::Mesh& mesh = result.mesh;
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.time, 1);
  ASSERT_EQ(mesh.keys.size(), 1u);
  EXPECT_EQ(mesh.keys[0].time, 3);
  EXPECT_EQ(mesh.keys[0].positions, mesh.positions) << "both keys are of the later file";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    // Where the faces meet the normals point up, elsewhere across them
    const scene::vec3 p = mesh.positions[i], n = mesh.normals[i];
    EXPECT_GT(n.z, p.z == 0 ? 0.9f : 0.6f);
    EXPECT_EQ(n.x > 0.5f, p.x < 1 && p.z > 0);
  }
}

TEST(ReadMesh, ShapesOfOtherMeshesAreRefused) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const std::string mesh = vertices + "f 1 2 3\nf 1 3 4\n";
  const std::string start = "b.obj: its shape is no other one of 'a.obj': ";
  const std::string hint = "; files of one mesh have the same faces in the same order";
  EXPECT_EQ(ReadShapes(mesh, vertices + "f 1 2 3\n").error,
            start + "it has 4 vertices and 1 face, that one 4 and 2" + hint);
  EXPECT_EQ(ReadShapes(mesh, vertices + "f 1 2 3\nf 1 4 3\n").error,
            start + "its faces connect other vertices" + hint);
  EXPECT_EQ(ReadShapes(mesh, "v 1e30 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n").error,
            start + "its vertex 1 is infinite, huge or undefined" + hint);
}

}  // namespace
}  // namespace snell::io
