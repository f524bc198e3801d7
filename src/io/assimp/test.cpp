// SPDX-License-Identifier: Apache-2.0
//
// Files that Assimp reads: what becomes of them, and that damaged ones give one error.
#include <gtest/gtest.h>

#include <cstdlib>

#include "io/assimp/assimp.h"
#include "io/assimp/test_files.h"
#include "io/assimp/trial.h"
#include "io/read_scene.h"
#include "io/toml/test_scene.h"

namespace snell::io {
namespace {

using scene::vec3;

class AssimpFile {
 public:
  AssimpFile(const std::string& name, const std::string& text) : name_(name) {
    folder_.Write(name, text);
  }

  scene::Scene Read() {
    warnings.clear();
    error.clear();
    try {
      return ReadAssimp(folder_.folder() / name_, options,
                        [this](const Diagnostic& w) { warnings.push_back(w.message); })
          .scene;
    } catch (const Error& fault) {
      error = fault.diagnostics().front().message;
      return {};
    }
  }

  TestScene& folder() { return folder_; }

  ReadOptions options;
  std::vector<std::string> warnings;
  std::string error;

 private:
  std::string name_;
  TestScene folder_;
};

// The triangle's corners in the world.
std::vector<vec3> Corners(const scene::Scene& scene, std::size_t object = 0) {
  std::vector<vec3> corners;
  const scene::Object& o = scene.objects.at(object);
  const auto& mesh = scene.meshes.at(std::size_t(std::get<scene::MeshGeometry>(o.geometry).mesh));
  for (const vec3& p : mesh.positions)
    corners.emplace_back(o.toWorld * glm::dvec4(glm::dvec3(p), 1.0));
  return corners;
}

void ExpectNear(const std::vector<vec3>& corners, const std::vector<vec3>& expected) {
  ASSERT_EQ(corners.size(), expected.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(corners[i][k], expected[i][k], 1e-5f) << i << k;
}

TEST(Assimp, ColladaWithUnitsAxesInstancesAndPictures) {
  AssimpFile file("a.dae", TriangleDae);
  file.folder().Write("red.png", OnePixel);
  const scene::Scene scene = file.Read();
  ASSERT_EQ(file.error, "");
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.objects[0].name, "left");
  ExpectNear(Corners(scene), {vec3(0), vec3(1, 0, 0), vec3(0, 1, 0)});
  ExpectNear(Corners(scene, 1), {vec3(2, 0, 0), vec3(3, 0, 0), vec3(2, 1, 0)});
  EXPECT_EQ(scene.meshes[0].uvs.at(1), scene::vec2(1, 0));

  const scene::Material& paint = scene.materials.at(std::size_t(scene.objects[0].material));
  EXPECT_EQ(paint.name, "Paint");
  EXPECT_EQ(paint.physical->baseColor.texture, 0);
  EXPECT_EQ(scene.images.size(), 1u);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_NEAR(scene.lights[0].position.y, 3, 1e-5f);
  EXPECT_EQ(scene.lights[0].falloff, scene::Falloff::InverseSquare);
  EXPECT_NEAR(scene.lights[0].strength, 6.2832f, 1e-3f);
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_NEAR(scene.cameras[0].position.z, 5, 1e-5f);
  EXPECT_NEAR(scene.cameras[0].lookAt.z, 0, 1e-5f);
}

TEST(Assimp, FbxWithUnitsAndAxes) {
  AssimpFile file("a.fbx", TriangleFbx);
  const scene::Scene scene = file.Read();
  ASSERT_EQ(file.error, "");
  ExpectNear(Corners(scene), {vec3(0, 0.5f, 0), vec3(1, 0.5f, 0), vec3(0, 1.5f, 0)});
  const scene::Material& blue = scene.materials.at(std::size_t(scene.objects[0].material));
  EXPECT_EQ(blue.name, "blue");
  EXPECT_EQ(blue.physical->baseColor.value, vec3(0, 0, 1));
}

TEST(Assimp, ThreeDsOffAcAndX) {
  for (const auto& [name, text, color] : {std::tuple("a.3ds", Triangle3ds(), vec3(1, 0, 0)),
                                          {"a.ac", std::string(TriangleAc), vec3(1, 0, 0)},
                                          {"a.x", std::string(TriangleX), vec3(0, 1, 0)},
                                          {"a.off", std::string(TriangleOff), vec3(-1)}}) {
    AssimpFile file(name, text);
    const scene::Scene scene = file.Read();
    ASSERT_EQ(file.error, "") << name;
    ASSERT_EQ(scene.objects.size(), 1u) << name;
    EXPECT_EQ(Corners(scene).size(), 3u) << name;
    const int material = scene.objects[0].material;
    if (color.x < 0)
      EXPECT_EQ(material, -1) << name;
    else
      EXPECT_EQ(scene.materials.at(std::size_t(material)).physical->baseColor.value, color) << name;
    EXPECT_NO_THROW(ReadScene(file.folder().folder() / name, {}, {})) << name;
  }
}

TEST(Assimp, ReadsNoPictureOutsideOfTheFolder) {
  TestScene outside;
  outside.Write("secret.png", OnePixel);
  const std::string path = (outside.folder() / "secret.png").string();
  std::string text = TriangleDae;
  text.replace(text.find("red.png"), 7, path);
  AssimpFile file("a.dae", text);
  EXPECT_EQ(file.Read().images.size(), 0u);
  EXPECT_FALSE(file.warnings.empty());
  file.options.folders = {outside.folder()};
  EXPECT_EQ(file.Read().images.size(), 1u);
}

TEST(Assimp, LimitsHold) {
  AssimpFile file("a.off", TriangleOff);
  file.options.limits.fileBytes = 10;
  file.Read();
  EXPECT_NE(file.error.find("the limit is 10"), std::string::npos) << file.error;
  AssimpFile two("a.dae", TriangleDae);
  two.options.limits.objects = 1;
  two.Read();
  EXPECT_EQ(two.error, "it shows more than 1 object");
}

// In a process of their own they may crash, here they must not.
TEST(Assimp, DamagedFilesGiveOneErrorOrASoundScene) {
  int faults = 0;
  for (const auto& [name, text, step] : {std::tuple("a.3ds", Triangle3ds(), 3),
                                         {"a.off", std::string(TriangleOff), 2},
                                         {"a.ac", std::string(TriangleAc), 11},
                                         {"a.x", std::string(TriangleX), 7},
                                         {"a.fbx", std::string(TriangleFbx), 53},
                                         {"a.dae", std::string(TriangleDae), 101}}) {
    AssimpFile file(name, text);
    for (std::size_t i = 0; i < text.size(); i += std::size_t(step)) {
      std::string changed = text;
      changed[i] = char(changed[i] ^ (i % 2 == 0 ? 0x80 : 0x11));
      for (const std::string& damaged : {text.substr(0, i), changed}) {
        file.folder().Write(name, damaged);
        try {
          ReadScene(file.folder().folder() / name, {}, {});
        } catch (const Error& error) {
          EXPECT_EQ(error.diagnostics().size(), 1u) << error.what();
          ++faults;
        }
      }
    }
  }
  EXPECT_GT(faults, 100);
}

TEST(Trial, TellsHowWorkEnds) {
  const TrialLimits limits{std::uint64_t(1) << 30, 1};
  EXPECT_EQ(TryInProcess([] { return std::string(); }, limits), "");
  EXPECT_EQ(TryInProcess([] { return std::string("no such thing"); }, limits), "no such thing");
  EXPECT_EQ(TryInProcess([]() -> std::string { std::abort(); }, limits),
            "the library that reads this format crashed on it: the file is malformed");
  EXPECT_EQ(TryInProcess(
                []() -> std::string {
                  for (volatile bool go = true; go;) {
                  }
                  return "";
                },
                limits),
            "reading it takes too much time or memory");
}

}  // namespace
}  // namespace snell::io
