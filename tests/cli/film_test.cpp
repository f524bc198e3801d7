// SPDX-License-Identifier: Apache-2.0
//
// Long renders: killed at any moment and resumed, in parts that are merged, ended by time or noise. The picture must be
// the same to the bit.
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "api/snell.h"
#include "json_values.h"
#include "scratch.h"

namespace snell::test {
namespace {

using Words = std::vector<std::string>;

class LongRenders : public InScratchFolder {
 protected:
  LongRenders() {
    Write("spheres.nff", SpheresScene("96 64"));
    Write("room.toml",
          "[render]\nintegrator = 'path'\nsize = [48, 32]\n[camera]\nposition = [0, 1, 3.5]\n"
          "look_at = [0, 1, 0]\nfov = 40\n[[light]]\ntype = 'rectangle'\ncorner = [-0.5, 1.99, "
          "-0.5]\nedge_u = [1, 0, 0]\nedge_v = [0, 0, 1]\nradiance = 8\n[[object]]\nshape = 'box'\n"
          "min = [-1, 0, -1]\nmax = [1, 2, 4]\n[[object]]\nshape = 'sphere'\n"
          "center = [0.3, 0.4, 0]\nradius = 0.4\n");
    here_.folder = folder_;
  }

  static Words Join(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  // Run the program, which must succeed.
  std::string Succeed(const Words& words) const {
    const Result result = Run(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.err;
  }
  std::string ErrorOf(const Words& words, int status = 1) const {
    const Result result = Run(words);
    EXPECT_EQ(result.status, status) << result.err;
    return result.err;
  }

  // Leave a checkpoint of an endless render, by Ctrl-C.
  void Stop(const std::string& scene, const Words& more = {}) {
    Child child(Join({"render", scene, "--spp", "100000000", "-o", "a.exr"}, more), here_);
    ASSERT_TRUE(child.WaitFor("rendering"));
    child.Send(SIGINT);
    EXPECT_EQ(child.Wait().status, 130);
  }
  // Until a render has saved something.
  void WaitForFiles() const {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!Exists("a.snell-film") && !Exists("a.exr")) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  void ExpectTheSameAfterKills(const std::string& scene, const Words& more) {
    const Words render = Join({"render", scene, "--float", "-q"}, more);
    Succeed(Join(render, {"-o", "whole.exr"}));
    std::mt19937 random(7);
    for (int i = 0; i < 10; ++i) {
      Child child(Join(render, {"-o", "a.exr", "--resume", "--checkpoint-interval", "0.01",
                                "--threads", std::to_string(1 + i % 3)}),
                  here_);
      WaitForFiles();
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 60));
      child.Send(SIGKILL);
      child.Wait();
      if (Exists("a.exr")) break;
    }
    Succeed(Join(render, {"-o", "a.exr", "--resume", "--stats", "s.json"}));
    EXPECT_EQ(Read("a.exr"), Read("whole.exr"));
    std::filesystem::remove(folder_ / "s.json");
    EXPECT_EQ(Files(), (Words{"a.exr", "room.toml", "spheres.nff", "whole.exr"}))
        << "nothing is left over";
    std::filesystem::remove(folder_ / "a.exr");
  }

  Surroundings here_;
};

TEST_F(LongRenders, KilledAndResumedTheyGiveTheSamePicture) {
  ExpectTheSameAfterKills("spheres.nff", {"--spp", "256"});
}

TEST_F(LongRenders, KilledAndResumedTheyGiveTheSamePathTracedPicture) {
  ExpectTheSameAfterKills("room.toml", {"--spp", "400"});
}

TEST_F(LongRenders, KilledAndResumedTheyStopAtTheSameNoise) {
  ExpectTheSameAfterKills("room.toml", {"--noise", "0.02", "--spp", "2000"});
}

TEST_F(LongRenders, CtrlCLeavesAPictureAndACheckpoint) {
  Stop("spheres.nff");
  EXPECT_EQ(ReadPicture(Path("a.exr")).width, 96);
  EXPECT_TRUE(Exists("a.snell-film"));
  // Fewer samples than there are: nothing is left to do
  const std::string said =
      Succeed({"render", "spheres.nff", "--spp", "1", "-o", "a.exr", "--resume"});
  EXPECT_NE(said.find("written  a.exr"), std::string::npos) << said;
  EXPECT_FALSE(Exists("a.snell-film")) << "the picture is complete";
  EXPECT_NE(Succeed({"render", "spheres.nff", "--spp", "1", "-o", "a.exr", "--resume"})
                .find("there is no checkpoint 'a.snell-film'; the render begins anew"),
            std::string::npos);
}

TEST_F(LongRenders, WhoForgetsToResumeLosesNothing) {
  Stop("spheres.nff");
  const std::string film = Read("a.snell-film");
  Stop("spheres.nff");
  EXPECT_EQ(Read("a.snell-film~"), film);
}

TEST_F(LongRenders, OtherRendersAreRefused) {
  Stop("spheres.nff");
  const Words resume = {"render", "spheres.nff", "-o", "a.exr", "--resume", "--spp", "1000000"};
  const auto expectRefusal = [&](const Words& words, const std::string& why) {
    const std::string said = ErrorOf(Join(resume, words));
    EXPECT_NE(said.find("error: a.snell-film: "), std::string::npos) << said;
    EXPECT_NE(said.find(why), std::string::npos) << said;
  };
  expectRefusal({"--max-depth", "3"}, "now there is maximum depth 3, not ");
  expectRefusal({"--min-contribution", "0.1"}, "minimum contribution 0.1, not 0;");
  expectRefusal({"--integrator", "path"}, "integrator path, not whitted");
  expectRefusal({"--size", "48"}, "the film holds the pixels 0,0,96,64, not 0,0,48,32");
  expectRefusal({"--crop", "0,0,9,9"}, "the film holds the pixels 0,0,96,64, not 0,0,9,9");
  expectRefusal({"--samples", "5:9"}, "the film's samples begin at 0, not 5");
  std::string scene = SpheresScene("96 64");
  scene.replace(scene.find("0 0 0 0.5"), 9, "0 0 0 0.4");
  Write("spheres.nff", scene);
  expectRefusal({}, "another scene");
  scene.replace(scene.find("angle 30"), 8, "angle 31");
  Write("spheres.nff", scene);
  expectRefusal({}, "another camera");
  Write("a.snell-film", Read("a.snell-film").substr(0, 5000));
  expectRefusal({}, "the film file is incomplete: it has 5000 of ");
}

TEST_F(LongRenders, MoreSamplesGoOnWithAFilm) {
  Succeed({"render", "spheres.nff", "--spp", "20", "-o", "whole.exr", "--float"});
  Succeed({"render", "spheres.nff", "--spp", "6", "--film", "a.snell-film"});
  EXPECT_EQ(Files(), (Words{"a.snell-film", "room.toml", "spheres.nff", "whole.exr"}))
      << "without -o, no picture";
  Succeed({"render", "spheres.nff", "--spp", "20", "--film", "a.snell-film", "--resume", "-o",
           "a.exr", "--float"});
  EXPECT_EQ(Read("a.exr"), Read("whole.exr"));
  EXPECT_TRUE(Exists("a.snell-film")) << "a film that was asked for is kept";
}

TEST_F(LongRenders, FourRangesAreTheWhole) {
  for (const std::string scene : {"spheres.nff", "room.toml"}) {
    const Words render = {"render", scene, "--spp", "20"};
    Succeed(Join(render, {"-o", "whole.exr", "--float"}));
    for (const std::string range : {"0:1", "1:7", "7:16", "16:20"})
      Succeed(Join(render, {"--samples", range, "--film", range + ".snell-film"}));
    Succeed({"merge", "7:16.snell-film", "0:1.snell-film", "16:20.snell-film", "1:7.snell-film",
             "-o", "a.exr", "--float", "--film", "sum.snell-film"});
    EXPECT_EQ(Read("a.exr"), Read("whole.exr"));
    EXPECT_NE(ErrorOf({"merge", "sum.snell-film", "1:7.snell-film", "-o", "a.png"})
                  .find("1:7.snell-film: holds samples 1:7 of pixels that 'sum.snell-film' holds"),
              std::string::npos);
    // The sum is a film like any other
    Succeed({"render", scene, "--spp", "24", "-o", "more.exr", "--float"});
    Succeed({"render", scene, "--spp", "24", "-o", "a.exr", "--float", "--resume", "--checkpoint",
             "sum.snell-film"});
    EXPECT_EQ(Read("a.exr"), Read("more.exr"));
  }
}

TEST_F(LongRenders, PartsOfThePictureAreTheWhole) {
  const Words render = {"render", "room.toml", "--spp", "8"};
  Succeed(Join(render, {"-o", "whole.exr", "--float"}));
  for (const std::string crop : {"0,0,20,32", "20,0,48,11", "20,11,48,32"})
    Succeed(Join(render, {"--crop", crop, "--film", crop + ".snell-film"}));
  Succeed({"merge", "0,0,20,32.snell-film", "20,0,48,11.snell-film", "20,11,48,32.snell-film", "-o",
           "a.exr", "--float"});
  EXPECT_EQ(Read("a.exr"), Read("whole.exr"));
  const std::string said =
      Succeed({"merge", "0,0,20,32.snell-film", "20,0,48,11.snell-film", "-o", "a.exr"});
  EXPECT_NE(said.find("warning: no film has samples of 588 pixels; black there"), std::string::npos)
      << said;
  Succeed({"render", "room.toml", "--spp", "8", "--max-depth", "3", "--crop", "20,11,48,32",
           "--film", "b.snell-film"});
  EXPECT_NE(ErrorOf({"merge", "0,0,20,32.snell-film", "b.snell-film", "-o", "a.exr"})
                .find("b.snell-film: does not go with '0,0,20,32.snell-film': maximum depth 3"),
            std::string::npos);
}

TEST_F(LongRenders, KilledAndResumedTheyGiveTheSameLayers) {
  ExpectTheSameAfterKills("room.toml", {"--spp", "200", "--aov", "all"});
}

TEST_F(LongRenders, LayersAndDenoisedPicturesAddUp) {
  const Words render = {"render", "room.toml", "--spp", "12", "--aov", "all", "--denoiser", "nfor"};
  Succeed(Join(render, {"-o", "whole.exr", "--float"}));
  const Words parts[] = {{"--samples", "5:12"},
                         {"--samples", "0:5", "--crop", "0,0,30,32"},
                         {"--samples", "0:5", "--crop", "30,0,48,32"}};
  Words merge = {"merge"};
  for (const Words& part : parts) {
    merge.push_back(part.back() + ".snell-film");
    Succeed(Join(render, Join(part, {"--film", merge.back()})));
  }
  Succeed(Join(merge, {"-o", "a.exr", "--float", "--denoiser", "nfor"}));
  EXPECT_EQ(Read("a.exr"), Read("whole.exr"));
  EXPECT_EQ(Read("a.denoised.exr"), Read("whole.denoised.exr"));

  // All of them hold the same layers
  const Words last = {"render", "room.toml", "--spp", "20", "--samples", "12:20", "--film"};
  Succeed(Join(last, {"b.snell-film"}));
  merge.push_back("b.snell-film");
  EXPECT_NE(ErrorOf(Join(merge, {"-o", "a.exr"})).find("b.snell-film: does not go with"),
            std::string::npos);
  EXPECT_NE(ErrorOf({"merge", "b.snell-film", "-o", "a.exr", "--denoise"})
                .find("b.snell-film: the films hold nothing that denoising needs"),
            std::string::npos);
  const std::string said = ErrorOf({"render", "room.toml", "--spp", "20", "--samples", "12:20",
                                    "--aov", "albedo", "--film", "b.snell-film", "--resume"});
  EXPECT_NE(said.find("b.snell-film: the film is of another render: now there are layers albedo, "
                      "not none"),
            std::string::npos)
      << said;
}

// A render that begins with a part of its samples goes on to the same picture as at once.
TEST_F(LongRenders, TheFirstSamplesOfManyGoOnWithAFilm) {
  const Words render = {"render", "room.toml", "--spp", "64", "--film", "a.snell-film"};
  Succeed({"render", "room.toml", "--spp", "64", "-o", "whole.exr", "--float"});
  Succeed(Join(render, {"--samples", "0:10"}));
  Succeed(Join(render, {"--resume", "-o", "a.exr", "--float"}));
  EXPECT_EQ(Read("a.exr"), Read("whole.exr"));
}

TEST_F(LongRenders, TimeEndsARender) {
  Succeed({"render", "spheres.nff", "--time", "0.3s", "-o", "a.exr", "--stats", "s.json"});
  const std::optional<JsonValues> stats = ParseJson(Read("s.json"));
  ASSERT_TRUE(stats);
  EXPECT_EQ(stats->at("picture.ended_by"), "time");
  EXPECT_EQ(stats->at("picture.complete"), "false");
  EXPECT_GE(std::stod(stats->at("picture.samples_per_pixel")), 1);
  EXPECT_EQ(ReadPicture(Path("a.exr")).width, 96);
  EXPECT_FALSE(Exists("a.snell-film"));
  // Whichever comes first
  Succeed(
      {"render", "spheres.nff", "--time", "1h", "--spp", "2", "-o", "a.exr", "--stats", "s.json"});
  EXPECT_EQ(ParseJson(Read("s.json"))->at("picture.ended_by"), "samples");
}

TEST_F(LongRenders, NoiseEndsARender) {
  Succeed({"render", "room.toml", "--noise", "0.03", "-o", "a.exr", "--stats", "s.json"});
  const std::optional<JsonValues> stats = ParseJson(Read("s.json"));
  ASSERT_TRUE(stats);
  EXPECT_EQ(stats->at("picture.ended_by"), "noise");
  EXPECT_EQ(stats->at("picture.complete"), "true");
  EXPECT_LE(std::stod(stats->at("noise.largest")), 0.03);
  EXPECT_EQ(stats->at("noise.pixels_above"), "0");
  EXPECT_GT(std::stod(stats->at("noise.rms")), 0);
}

TEST_F(LongRenders, OptionsThatContradictAreRefused) {
  const auto expect = [&](const Words& words, const std::string& why) {
    const std::string said = ErrorOf(Join({"render", "spheres.nff"}, words), 2);
    EXPECT_NE(said.find(why), std::string::npos) << said;
  };
  expect({"--time", "soon"}, "--time must be a time such as 90, 45s, 2m or 1h, not 'soon'");
  expect({"--time", "0"}, "--time must be a time");
  expect({"--noise", "2"}, "--noise must be at most 1");
  expect({"--no-checkpoint", "--resume"}, "--no-checkpoint and --resume contradict one another");
  expect({"-o", "a.png", "--film", "a.png"}, "--film names 'a.png', which is a picture");
  expect({"--checkpoint", "spheres.nff"}, "--checkpoint names 'spheres.nff', which is the scene");
  EXPECT_NE(ErrorOf({"check", "spheres.nff", "--time", "1"}, 2)
                .find("unknown option '--time'; --at names the moment of an animation"),
            std::string::npos);
  EXPECT_NE(ErrorOf({"merge", "a.snell-film"}, 2).find("name a picture by -o or a film by --film"),
            std::string::npos);
  EXPECT_NE(ErrorOf({"merge", "spheres.nff", "-o", "a.png"}).find("spheres.nff: not a film file"),
            std::string::npos);
}

}  // namespace
}  // namespace snell::test
