// SPDX-License-Identifier: Apache-2.0
//
// Outputs that cannot be written: told before the render where that is possible; after it, the picture is
// rescued to another place, and the other pictures are written all the same.
#include <linux/capability.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "api/snell.h"
#include "json_values.h"
#include "scratch.h"

namespace snell::test {
namespace {

class Outputs : public InScratchFolder {
 protected:
  Outputs() {
    Write("spheres.nff", SpheresScene());
    Write("large.nff", SpheresScene("400 400"));
    std::filesystem::create_directory(folder_ / "out");
  }

  // Everything ends with this error before the scene, which does not exist, is even looked at.
  void ExpectRefused(const std::vector<std::string>& options, const std::string& lines,
                     const Surroundings& surroundings = {}) {
    std::vector<std::string> arguments = {"render", "missing.nff"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Result result = Run(arguments, surroundings);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, lines);
    EXPECT_EQ(result.out, "");
  }
};

TEST_F(Outputs, AMissingFolderIsToldAtOnce) {
  ExpectRefused({"-o", "no/a.png"},
                "snell: error: no/a.png: the folder 'no' does not exist; create it first\n");
}

TEST_F(Outputs, AllFaultsAreToldInOneGo) {
  std::filesystem::create_directory(folder_ / "b.png");
  ExpectRefused({"-o", "no/a.png", "-o", "b.png", "--stats", "no/s.json"},
                "snell: error: no/a.png: the folder 'no' does not exist; create it first\n"
                "snell: error: b.png: there is a folder of this name\n"
                "snell: error: no/s.json: cannot write the file: No such file or directory\n");
}

TEST_F(Outputs, AFolderThatIsReadOnlyIsToldAtOnce) {
  std::filesystem::permissions(
      folder_ / "out", std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  // The superuser may write anywhere unless this power is laid down
  Surroundings humble;
  humble.prepare = [] {
    return geteuid() != 0 || (::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) == 0 &&
                              ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH) == 0);
  };
  if (!Run({"--version"}, humble).started)
    GTEST_SKIP() << "the superuser's power cannot be dropped";
  ExpectRefused({"-o", "out/a.png"},
                "snell: error: out/a.png: cannot write the file: Permission denied\n", humble);
}

TEST_F(Outputs, AFolderThatVanishesMeanwhileCostsNoPicture) {
  Write("a.png", "not to be replaced");
  Surroundings here;
  here.folder = folder_;
  std::vector<std::string> arguments = EndlessRender;
  arguments[5] = "out/a.png";
  arguments.insert(arguments.end(), {"-o", "b.exr"});
  Child child(arguments, here);
  ASSERT_TRUE(child.WaitFor("rendering"));
  std::filesystem::remove(folder_ / "out");
  child.Send(SIGINT);
  const Result result = child.Wait();
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("snell: error: out/a.png: cannot write the file: No such file"),
            std::string::npos);
  EXPECT_NE(result.err.find("snell: the picture is in 'a-1.png' instead\n"), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("written  a-1.png, b.exr\n"), std::string::npos);
  EXPECT_EQ(Read("a.png"), "not to be replaced");
  EXPECT_EQ(ReadPicture(Path("a-1.png")).width, 320);
  EXPECT_EQ(ReadPicture(Path("b.exr")).width, 320);
}

TEST_F(Outputs, AFullDiskCostsNoPicture) {
  // A small disk of its own, seen by the child alone
  static std::string disk;
  disk = Path("out");
  Surroundings full;
  full.prepare = [] {
    return ::unshare(CLONE_NEWNS) == 0 &&
           ::mount("", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           ::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=16k") == 0;
  };
  if (!Run({"--version"}, full).started) GTEST_SKIP() << "a file system cannot be mounted here";
  const Result result =
      Run({"render", "large.nff", "-o", "out/a.png", "-o", "b.png", "--stats", "s.json"}, full);
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(
      result.err.find("snell: error: out/a.png: cannot write the file: No space left on device\n"
                      "snell: the picture is in 'a.png' instead\n"),
      std::string::npos)
      << result.err;
  EXPECT_EQ(Read("a.png"), Read("b.png"));
  const std::optional<JsonValues> stats = ParseJson(Read("s.json"));
  ASSERT_TRUE(stats);
  EXPECT_EQ(stats->at("files.0"), "a.png");
  EXPECT_EQ(stats->at("files.1"), "b.png");
}

TEST_F(Outputs, WhereNothingCanBeWrittenTheLossIsTold) {
  Surroundings limited;
  limited.prepare = [] {
    const rlimit limit = {2000, 2000};
    return ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
  };
  const Result result = Run({"render", "large.nff", "-o", "out/a.png"}, limited);
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("snell: error: out/a.png: cannot write the file: File too large\n"),
            std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("out/a.png: the picture is lost"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("written  nothing"), std::string::npos) << result.err;
  // Nor are halves of files left
  EXPECT_EQ(Files(), (std::vector<std::string>{"large.nff", "out", "spheres.nff"}));
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "out"));
}

TEST_F(Outputs, APictureReplacesAnOldOneAsAWhole) {
  Write("a.png", "old");
  EXPECT_EQ(Run({"render", "spheres.nff", "-o", "a.png"}).status, 0);
  EXPECT_EQ(ReadPicture(Path("a.png")).width, 48);
  EXPECT_EQ(Files(), (std::vector<std::string>{"a.png", "large.nff", "out", "spheres.nff"}));
}

TEST_F(Outputs, DevicesAreWrittenToNotReplaced) {
  ::symlink("/dev/full", Path("full").c_str());
  const Result result = Run({"render", "spheres.nff", "-q", "--stats", "full"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "snell: error: full: cannot write the file: No space left on device\n");
  EXPECT_TRUE(Exists("spheres.png"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "full"));
}

TEST_F(Outputs, NoFileTakesThePlaceOfAClosedStream) {
  // The number of a closed stream would be given to the first file, which would then receive messages
  Surroundings closed;
  closed.prepare = [] { return ::close(STDERR_FILENO) == 0; };
  const Result result =
      Run({"render", "spheres.nff", "-o", "a.png", "--stats", "/dev/fd/2"}, closed);
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(ReadPicture(Path("a.png")).width, 48);

  closed.prepare = [] { return ::close(STDOUT_FILENO) == 0; };
  const Result mute = Run({"help"}, closed);
  EXPECT_EQ(mute.status, 1);
  EXPECT_EQ(mute.err, "snell: error: cannot write to the standard output: Bad file descriptor\n");
}

TEST_F(Outputs, AFullStandardOutputIsAnError) {
  Surroundings full;
  full.outputFile = "/dev/full";
  for (const char* command : {"manual", "help", "--version"}) {
    const Result result = Run({command}, full);
    EXPECT_EQ(result.status, 1) << command;
    EXPECT_EQ(result.err,
              "snell: error: cannot write to the standard output: No space left on device\n");
  }
}

}  // namespace
}  // namespace snell::test
