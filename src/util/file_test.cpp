// SPDX-License-Identifier: Apache-2.0
//
// Files: what is refused, what a name may reach, and that no reader ever sees half a file.
#include "util/file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "support/scratch_folder.h"
#include "util/error.h"

namespace snell {
namespace {

namespace fs = std::filesystem;

// The one diagnostic of an action that must fail.
template <class Action>
Diagnostic FaultOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.diagnostics().size(), 1u);
    return error.diagnostics().front();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

class InScratchFolder : public testing::Test, protected test::ScratchFolder {
 protected:
  // Run in a child process, which may neither hang nor crash; true if `action` returned true.
  template <class Action>
  static bool InChild(const Action& action) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::alarm(20);
      bool good = false;
      try {
        good = action();
      } catch (...) {
      }
      ::_exit(good ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
};

using ReadingFiles = InScratchFolder;
using ConfiningPaths = InScratchFolder;
using WritingFiles = InScratchFolder;

TEST_F(ReadingFiles, GivesTheBytesAsTheyAre) {
  const std::string bytes("a\0b\r\n\xff", 6);
  Write("a", bytes);
  Write("empty", "");
  EXPECT_EQ(ReadFile(Path("a")), bytes);
  EXPECT_EQ(ReadFile(Path("empty")), "");
}

TEST_F(ReadingFiles, SaysWhyItCannot) {
  const Diagnostic missing = FaultOf([&] { ReadFile(Path("b")); });
  EXPECT_EQ(missing.place.file, Path("b"));
  EXPECT_TRUE(Contains(missing.message, "No such file")) << missing.message;
  EXPECT_EQ(FaultOf([&] { ReadFile(Path("")); }).message, "not a regular file");
  EXPECT_EQ(FaultOf([&] { ReadFile("/dev/zero"); }).message, "not a regular file");
  FaultOf([&] { ReadFile(""); });
  if (::geteuid() != 0) {
    Write("secret", "x");
    ::chmod(Path("secret").c_str(), 0);
    EXPECT_TRUE(Contains(FaultOf([&] { ReadFile(Path("secret")); }).message, "denied"));
  }
}

TEST_F(ReadingFiles, NeverWaitsForAPipe) {
  ASSERT_EQ(::mkfifo(Path("pipe").c_str(), 0600), 0);
  EXPECT_TRUE(InChild([&] {
    try {
      ReadFile(Path("pipe"));
    } catch (const Error& error) {
      return error.diagnostics().front().message == "not a regular file";
    }
    return false;
  }));
}

TEST_F(ReadingFiles, ChecksTheLimitBeforeItTakesMemory) {
  Write("a", "12345");
  EXPECT_EQ(ReadFile(Path("a"), 5), "12345");
  EXPECT_TRUE(Contains(FaultOf([&] { ReadFile(Path("a"), 4); }).message, "5 bytes"));

  // A file of holes that claims a terabyte
  Write("holes", "");
  std::error_code refused;
  fs::resize_file(Path("holes"), std::uintmax_t(1) << 40, refused);
  if (!refused) {
    EXPECT_TRUE(Contains(FaultOf([&] { ReadFile(Path("holes")); }).message, "1099511627776 bytes"));
  }
}

TEST_F(ConfiningPaths, AllowsWhatLiesInTheFolder) {
  fs::create_directories(Path("scene/meshes"));
  Write("scene/meshes/a.ply", "");
  const fs::path root = Path("scene");
  EXPECT_EQ(ConfinedPath(root, root, "meshes/a.ply"), root / "meshes/a.ply");
  EXPECT_EQ(ConfinedPath(root, root, "meshes\\a.ply"), root / "meshes/a.ply");
  EXPECT_EQ(ConfinedPath(root, root, "./meshes/../meshes/a.ply"),
            root / "./meshes/../meshes/a.ply");
  EXPECT_EQ(ConfinedPath(root, root / "meshes", "../b.toml"), root / "meshes/../b.toml");
  EXPECT_EQ(ConfinedPath(root, root, "no/such/file"), root / "no/such/file");
  EXPECT_EQ(ConfinedPath(root, root, "..a"), root / "..a");
  // The current folder has an empty name
  EXPECT_EQ(ConfinedPath("", "", "a.ply"), fs::path("a.ply"));
}

TEST_F(ConfiningPaths, RefusesWhatLeadsOut) {
  fs::create_directories(Path("scene/meshes"));
  fs::create_directories(Path("scene2"));
  Write("secret", "");
  Write("scene2/secret", "");
  const fs::path root = Path("scene");
  const std::string absolute = Path("scene/meshes");
  for (const std::string& name :
       {std::string("../secret"), std::string("meshes/../../secret"), std::string("..\\secret"),
        std::string("../scene2/secret"), std::string("no/../../secret"), std::string(".."),
        std::string("/etc/passwd"), std::string("\\etc\\passwd"), std::string("C:\\a"),
        std::string("c:a"), absolute, std::string("")}) {
    EXPECT_NE(FaultOf([&] { ConfinedPath(root, root, name); }).message, "") << name;
  }
  FaultOf([&] { ConfinedPath(root, root / "meshes", "../../secret"); });
  FaultOf([&] { ConfinedPath("", "", "../secret"); });
}

TEST_F(ConfiningPaths, FollowsSymbolicLinks) {
  fs::create_directories(Path("scene/real"));
  Write("secret", "");
  Write("scene/real/a", "");
  const fs::path root = Path("scene");
  fs::create_symlink("../secret", root / "file");
  fs::create_directory_symlink("..", root / "up");
  fs::create_directory_symlink("real", root / "inside");
  fs::create_symlink("loop", root / "loop");
  for (const char* name : {"file", "up/secret", "inside/../../secret", "up", "loop", "loop/a"})
    FaultOf([&] { ConfinedPath(root, root, name); });
  EXPECT_NO_THROW(ConfinedPath(root, root, "inside/a"));

  // A root that is a link itself is where it leads to
  fs::create_directory_symlink("scene", Path("link"));
  EXPECT_NO_THROW(ConfinedPath(Path("link"), Path("link"), "real/a"));
  FaultOf([&] { ConfinedPath(Path("link"), Path("link"), "../secret"); });
}

TEST_F(ConfiningPaths, RefusesNamesThatTheSystemWouldCutShort) {
  // The system's calls end at the zero byte: what they open would be the link
  fs::create_directories(Path("scene"));
  Write("secret", "");
  const fs::path root = Path("scene");
  fs::create_symlink("../secret", root / "link");
  const std::string back = "/.." + root.string() + "/a";
  for (const std::string& rest : {std::string(), std::string("/x"), back, "/.." + back})
    FaultOf([&] { ConfinedPath(root, root, std::string("link\0", 5) + rest); });
}

TEST_F(WritingFiles, AppearWhenTheyAreComplete) {
  Write("a", "old");
  {
    AtomicFile file(Path("a"));
    file.Write("new");
    EXPECT_EQ(Read("a"), "old");
    file.Commit();
    EXPECT_EQ(Read("a"), "new");
  }
  EXPECT_EQ(Files(), std::vector<std::string>{"a"});
}

TEST_F(WritingFiles, LeaveNothingBehindIfGivenUp) {
  Write("a", "old");
  {
    AtomicFile file(Path("a"));
    file.Write("new");
    AtomicFile other(Path("b"));
    EXPECT_EQ(Files().size(), 3u);
  }
  EXPECT_EQ(Read("a"), "old");
  EXPECT_EQ(Files(), std::vector<std::string>{"a"});
}

TEST_F(WritingFiles, KeepsTheOldFileWhenTheDiskIsFull) {
  Write("a", "old");
  const std::string big(1 << 20, 'x');
  EXPECT_TRUE(InChild([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100000, 100000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
    try {
      WriteFile(Path("a"), big);
    } catch (const Error& error) {
      return Contains(error.what(), "too large");
    }
    return false;
  }));
  EXPECT_EQ(Read("a"), "old");
  EXPECT_EQ(Files(), std::vector<std::string>{"a"});

  // Little enough to wait in the stream's buffer until the end
  EXPECT_TRUE(InChild([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{10, 10};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
    try {
      WriteFile(Path("a"), "more than ten bytes");
    } catch (const Error&) {
      return true;
    }
    return false;
  }));
  EXPECT_EQ(Read("a"), "old");
  EXPECT_EQ(Files(), std::vector<std::string>{"a"});
}

TEST_F(WritingFiles, SaysWhyItCannot) {
  const Diagnostic missing = FaultOf([&] { WriteFile(Path("no/a"), "x"); });
  EXPECT_EQ(missing.place.file, Path("no/a"));
  EXPECT_TRUE(Contains(missing.message, "No such file")) << missing.message;
  fs::create_directory(Path("folder"));
  EXPECT_TRUE(Contains(FaultOf([&] { WriteFile(Path("folder"), "x"); }).message, "directory"));
  EXPECT_TRUE(Contains(FaultOf([&] { WriteFile("/dev/full", "x"); }).message, "No space"));
  EXPECT_EQ(Files(), std::vector<std::string>{"folder"});
}

TEST_F(WritingFiles, GoesThroughLinksAndToDevices) {
  Write("a", "old");
  fs::create_symlink("a", Path("link"));
  WriteFile(Path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(Path("link")));
  EXPECT_EQ(Read("a"), "new");
  fs::create_symlink("b", Path("dangling"));
  WriteFile(Path("dangling"), "made");
  EXPECT_TRUE(fs::is_symlink(Path("dangling")));
  EXPECT_EQ(Read("b"), "made");
  EXPECT_NO_THROW(WriteFile("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(LowerExtension, IsThatOfTheLastPart) {
  EXPECT_EQ(LowerExtension("A/b.PNG"), "png");
  EXPECT_EQ(LowerExtension("a.tar.GZ"), "gz");
  EXPECT_EQ(LowerExtension("a.b/c"), "");
  EXPECT_EQ(LowerExtension(".hidden"), "");
  EXPECT_EQ(LowerExtension("a."), "");
  EXPECT_EQ(LowerExtension(""), "");
}

TEST_F(WritingFiles, LeavesNothingOfKilledWriters) {
  // No process has so high a number
  Write("a.film.partial-2147483647", "half");
  Write("a.film.partial-" + std::to_string(::getpid()), "being written");
  Write("a.film.partial-12x", "something else");
  Write("b.film.partial-2147483647", "of another file");
  RemoveAbandoned(Path("a.film"));
  EXPECT_FALSE(Exists("a.film.partial-2147483647"));
  EXPECT_TRUE(Exists("a.film.partial-" + std::to_string(::getpid())));
  EXPECT_TRUE(Exists("a.film.partial-12x"));
  EXPECT_TRUE(Exists("b.film.partial-2147483647"));
}

}  // namespace
}  // namespace snell
