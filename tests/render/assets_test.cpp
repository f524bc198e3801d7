// SPDX-License-Identifier: Apache-2.0
//
// Meshes of many programs, opened as users open them: each good one gives a picture of itself in the studio,
// each broken one a picture or one clear error. The files are no part of the repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "render/scene_text.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

fs::path Assets() { return fs::path(SNELL_SOURCE_DIR) / ".." / "shared" / "assets"; }

std::string LowerExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

bool IsMesh(const fs::path& path) {
  const std::string extension = LowerExtension(path);
  return extension == ".obj" || extension == ".ply" || extension == ".stl";
}

std::vector<fs::path> MeshesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && IsMesh(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Render what a file holds, if it holds anything; an error must name the file first and be one line.
bool OpensOrSaysWhy(const fs::path& path) {
  RenderOptions options;
  options.width = options.height = 12;
  options.spp = 1;
  try {
    const Scene scene = LoadScene(path);
    const SceneInfo info = Inspect(scene);
    EXPECT_GT(info.meshTriangles, 0u);
    EXPECT_TRUE(info.bounded);
    const RenderResult result = Render(scene, options);
    EXPECT_TRUE(result.report.warnings.empty()) << result.report.warnings.front();
    EXPECT_GT(MeanOf(result.picture, 1), 0);
    return true;
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.rfind(path.string(), 0), 0u) << what;
    EXPECT_GT(what.size(), path.string().size() + 10) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_EQ(error.diagnostics().size(), 1u) << what;
    return false;
  }
}

TEST(Assets, GoodMeshesGivePictures) {
  if (!fs::exists(Assets() / "meshes")) GTEST_SKIP() << "the folder of shared assets is absent";
  int opened = 0, refused = 0;
  for (const fs::path& path : MeshesBelow(Assets() / "meshes")) {
    SCOPED_TRACE(path.filename());
    ++(OpensOrSaysWhy(path) ? opened : refused);
  }
  EXPECT_GT(opened, 70);
  EXPECT_LT(refused, 20);  // of points, lines, nothing at all
}

// How many triangles a file's faces are, counted by the plainest means; −1 where these do not suffice.
std::int64_t TrianglesIn(const fs::path& path) {
  std::ostringstream buffer;
  buffer << std::ifstream(path, std::ios::binary).rdbuf();
  const std::string bytes = buffer.str();
  std::istringstream lines(bytes);
  std::int64_t triangles = 0;
  std::string line;
  if (LowerExtension(path) == ".obj") {
    // Each face of n corners is n − 2 triangles
    while (std::getline(lines, line)) {
      std::istringstream words(line);
      std::string word;
      if (line.find('\\') != std::string::npos || line.find('\0') != std::string::npos) return -1;
      if (!(words >> word) || word != "f") continue;
      for (triangles -= 2; words >> word && word[0] != '#';) ++triangles;
    }
    return triangles;
  }
  if (LowerExtension(path) == ".stl") {
    // Fifty bytes each after a head of 84, or one "endfacet" each
    std::uint32_t count = 0;
    if (bytes.size() < 84) return -1;
    std::memcpy(&count, bytes.data() + 80, 4);
    if (bytes.size() == 84 + 50 * std::size_t(count)) return count;
    while (std::getline(lines, line)) triangles += line.find("endfacet") != std::string::npos;
    return triangles;
  }
  // PLY as text, with nothing but a list for each face
  std::int64_t vertices = -1, faces = -1, properties = 0;
  bool ascii = false;
  while (std::getline(lines, line) && line.rfind("end_header", 0) != 0) {
    std::istringstream words(line);
    std::string first, second;
    words >> first >> second;
    ascii |= first == "format" && second == "ascii";
    if (first == "element" && vertices < 0 && second == "vertex") {
      words >> vertices;
    } else if (first == "element" && vertices >= 0 && faces < 0 && second == "face") {
      words >> faces;
    } else if (first == "element") {
      return -1;
    } else if (first == "property" && faces >= 0) {
      ++properties;
    }
  }
  if (!ascii || properties != 1) return -1;
  for (std::int64_t i = 0; i < vertices; ++i) std::getline(lines, line);
  for (std::int64_t i = 0; i < faces && std::getline(lines, line); ++i)
    triangles += std::atoi(line.c_str()) - 2;
  return triangles;
}

TEST(Assets, NoTriangleIsLostUnsaid) {
  if (!fs::exists(Assets() / "meshes")) GTEST_SKIP() << "the folder of shared assets is absent";
  int counted = 0;
  for (const fs::path& path : MeshesBelow(Assets() / "meshes")) {
    // What was repaired or left out was said
    bool repaired = false;
    LoadOptions options;
    options.warn = [&](const Diagnostic& warning) {
      for (const char* part : {"face", "facet", "polygon", "triangle", "corner"})
        repaired |= warning.message.find(part) != std::string::npos;
    };
    try {
      const SceneInfo info = Inspect(LoadScene(path, options));
      const std::int64_t expected = TrianglesIn(path);
      if (repaired || expected < 0) continue;
      EXPECT_EQ(std::int64_t(info.meshTriangles), expected) << path;
      ++counted;
    } catch (const Error&) {
      continue;  // what may be refused, the test above knows
    }
  }
  EXPECT_GT(counted, 50);
}

TEST(Assets, BrokenMeshesGivePicturesOrOneError) {
  if (!fs::exists(Assets() / "bad")) GTEST_SKIP() << "the folder of shared assets is absent";
  int refused = 0;
  for (const char* folder : {"obj", "ply", "stl", "empty"}) {
    for (const fs::path& path : MeshesBelow(Assets() / "bad" / folder)) {
      SCOPED_TRACE(path.filename());
      refused += !OpensOrSaysWhy(path);
    }
  }
  EXPECT_GT(refused, 30);
}

}  // namespace
}  // namespace snell::test
