// SPDX-License-Identifier: Apache-2.0
//
// Stopping a render: the picture so far is written, and the exit status says which signal it was.
#include <sys/stat.h>

#include <csignal>

#include "api/snell.h"
#include "json_values.h"
#include "scratch.h"

namespace snell::test {
namespace {

class Stopping : public InScratchFolder {
 protected:
  Stopping() {
    Write("spheres.nff", SpheresScene());
    here_.folder = folder_;
  }

  void ExpectPicture() {
    const Picture picture = ReadPicture(Path("a.png"));
    EXPECT_EQ(picture.width, 320);
    double sum = 0;
    for (const float value : picture.rgb) sum += double(value);
    EXPECT_GT(sum, 0);
  }

  Surroundings here_;
};

TEST_F(Stopping, SignalsWriteWhatThereIs) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::filesystem::remove(folder_ / "a.png");
    std::vector<std::string> arguments = EndlessRender;
    arguments.insert(arguments.end(), {"--stats", "s.json"});
    Child child(arguments, here_);
    ASSERT_TRUE(child.WaitFor("rendering"));
    child.Send(signal);
    const Result result = child.Wait();
    EXPECT_EQ(result.status, 128 + signal);
    EXPECT_NE(result.err.find("snell: interrupted; the picture has "), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("written  a.png"), std::string::npos) << result.err;
    ExpectPicture();
    const std::optional<JsonValues> stats = ParseJson(Read("s.json"));
    ASSERT_TRUE(stats);
    EXPECT_EQ(stats->at("picture.complete"), "false");
    EXPECT_GT(std::stod(stats->at("picture.samples_per_pixel")), 0);
  }
}

TEST_F(Stopping, CtrlCAtATerminal) {
  here_.terminal = true;
  Child child(EndlessRender, here_);
  ASSERT_TRUE(child.WaitFor("rendering   0% "));
  ASSERT_TRUE(child.WaitFor("left"));
  child.Type("\x03");
  const Result result = child.Wait();
  EXPECT_EQ(result.status, 130);
  EXPECT_NE(result.err.find("snell: interrupted; "), std::string::npos) << result.err;
  ExpectPicture();
}

TEST_F(Stopping, TheSecondSignalEndsAtOnce) {
  // A pipe that nobody reads keeps the program from ending by itself
  ASSERT_EQ(::mkfifo(Path("pipe").c_str(), 0600), 0);
  std::vector<std::string> arguments = EndlessRender;
  arguments.insert(arguments.end(), {"--stats", "pipe"});
  Child child(arguments, here_);
  ASSERT_TRUE(child.WaitFor("rendering"));
  child.Send(SIGINT);
  ASSERT_TRUE(child.WaitFor("written  a.png"));
  child.Send(SIGINT);
  const Result result = child.Wait();
  EXPECT_EQ(result.signal, SIGINT);
  ExpectPicture();
}

TEST_F(Stopping, QuietIsQuietAboutThatToo) {
  std::vector<std::string> arguments = EndlessRender;
  arguments.emplace_back("--quiet");
  Child child(arguments, here_);
  if (!child.WaitUntilItCatches(SIGTERM)) GTEST_SKIP() << "this system has no /proc";
  child.Send(SIGTERM);
  const Result result = child.Wait();
  EXPECT_EQ(result.status, 128 + SIGTERM);
  EXPECT_EQ(result.out + result.err, "");
}

TEST_F(Stopping, IgnoredSignalsStayIgnored) {
  here_.prepare = [] { return ::signal(SIGHUP, SIG_IGN) != SIG_ERR; };
  Child child(EndlessRender, here_);
  ASSERT_TRUE(child.WaitFor("rendering"));
  child.Send(SIGHUP);
  child.Send(SIGTERM);
  EXPECT_EQ(child.Wait().status, 128 + SIGTERM);
}

TEST_F(Stopping, BeforeTheRenderItEndsAtOnce) {
  // A mesh that is large takes its time
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 2'000'000; ++i) text += "f 1 2 3\n";
  Write("large.obj", text);
  Child child({"render", "large.obj", "-o", "a.png"}, here_);
  child.Send(SIGINT);
  EXPECT_EQ(child.Wait().signal, SIGINT);
  EXPECT_FALSE(Exists("a.png"));
}

}  // namespace
}  // namespace snell::test
