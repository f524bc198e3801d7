// SPDX-License-Identifier: Apache-2.0
//
// snell render: what each option does to the picture and to the report about it.
#include <cmath>

#include "api/snell.h"
#include "json_values.h"
#include "scratch.h"

namespace snell::test {
namespace {

class Rendering : public InScratchFolder {
 protected:
  Rendering() { Write("spheres.nff", SpheresScene()); }

  // Render spheres.nff; the values that --stats gives.
  JsonValues Render(std::vector<std::string> options) {
    std::vector<std::string> arguments = {"render", "spheres.nff", "--quiet", "--stats", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Result result = Run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const std::optional<JsonValues> values = ParseJson(result.out);
    EXPECT_TRUE(values) << result.out;
    return values.value_or(JsonValues());
  }
  Picture Load(const std::string& name) const { return ReadPicture(Path(name)); }

  // The largest difference between two pictures of the same size.
  static double Distance(const Picture& a, const Picture& b) {
    return ComparePictures(a, b).maxAbs;
  }
  static double Mean(const Picture& picture) {
    double sum = 0;
    for (const float value : picture.rgb) sum += double(value);
    return sum / double(picture.rgb.size());
  }
};

TEST_F(Rendering, WithoutANameThePictureIsNamedAfterTheScene) {
  std::filesystem::create_directory(folder_ / "scenes");
  std::filesystem::rename(folder_ / "spheres.nff", folder_ / "scenes/spheres.nff");
  const Result result = Run({"render", "scenes/spheres.nff"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("the picture will be 'spheres.png'"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("written  spheres.png"), std::string::npos) << result.err;
  EXPECT_EQ(Load("spheres.png").width, 48);
}

TEST_F(Rendering, TheSummaryTellsTimesRaysAndMemory) {
  const Result result = Run({"render", "spheres.nff", "--threads", "1"});
  for (const char* part :
       {"48 × 32 pixels, 1 sample per pixel; CPU, ", ", 1 thread\n", "  time     load ", " build ",
        "  rays     1,536 camera, ", " Mrays/s", "  memory   scene ", " at the peak"})
    EXPECT_NE(result.err.find(part), std::string::npos) << part << " is not in " << result.err;
}

TEST_F(Rendering, DenoisedPicturesStandBesideTheOthers) {
  Render({"-o", "a.exr", "-o", "a.png", "--spp", "4", "--denoiser", "nfor"});
  for (const char* name : {"a.exr", "a.png", "a.denoised.exr", "a.denoised.png"})
    EXPECT_EQ(Load(name).width, 48) << name;
  Render({"-o", "b.exr", "--spp", "4"});
  EXPECT_EQ(Distance(Load("a.exr"), Load("b.exr")), 0);
  EXPECT_GT(Distance(Load("a.denoised.exr"), Load("b.exr")), 0);
  EXPECT_NEAR(Mean(Load("a.denoised.exr")), Mean(Load("b.exr")), 0.02 * Mean(Load("b.exr")));
}

TEST_F(Rendering, ViewsChangeWhatIsNotLinear) {
  Render({"-o", "agx.png", "-o", "agx.exr", "--view", "agx"});
  Render({"-o", "raw.png", "-o", "raw.exr", "--view", "raw"});
  EXPECT_EQ(Distance(Load("agx.exr"), Load("raw.exr")), 0);
  EXPECT_GT(Distance(Load("agx.png"), Load("raw.png")), 0.1);
}

TEST_F(Rendering, LayersLeaveThePictureAsItIs) {
  Render({"-o", "plain.exr"});
  Render({"-o", "layers.exr", "--aov", "all"});
  EXPECT_EQ(Distance(Load("plain.exr"), Load("layers.exr")), 0);
  EXPECT_GT(std::filesystem::file_size(Path("layers.exr")),
            3 * std::filesystem::file_size(Path("plain.exr")));
}

TEST_F(Rendering, LayersThatCanBeShownStandBesideAPng) {
  Render({"-o", "a.png", "--aov", "all"});
  for (const char* name : {"albedo", "normal", "depth", "direct", "indirect", "light_other"})
    EXPECT_EQ(Load(std::string("a.") + name + ".png").width, 48) << name;
  EXPECT_FALSE(std::filesystem::exists(Path("a.uv.png")));
}

TEST_F(Rendering, InfoListsTheLayers) {
  Render({"-o", "a.exr", "--aov", "depth,albedo"});
  const Result result = Run({"info", "a.exr"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(
      result.out,
      "a.exr\n  picture    48 × 32\n  layers     3\n             albedo: B (half), G (half), R "
      "(half)\n             depth: Z (float)\n             the picture: B (half), G (half), R "
      "(half)\n");
  EXPECT_NE(Run({"info", "--json", "a.exr"}).out.find("\"depth.Z\": \"float\""), std::string::npos);
}

TEST_F(Rendering, SizeByBothSidesOrOne) {
  Render({"-o", "both.png", "--size", "20x10"});
  Render({"-o", "width.png", "--size", "96"});
  Render({"-o", "height.png", "--size", "x64"});
  EXPECT_EQ(Load("both.png").width, 20);
  EXPECT_EQ(Load("both.png").height, 10);
  EXPECT_EQ(Load("width.png").height, 64);
  EXPECT_EQ(Load("height.png").width, 96);
}

TEST_F(Rendering, SamplesPerPixelAreCounted) {
  JsonValues values = Render({"--spp", "4"});
  EXPECT_EQ(values["picture.samples_per_pixel"], "4");
  EXPECT_EQ(values["picture.complete"], "true");
  EXPECT_EQ(values["rays.camera"], std::to_string(4 * 48 * 32));
}

TEST_F(Rendering, TheLastOfTwoSettingsCounts) {
  EXPECT_EQ(Render({"--spp", "4", "--spp", "2"})["picture.samples_per_pixel"], "2");
}

TEST_F(Rendering, StatisticsAreComplete) {
  JsonValues values = Render({"-o", "a.png", "-o", "a.exr", "--threads", "1"});
  EXPECT_EQ(values["snell"], Version());
  EXPECT_EQ(values["scene"], "spheres.nff");
  EXPECT_EQ(values["threads"], "1");
  EXPECT_EQ(values["picture.width"], "48");
  EXPECT_EQ(values["picture.height"], "32");
  EXPECT_EQ(values["files.0"], "a.png");
  EXPECT_EQ(values["files.1"], "a.exr");
  long long rays = 0;
  for (const char* kind : {"camera", "reflected", "refracted", "shadow"})
    rays += std::stoll(values[std::string("rays.") + kind]);
  EXPECT_EQ(values["rays.total"], std::to_string(rays));
  for (const char* phase : {"load", "prepare", "build", "render", "write", "total"})
    EXPECT_GE(std::stod(values[std::string("seconds.") + phase]), 0) << phase;
  for (const char* owner : {"scene", "bvh", "film", "peak"})
    EXPECT_GT(std::stoll(values[std::string("bytes.") + owner]), 0) << owner;
}

TEST_F(Rendering, StatisticsGoToAFileToo) {
  EXPECT_EQ(Run({"render", "spheres.nff", "-q", "--stats", "stats.json"}).status, 0);
  EXPECT_TRUE(ParseJson(Read("stats.json")));
  EXPECT_EQ(Files(), (std::vector<std::string>{"spheres.nff", "spheres.png", "stats.json"}));
}

TEST_F(Rendering, ThreadsDoNotChangeAByte) {
  Render({"-o", "1.png", "-o", "1.exr", "--spp", "8", "--threads", "1"});
  Render({"-o", "2.png", "-o", "2.exr", "--spp", "8", "--threads", "2"});
  EXPECT_EQ(Read("1.png"), Read("2.png"));
  EXPECT_EQ(Read("1.exr"), Read("2.exr"));
}

TEST_F(Rendering, ACropIsThatPartOfTheWhole) {
  Render({"-o", "whole.exr", "--float", "--spp", "2"});
  Render({"-o", "part.exr", "--float", "--spp", "2", "--crop", "10,5,30,32"});
  const Picture whole = Load("whole.exr");
  const Picture part = Load("part.exr");
  ASSERT_EQ(part.width, 20);
  ASSERT_EQ(part.height, 27);
  for (int y = 0; y < part.height; ++y) {
    for (int i = 0; i < 3 * part.width; ++i) {
      ASSERT_EQ(part.rgb[std::size_t(y * 3 * part.width + i)],
                whole.rgb[std::size_t((y + 5) * 3 * whole.width + 30 + i)]);
    }
  }
}

TEST_F(Rendering, ACropOutsideThePictureIsAnError) {
  const Result result = Run({"render", "spheres.nff", "--crop", "0,0,49,32"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("outside the picture of 48×32 pixels"), std::string::npos)
      << result.err;
}

TEST_F(Rendering, RangesOfSamplesAddUp) {
  Render({"-o", "all.exr", "--float", "--spp", "4"});
  Render({"-o", "first.exr", "--float", "--samples", "0:1"});
  Render({"-o", "rest.exr", "--float", "--samples", "1:4"});
  const Picture all = Load("all.exr");
  const Picture first = Load("first.exr");
  const Picture rest = Load("rest.exr");
  for (std::size_t i = 0; i < all.rgb.size(); ++i)
    ASSERT_NEAR(all.rgb[i], (first.rgb[i] + 3 * rest.rgb[i]) / 4, 1e-5f * (1 + all.rgb[i]));
}

TEST_F(Rendering, DepthLimitsTheChain) {
  JsonValues one = Render({"--max-depth", "1"});
  EXPECT_EQ(one["rays.reflected"], "0");
  EXPECT_EQ(one["rays.refracted"], "0");
  JsonValues two = Render({"--max-depth", "2"});
  JsonValues five = Render({"--max-depth", "5"});
  EXPECT_GT(std::stoi(two["rays.reflected"]), 0);
  EXPECT_GT(std::stoi(five["rays.reflected"]), std::stoi(two["rays.reflected"]));
}

TEST_F(Rendering, SmallContributionsAreCut) {
  JsonValues all = Render({"--min-contribution", "0"});
  JsonValues some = Render({"--min-contribution", "0.2"});
  EXPECT_LT(std::stoi(some["rays.reflected"]), std::stoi(all["rays.reflected"]));
}

TEST_F(Rendering, ExposureBrightensWhatIsNotLinear) {
  Render({"-o", "0.png", "-o", "0.exr", "--bits", "16", "--spp", "4"});
  Render({"-o", "1.png", "-o", "1.exr", "--bits", "16", "--spp", "4", "--exposure", "-1"});
  EXPECT_EQ(Distance(Load("0.exr"), Load("1.exr")), 0);
  Picture dark = Load("0.exr");
  for (float& value : dark.rgb) value /= 2;
  EXPECT_LT(Distance(dark, Load("1.png")), 1e-3);
}

TEST_F(Rendering, BitsFloatAndQualityChangeTheFile) {
  Render({"-o", "a.png", "-o", "a.exr", "-o", "a.jpg"});
  Render(
      {"-o", "b.png", "-o", "b.exr", "-o", "b.jpg", "--bits", "16", "--float", "--quality", "20"});
  // The byte after the size in the header of PNG counts bits
  EXPECT_EQ(Read("a.png")[24], 8);
  EXPECT_EQ(Read("b.png")[24], 16);
  EXPECT_LT(Read("b.jpg").size(), Read("a.jpg").size());
  // Half floats round, floats do not
  EXPECT_GT(Distance(Load("a.exr"), Load("b.exr")), 0);
  EXPECT_LT(Distance(Load("a.exr"), Load("b.exr")), 2e-3);
}

TEST_F(Rendering, AllFormatsShowTheSamePicture) {
  Render(
      {"-o", "a.exr", "-o", "a.png", "-o", "a.hdr", "-o", "a.jpg", "--bits", "16", "--spp", "4"});
  const Picture exr = Load("a.exr");
  EXPECT_LT(ComparePictures(exr, Load("a.png")).meanFlip, 0.003);
  EXPECT_LT(ComparePictures(exr, Load("a.hdr")).meanFlip, 0.01);
  EXPECT_LT(ComparePictures(exr, Load("a.jpg")).meanFlip, 0.05);
}

TEST_F(Rendering, PicturesTellWhereTheyComeFrom) {
  Render({"-o", "a.png", "-o", "a.exr", "--spp", "3"});
  for (const char* name : {"a.png", "a.exr"}) {
    const std::string bytes = Read(name);
    EXPECT_NE(bytes.find("Snell " + Version()), std::string::npos) << name;
    EXPECT_NE(bytes.find("spheres.nff"), std::string::npos) << name;
    EXPECT_NE(bytes.find("Samples"), std::string::npos) << name;
  }
  // And nothing that changes from run to run
  Render({"-o", "b.png", "-o", "b.exr", "--spp", "3"});
  EXPECT_EQ(Read("a.png"), Read("b.png"));
  EXPECT_EQ(Read("a.exr"), Read("b.exr"));
}

TEST_F(Rendering, QuietMeansNothingButErrors) {
  // A picture that is wider than high gives a warning in this format
  const Result loud = Run({"render", "spheres.nff"});
  EXPECT_NE(loud.err.find("snell: warning: spheres.nff:"), std::string::npos);
  const Result quiet = Run({"render", "spheres.nff", "--quiet"});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const Result wrong = Run({"render", "missing.nff", "-q"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_EQ(wrong.err,
            "snell: error: missing.nff: cannot read the file: No such file or directory\n");
}

TEST_F(Rendering, NamesMayHaveSpacesAndAnyLetters) {
  const std::string name = "zwei Küs'se \"日本\".nff";
  Write(name, SpheresScene());
  std::filesystem::create_directory(folder_ / "ein Ordner");
  const Result result = Run({"render", name, "-o", "ein Ordner/bild ö.png", "--stats", "-"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(Load("ein Ordner/bild ö.png").width, 48);
  EXPECT_TRUE(ParseJson(result.out)) << result.out;
}

TEST_F(Rendering, ScenesAreReadFromAnyFolder) {
  std::filesystem::create_directories(folder_ / "else/where");
  Surroundings elsewhere;
  elsewhere.folder = folder_ / "else/where";
  EXPECT_EQ(Run({"render", "../../spheres.nff", "-o", "a.png"}, elsewhere).status, 0);
  EXPECT_EQ(Run({"render", Path("spheres.nff"), "-o", "../b.png"}, elsewhere).status, 0);
  EXPECT_EQ(Read("else/where/a.png"), Read("else/b.png"));
}

TEST_F(Rendering, CamerasAreChosenByName) {
  Write("two.toml",
        "[render]\nsize = [32, 24]\nspp = 1\n"
        "[[camera]]\nname = \"near\"\nposition = [0, 0, 3]\nlook_at = [0, 0, 0]\n"
        "[[camera]]\nname = \"far\"\nposition = [0, 0, 30]\nlook_at = [0, 0, 0]\n"
        "[environment]\ncolor = [0, 0, 1]\n"
        "[[light]]\ntype = \"point\"\nposition = [0, 0, 40]\nintensity = 5000\n"
        "[[object]]\nshape = \"sphere\"\n");
  const auto render = [&](std::vector<std::string> options, const char* name) {
    options.insert(options.begin(), {"render", "two.toml", "-q", "-o", name});
    const Result result = Run(options);
    EXPECT_EQ(result.status, 0) << result.err;
  };
  render({}, "first.exr");
  render({"--camera", "near"}, "near.exr");
  render({"--camera", "far"}, "far.exr");
  EXPECT_EQ(Read("first.exr"), Read("near.exr"));
  EXPECT_GT(Distance(Load("near.exr"), Load("far.exr")), 0.1);

  const Result wrong = Run({"render", "two.toml", "--camera", "nera", "-q"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_EQ(wrong.err,
            "snell: error: two.toml: the scene has no camera 'nera'; did you mean 'near'?\n");
}

TEST_F(Rendering, MeshesNeedNoScene) {
  // A tent that is long in x and high in z
  Write("tent.obj",
        "v -2 -0.3 0\nv 2 -0.3 0\nv 2 0.3 0\nv -2 0.3 0\nv -2 0 1\nv 2 0 1\n"
        "f 1 2 6 5\nf 3 4 5 6\nf 4 1 5\nf 2 3 6\nf 4 3 2 1\n");
  const auto render = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "tent.obj", "-q", "--size", "32x24", "--spp", "1"});
    const Result result = Run(options);
    EXPECT_EQ(result.status, 0) << result.err;
  };
  render({"-o", "y.exr", "--up", "y"});
  render({"-o", "standard.exr"});
  render({"-o", "z.exr", "--up", "z"});
  render({"-o", "smooth.exr", "--up", "z", "--smooth", "180"});
  EXPECT_EQ(Read("y.exr"), Read("standard.exr"));
  EXPECT_GT(Mean(Load("y.exr")), 0.01);
  EXPECT_GT(Distance(Load("y.exr"), Load("z.exr")), 0.01);
  EXPECT_GT(Distance(Load("z.exr"), Load("smooth.exr")), 0.01);

  // Scenes say themselves what is up
  const Result result = Run({"render", "spheres.nff", "--up", "z"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("--up and --smooth are for mesh files"), std::string::npos);
}

TEST_F(Rendering, ABadSceneIsToldLineByLine) {
  Write("bad.nff", "v\nfrom 1 1\ns 0 0 0 -1\n");
  const Result result = Run({"render", "bad.nff"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  std::istringstream lines(result.err);
  int errors = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("snell: error: bad.nff:")) ++errors;
  EXPECT_GE(errors, 1) << result.err;
  EXPECT_FALSE(Exists("bad.png"));
}

}  // namespace
}  // namespace snell::test
