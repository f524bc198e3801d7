// SPDX-License-Identifier: Apache-2.0
//
// info, check, compare, reference and --version.
#include "api/snell.h"
#include "json_values.h"
#include "scratch.h"

namespace snell::test {
namespace {

class Commands : public InScratchFolder {
 protected:
  Commands() { Write("spheres.nff", SpheresScene()); }

  // A picture of one colour.
  void WriteGrey(const std::string& name, float value, int width = 8) {
    Picture picture{width, 8, std::vector<float>(std::size_t(width) * 24, value)};
    PictureOptions options;
    options.exrFloat = true;
    WritePicture(Path(name), picture, options);
  }
};

void ExpectHas(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

TEST_F(Commands, InfoTellsWhatIsInAScene) {
  const Result result = Run({"info", "spheres.nff"});
  EXPECT_EQ(result.status, 0);
  for (const char* part :
       {"spheres.nff\n", "  picture    48 × 32, 1 sample per pixel, whitted\n", "  cameras    1\n",
        "pinhole, at 2.1 1.7 1.3", "  lights     2\n", "point light", "  materials  3\n",
        "  objects    3: mesh 1, sphere 2\n", "  triangles  2 stored, 2 seen\n",
        "  bounds     -6 -6 -0.5 to 6 6 0.5, 12 × 12 × 1 m\n", "  memory     scene "})
    ExpectHas(result.out, part);
}

TEST_F(Commands, InfoAsJson) {
  const Result result = Run({"info", "--json", "spheres.nff"});
  EXPECT_EQ(result.status, 0);
  std::optional<JsonValues> values = ParseJson(result.out);
  ASSERT_TRUE(values) << result.out;
  EXPECT_EQ((*values)["width"], "48");
  EXPECT_EQ((*values)["objects"], "3");
  EXPECT_EQ((*values)["objects_by_kind.sphere"], "2");
  EXPECT_EQ((*values)["triangles_stored"], "2");
  EXPECT_FALSE((*values)["bytes.textures"].empty());
  EXPECT_EQ((*values)["bounds.lower.0"], "-6");
  EXPECT_EQ((*values)["lights.1.kind"], "point light");
}

TEST_F(Commands, CheckSaysOkOrAllErrors) {
  Write("bad.nff", "v\nfrom 1 1\n");
  Write("x.abc", "");
  const Result good = Run({"check", "spheres.nff"});
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.out, "spheres.nff: ok, with 1 warning\n");
  ExpectHas(good.err, "snell: warning: spheres.nff:2:1: ");

  const Result mixed = Run({"check", "bad.nff", "spheres.nff", "missing.obj", "x.abc"});
  EXPECT_EQ(mixed.status, 1);
  EXPECT_EQ(mixed.out, good.out);
  ExpectHas(mixed.err, "snell: error: bad.nff:3:1: ");
  ExpectHas(mixed.err, "snell: error: missing.obj: ");
  ExpectHas(mixed.err, "snell: error: x.abc: the file's kind is not known by its extension; ");
}

TEST_F(Commands, CheckOfAFolderIsATable) {
  std::filesystem::create_directories(Path("all/more"));
  Write("all/b.toml", "[[object]]\nshape = \"sphere\"\n");
  Write("all/more/a.nff", "v\nfrom 1 1\n");
  Write("all/notes.txt", "no scene");
  const Result result = Run({"check", "all"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out,
            "all/b.toml: ok\nall/more/a.nff: 1 error\n2 files read: 1 ok, 1 with errors\n");
  ExpectHas(result.err, "snell: error: all/more/a.nff:3:1: ");
  std::filesystem::create_directories(Path("none"));
  ExpectHas(Run({"check", "none"}).err, "none: the folder holds no scene");
}

TEST_F(Commands, CompareEqualPictures) {
  WriteGrey("a.exr", 0.5f);
  const Result result = Run({"compare", "a.exr", "a.exr", "--tolerance", "0"});
  EXPECT_EQ(result.status, 0);
  for (const char* figure :
       {"FLIP    0 ", "RMSE    0 ", "relMSE  0 ", "PSNR    inf dB", "max     0 "})
    ExpectHas(result.out, figure);
}

TEST_F(Commands, CompareJudgesByTheMetric) {
  WriteGrey("a.exr", 0.5f);
  WriteGrey("b.exr", 0.6f);
  ExpectHas(Run({"compare", "a.exr", "b.exr"}).out, "RMSE    0.1 ");
  ExpectHas(Run({"compare", "a.exr", "b.exr"}).out, "PSNR    24.099 dB");
  EXPECT_EQ(Run({"compare", "a.exr", "b.exr"}).status, 0);
  const auto status = [&](const char* metric, const char* tolerance) {
    return Run({"compare", "a.exr", "b.exr", "--metric", metric, "--tolerance", tolerance}).status;
  };
  ExpectHas(Run({"compare", "a.exr", "b.exr"}).out, "mean    0.600");
  EXPECT_EQ(Run({"compare", "a.exr", "b.exr", "--crop", "0,0,1,1"}).status, 0);
  ExpectHas(Run({"compare", "a.exr", "b.exr", "--crop", "0,0,9999,1"}).err, "outside the picture");
  EXPECT_EQ(status("rmse", "0.09"), 1);
  EXPECT_EQ(status("rmse", "0.11"), 0);
  EXPECT_EQ(status("max", "0.09"), 1);
  EXPECT_EQ(status("max", "0.11"), 0);
  EXPECT_EQ(status("relmse", "0.01"), 1);
  EXPECT_EQ(status("relmse", "0.1"), 0);
  EXPECT_EQ(status("psnr", "25"), 1);
  EXPECT_EQ(status("psnr", "24"), 0);
  EXPECT_EQ(status("flip", "1"), 0);

  const Result result = Run({"compare", "a.exr", "b.exr", "--tolerance", "0.0001"});
  EXPECT_EQ(result.status, 1);
  ExpectHas(result.err, "snell: the pictures differ: FLIP is ");
  ExpectHas(result.err, ", the tolerance is 0.0001\n");
}

TEST_F(Commands, CompareDrawsTheDifference) {
  WriteGrey("a.exr", 0.5f);
  WriteGrey("b.exr", 0.9f);
  EXPECT_EQ(Run({"compare", "a.exr", "b.exr", "-o", "d.png"}).status, 0);
  EXPECT_EQ(ReadPicture(Path("d.png")).width, 8);
  const Result refused = Run({"compare", "missing.exr", "b.exr", "-o", "no/d.png"});
  EXPECT_EQ(refused.status, 1);
  ExpectHas(refused.err, "snell: error: no/d.png: the folder 'no' does not exist");
}

TEST_F(Commands, CompareNeedsPicturesOfOneSize) {
  WriteGrey("a.exr", 0.5f);
  WriteGrey("b.exr", 0.5f, 9);
  const Result result = Run({"compare", "a.exr", "b.exr"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(result.err.starts_with("snell: error: ")) << result.err;
  EXPECT_EQ(Run({"compare", "a.exr", "missing.exr"}).status, 1);
  EXPECT_EQ(Run({"compare", "a.exr", "spheres.nff"}).status, 1);
}

TEST_F(Commands, TheSceneLanguageIsDescribed) {
  const Result page = Run({"reference"});
  EXPECT_EQ(page.status, 0);
  ExpectHas(page.out, "[camera]");
  EXPECT_EQ(Run({"reference", "--markdown"}).out, page.out);
  const Result schema = Run({"reference", "--schema"});
  EXPECT_EQ(schema.status, 0);
  EXPECT_TRUE(ParseJson(schema.out));
}

TEST_F(Commands, VersionTellsBuildAndInstructionSets) {
  const Result result = Run({"--version"});
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(result.out.starts_with("snell " + Version() + "\nbuild: ")) << result.out;
  ExpectHas(result.out, "\ninstruction sets: portable");
  ExpectHas(result.out, "(used: " + InstructionSets().back() + ")\n");
}

}  // namespace
}  // namespace snell::test
