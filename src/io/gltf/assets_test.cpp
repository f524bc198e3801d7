// SPDX-License-Identifier: Apache-2.0
//
// glTF files that others have made, good and bad.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "io/gltf/test_files.h"
#include "io/read_scene.h"
#include "util/file.h"

namespace snell::io {
namespace {

namespace fs = std::filesystem;

// The folder with files of many origins; it is not part of the repository.
fs::path Assets() { return fs::path(SNELL_SOURCE_DIR) / ".." / "shared" / "assets"; }

std::vector<fs::path> GltfFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = LowerExtension(entry.path());
    if (extension == "gltf" || extension == "glb") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::size_t Triangles(const scene::Scene& scene) {
  std::size_t count = 0;
  for (const scene::Mesh& mesh : scene.meshes) count += mesh.triangles.size();
  return count;
}

TEST(GltfAssets, GoodFilesImport) {
  if (!fs::exists(Assets() / "gltf")) GTEST_SKIP() << "the folder of shared assets is absent";
  for (const fs::path& path : GltfFilesIn(Assets() / "gltf")) {
    const GltfResult result = ReadGltfFile(path);
    EXPECT_EQ(result.error, "") << path;
    for (const scene::Mesh& mesh : result.scene.meshes) EXPECT_TRUE(IsSound(mesh)) << path;
    // One holds meshes only
    if (path.filename() == "texcoord-flip.gltf") continue;
    EXPECT_FALSE(result.scene.objects.empty()) << path;
    EXPECT_NO_THROW(ReadScene(path, {}, nullptr)) << path;
    EXPECT_EQ(ReadGltfFile(path, 0.5).error, "") << path;
  }
}

TEST(GltfAssets, KnownFilesHaveTheirSizes) {
  if (!fs::exists(Assets() / "gltf")) GTEST_SKIP() << "the folder of shared assets is absent";
  const std::map<std::string, std::size_t> known = {{"FlightHelmet/FlightHelmet.gltf", 94722},
                                                    {"ClearCoatTest.glb", 37116},
                                                    {"DenseSphere.glb", 30720},
                                                    {"bunny-meshopt.glb", 144046},
                                                    {"BoxDraco/BoxDraco.gltf", 12},
                                                    {"BoxMeshopt.glb", 12},
                                                    {"BoxInterleaved.glb", 12}};
  for (const auto& [name, triangles] : known)
    EXPECT_EQ(Triangles(ReadGltfFile(Assets() / "gltf" / name).scene), triangles) << name;
}

TEST(GltfAssets, DamagedCompressionIsSurvived) {
  if (!fs::exists(Assets() / "gltf")) GTEST_SKIP() << "the folder of shared assets is absent";
  // The stream of a Draco box in a data URI, and all of a box packed by meshoptimizer
  const std::string draco = ReadFile(Assets() / "gltf/BoxDraco/BoxDraco.gltf");
  const std::string stream = ReadFile(Assets() / "gltf/BoxDraco/0.bin");
  const std::size_t uri = draco.find("0.bin");
  ASSERT_NE(uri, std::string::npos);
  const std::string meshopt = ReadFile(Assets() / "gltf/BoxMeshopt.glb");
  const auto check = [](const std::string& bytes, const char* name) {
    const GltfResult result = ReadGltfText(bytes, {}, name);
    for (const scene::Mesh& mesh : result.scene.meshes) EXPECT_TRUE(IsSound(mesh));
  };
  for (const int change : {1, 16, 128, 255}) {
    for (std::size_t i = 0; i < stream.size(); ++i) {
      std::string changed = stream;
      changed[i] = char(changed[i] ^ change);
      std::string document = draco;
      document.replace(uri, 5, "data:;base64," + Base64(changed));
      check(document, "a.gltf");
    }
    for (std::size_t i = 0; i < meshopt.size(); ++i) {
      std::string changed = meshopt;
      changed[i] = char(changed[i] ^ change);
      check(changed, "a.glb");
    }
  }
}

TEST(GltfAssets, BadFilesGiveErrorsOrSoundScenes) {
  if (!fs::exists(Assets() / "bad")) GTEST_SKIP() << "the folder of shared assets is absent";
  int bad = 0;
  for (const fs::path& path : GltfFilesIn(Assets() / "bad")) {
    try {
      const scene::Scene scene = ReadScene(path, {}, nullptr);
      for (const scene::Mesh& mesh : scene.meshes) EXPECT_TRUE(IsSound(mesh)) << path;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path.string(), 0), 0u) << error.what();
      EXPECT_EQ(error.diagnostics().size(), 1u) << error.what();
      ++bad;
    }
  }
  EXPECT_GT(bad, 50);
}

}  // namespace
}  // namespace snell::io
