// SPDX-License-Identifier: Apache-2.0
//
// pbrt scenes that others have made, good and bad, and scenes that are cut off or damaged.
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "io/mesh/test_files.h"
#include "io/pbrt/test_scene.h"
#include "util/file.h"

namespace snell::io {
namespace {

namespace fs = std::filesystem;

// The folder with files of many origins; it is not part of the repository.
fs::path Assets() { return fs::path(SNELL_SOURCE_DIR) / ".." / "shared" / "assets"; }

std::vector<fs::path> ScenesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (LowerExtension(entry.path()) == "pbrt") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(PbrtAssets, GoodFilesAreRead) {
  if (!fs::exists(Assets() / "pbrt")) GTEST_SKIP() << "the folder of shared assets is absent";
  std::size_t whole = 0, parts = 0;
  for (const fs::path& path : ScenesIn(Assets() / "pbrt")) {
    try {
      const scene::Scene scene = ReadScene(path, {}, nullptr);
      for (const scene::Mesh& mesh : scene.meshes) EXPECT_TRUE(IsSound(mesh)) << path;
      ++whole;
    } catch (const Error& error) {
      // Parts that others include, and scenes that need files from elsewhere
      const std::string what = error.what();
      EXPECT_TRUE(what.find("WorldBegin") != std::string::npos ||
                  what.find("resources") != std::string::npos)
          << what;
      ++parts;
    }
  }
  EXPECT_GE(whole, 60u);
  EXPECT_LE(parts, 4u);
}

TEST(PbrtAssets, BadFilesGiveOneErrorOrWarnings) {
  if (!fs::exists(Assets() / "bad" / "pbrt"))
    GTEST_SKIP() << "the folder of shared assets is absent";
  std::size_t refused = 0;
  for (const fs::path& path : ScenesIn(Assets() / "bad")) {
    std::size_t warnings = 0;
    try {
      ReadScene(path, {}, [&](const Diagnostic&) { ++warnings; });
      EXPECT_GT(warnings, 0u) << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.diagnostics().size(), 1u) << path;
      EXPECT_EQ(std::string(error.what()).rfind(path.string(), 0), 0u) << error.what();
      ++refused;
    }
  }
  EXPECT_GE(refused, 9u);
}

// A scene with a bit of everything, to be damaged.
const char* const Everything = R"(Option "integer seed" 3
LookAt 0 1 -5  0 0 0  0 1 0
Camera "perspective" "float fov" 40 "float screenwindow" [ -1 1 -1 1 ]
Film "rgb" "integer xresolution" 8 "integer yresolution" 8 "float iso" 200
Sampler "halton" "integer pixelsamples" 4
WorldBegin
LightSource "infinite" "blackbody L" 5000
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [ 4 4 4 ] "bool twosided" true
  Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point3 P" [ 0 4 0  1 4 0  0 4 1 ]
AttributeEnd
Texture "t" "spectrum" "checkerboard" "float uscale" 8 "rgb tex1" [ 1 0 0 ]
Texture "m" "spectrum" "mix" "texture tex1" "t" "rgb tex2" [ 0 0 1 ] "float amount" 0.3
MakeNamedMaterial "gold" "string type" "conductor" "spectrum eta" "metal-Au-eta"
MakeNamedMaterial "red" "string type" "diffuse" "texture reflectance" "t"
Material "mix" "string materials" [ "gold" "red" ] "float amount" 0.5
ObjectBegin "o" Shape "sphere" "float zmin" -0.5 "float phimax" 200 ObjectEnd
Translate 1 0 0 Rotate 30 0 1 0 Scale 1 2 1
ObjectInstance "o"
Material "dielectric" "spectrum eta" [ 400 1.6 700 1.5 ] "float roughness" 0.1
ReverseOrientation Shape "disk" "float radius" 2
Shape "bilinearmesh" "point3 P" [ 0 0 0 1 0 0 0 1 0 1 1 1 ]
)";

TEST(PbrtDamage, CutAndChangedScenesGiveOneErrorOrAScene) {
  PbrtTestScene file;
  const std::string whole = Everything;
  file.Read(whole);
  EXPECT_EQ(file.error, "");
  for (std::size_t length = 0; length < whole.size(); length += 7)
    file.Read(whole.substr(0, length));

  std::istringstream text(whole);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  std::mt19937 random(1);
  const char* const strange[] = {"0",          "-1", "1e30", "[", "]", "\"", "\"string type\"",
                                 "2147483647", "#"};
  for (int i = 0; i < 500; ++i) {
    std::vector<std::string> changed = words;
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = random() % changed.size();
      const std::size_t kind = random() % 12;
      if (kind < 9) changed[at] = strange[kind];
      if (kind == 9) changed.erase(changed.begin() + std::ptrdiff_t(at));
      if (kind >= 10) std::swap(changed[at], changed[random() % changed.size()]);
    }
    std::string made;
    for (const std::string& word : changed) made += word + " ";
    file.Read(made);
  }
}

}  // namespace
}  // namespace snell::io
