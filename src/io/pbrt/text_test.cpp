// SPDX-License-Identifier: Apache-2.0
//
// Words, parameters, files that include others, and the places of mistakes.
#include <gtest/gtest.h>

#include "io/pbrt/test_scene.h"

namespace snell::io {
namespace {

std::string ErrorOf(const std::string& text) {
  PbrtTestScene file;
  file.Read(text);
  return file.error;
}

TEST(PbrtText, SeparatesWordsByBracketsQuotesAndComments) {
  PbrtTestScene file;
  const scene::Scene scene = file.Read(
      "# a comment \"with quotes\"\r\nWorldBegin#another\n"
      "LightSource\"point\"\"rgb I\"[1 2\n3]\"point3 from\"[.5 -1e0 +2.]\n"
      "Shape \"sphere\" \"float radius\" 2 # 3\n");
  EXPECT_EQ(file.error, "");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].color, scene::Spectrum(1, 2, 3));
  EXPECT_EQ(scene.lights[0].position, scene::vec3(0.5f, -1, -2));
  EXPECT_EQ(std::get<scene::Sphere>(scene.objects.at(0).geometry).radius, 2);
}

TEST(PbrtText, SaysWhereAMistakeIs) {
  EXPECT_EQ(ErrorOf("WorldBegin\n  Shpae \"sphere\""),
            "a.pbrt:2:3: there is no statement 'Shpae'; did you mean 'Shape'?");
  EXPECT_EQ(ErrorOf("WorldBegin\nShape \"sphere\" \"float radius\" [ 1"),
            "a.pbrt:2:31: the bracket is never closed");
  EXPECT_EQ(ErrorOf("WorldBegin Shape \"sphere"),
            "a.pbrt:1:18: the string has no closing quote on its line");
  EXPECT_EQ(ErrorOf("WorldBegin Shape \"sphere\" \"string radius\" \"big\""),
            "a.pbrt:1:27: parameter 'radius' must be of type float, not string");
  EXPECT_EQ(ErrorOf("WorldBegin Shape \"sphere\" \"float radius\" true"),
            "a.pbrt:1:42: parameter 'radius' needs a number, not 'true'");
  EXPECT_EQ(ErrorOf("Translate 1 2\nWorldBegin"),
            "a.pbrt:2:1: Translate needs 3 numbers, not 'WorldBegin'");
  EXPECT_EQ(ErrorOf("WorldBegin AttributeEnd"), "a.pbrt:1:12: 'AttributeEnd' has no beginning");
  EXPECT_EQ(ErrorOf("WorldBegin\nAttributeBegin"), "a.pbrt:2:1: 'AttributeBegin' has no end");
  EXPECT_EQ(ErrorOf("WorldBegin\nAttributeBegin TransformEnd"),
            "a.pbrt:2:16: 'TransformEnd' has no beginning");
  EXPECT_EQ(ErrorOf("WorldBegin Scale 0 1 1\nShape \"sphere\""),
            "a.pbrt:2:1: object 'sphere' has a singular transform");
  EXPECT_EQ(ErrorOf("WorldBegin\nShape \"trianglemesh\" \"integer indices\" [ 0 1 7 ] "
                    "\"point3 P\" [ 0 0 0 1 0 0 0 1 0 ]"),
            "a.pbrt:2:22: there is no vertex 7: the mesh has 3");
}

TEST(PbrtText, RefusesWhatIsNoScene) {
  EXPECT_EQ(ErrorOf(""),
            "a.pbrt: the file has no 'WorldBegin'; it may be a part that another file includes");
  EXPECT_NE(ErrorOf(std::string("Camera\0", 7)), "");
  EXPECT_NE(ErrorOf("WorldBegin Shape \"sphere\" \"float radius\" 1e60"), "");
  EXPECT_NE(ErrorOf("WorldBegin Shape \"sphere\" \"float radius\" nan"), "");
  EXPECT_NE(ErrorOf("WorldBegin NamedMaterial \"x\""), "");
  EXPECT_NE(ErrorOf("WorldBegin ObjectInstance \"x\""), "");
  EXPECT_NE(ErrorOf("WorldBegin CoordSysTransform \"x\""), "");
  EXPECT_NE(ErrorOf("WorldBegin Material \"diffuse\" \"texture reflectance\" \"x\""), "");
  EXPECT_NE(ErrorOf("Shape \"sphere\""), "");
  EXPECT_NE(ErrorOf("WorldBegin Camera \"perspective\""), "");
}

TEST(PbrtText, DeepNestingIsRefused) {
  std::string text = "WorldBegin";
  for (int i = 0; i < 100'000; ++i) text += " AttributeBegin";
  EXPECT_NE(ErrorOf(text).find("nested too deeply"), std::string::npos);
}

TEST(PbrtText, ReportsParametersThatNobodyReads) {
  PbrtTestScene file;
  file.ReadWorld("Material \"diffuse\" \"float colour\" 1 Material \"diffuse\" \"float colour\" 1");
  EXPECT_TRUE(file.Warned("2 'colour' parameters not used by Material 'diffuse'"));
}

TEST(PbrtText, WordsWithoutEndGiveAFewWarnings) {
  PbrtTestScene file;
  std::string text;
  for (int i = 0; i < 1000; ++i)
    text += "Material \"diffuse\" \"float x" + std::to_string(i) + "\" 1\n";
  file.ReadWorld(text);
  EXPECT_EQ(file.error, "");
  EXPECT_LE(file.warnings.size(), 210u);
  EXPECT_TRUE(file.Warned("800 further findings not shown"));
}

TEST(PbrtFiles, IncludeTakesPartAndImportStaysApart) {
  PbrtTestScene file;
  file.Write("parts/move.pbrt", "Translate 1 0 0 Shape \"sphere\" Include \"parts/more.pbrt\"");
  file.Write("parts/more.pbrt", "Translate 0 1 0");
  scene::Scene scene =
      file.Read("WorldBegin LightSource \"point\" Include \"parts/move.pbrt\" Shape \"sphere\"");
  ASSERT_EQ(scene.objects.size(), 2u) << file.error;
  EXPECT_EQ(glm::dvec3(scene.objects[1].toWorld[3]), glm::dvec3(1, 1, 0));
  scene = file.Read("WorldBegin LightSource \"point\" Import \"parts/move.pbrt\" Shape \"sphere\"");
  ASSERT_EQ(scene.objects.size(), 2u) << file.error;
  EXPECT_EQ(glm::dvec3(scene.objects[0].toWorld[3]), glm::dvec3(1, 0, 0));
  EXPECT_EQ(glm::dvec3(scene.objects[1].toWorld[3]), glm::dvec3(0, 0, 0));
}

TEST(PbrtFiles, MistakesInPartsHaveTheirPlace) {
  PbrtTestScene file;
  file.Write("part.pbrt", "\n Oops");
  file.Read("WorldBegin Include \"part.pbrt\"");
  EXPECT_EQ(file.error, "part.pbrt:2:2: there is no statement 'Oops'");
}

TEST(PbrtFiles, NothingOutsideTheFolderIsRead) {
  PbrtTestScene outside, file;
  outside.Write("secret.pbrt", "Shape \"sphere\"");
  const std::string secret = (outside.folder() / "secret.pbrt").string();
  const std::string up = "../" + outside.folder().filename().string() + "/secret.pbrt";
  std::filesystem::create_symlink(secret, file.folder() / "link.pbrt");
  for (const std::string& name : {secret, up, std::string("link.pbrt")}) {
    file.Read("WorldBegin Include \"" + name + "\"");
    EXPECT_NE(file.error.find("is not found in the scene's folder"), std::string::npos) << name;
  }
}

TEST(PbrtFiles, FilesThatIncludeThemselvesAreRefused) {
  PbrtTestScene file;
  file.Read("WorldBegin Include \"a.pbrt\"");
  EXPECT_EQ(file.error, "a.pbrt:1:12: the file 'a.pbrt' includes itself");
  file.Write("b.pbrt", "Include \"c.pbrt\"").Write("c.pbrt", "Include \"b.pbrt\"");
  file.Read("WorldBegin Include \"b.pbrt\"");
  EXPECT_EQ(file.error, "c.pbrt:1:1: the file 'b.pbrt' includes itself");
}

// Each file includes the next one twice: 2^20 files in all.
TEST(PbrtFiles, FilesThatMultiplyAreRefused) {
  PbrtTestScene file;
  for (int i = 0; i < 20; ++i) {
    const std::string next = "Include \"" + std::to_string(i + 1) + ".pbrt\"\n";
    file.Write(std::to_string(i) + ".pbrt", next + next);
  }
  file.Write("20.pbrt", "");
  file.Read("WorldBegin Include \"0.pbrt\"");
  EXPECT_NE(file.error.find("files are included"), std::string::npos) << file.error;
}

TEST(PbrtFiles, CompressedFilesAreRefused) {
  PbrtTestScene file;
  file.Read("WorldBegin Include \"a.pbrt.gz\"");
  EXPECT_NE(file.error.find("unpack it with gunzip"), std::string::npos);
  file.Read("WorldBegin Shape \"plymesh\" \"string filename\" \"a.ply.gz\"");
  EXPECT_NE(file.error.find("unpack it with gunzip"), std::string::npos);
  file.Write("b.pbrt.gz", "");
  EXPECT_THROW(ReadScene(file.folder() / "b.pbrt.gz", {}, nullptr), Error);
}

}  // namespace
}  // namespace snell::io
