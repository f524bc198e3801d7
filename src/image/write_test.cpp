// SPDX-License-Identifier: Apache-2.0
#include "image/write.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>

#include "image/read.h"
#include "image/test_images.h"
#include "util/file.h"

namespace snell::image {
namespace {

// Files of this process cannot grow beyond `bytes` while it lives: what a full disk does.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_ = {};
  void (*handler_)(int);
};

TEST(WriteImage, ListsTheExtensionsThatItKnows) {
  EXPECT_EQ(KnownWriteExtensions(), "png, jpg, jpeg, hdr, exr");
  const TemporaryFolder folder;
  for (const char* name : {"a.webp", "a", "a.pngg", ".png", "a."}) {
    const std::string error = ErrorOf([&] { WriteImage(folder / name, Pattern(2, 2)); });
    EXPECT_NE(error.find("png, jpg, jpeg, hdr, exr"), error.npos) << name << ": " << error;
    EXPECT_EQ(ErrorOf([&] { CheckWritable(folder / name); }), error);
  }
  EXPECT_NE(ErrorOf([&] { CheckWritable(folder / "a.pgn"); }).find("did you mean 'png'?"),
            std::string::npos);
  EXPECT_EQ(folder.FileCount(), 0u);
}

TEST(WriteImage, ExtensionsMayBeUpperCase) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.PNG", Pattern(2, 2));
  EXPECT_EQ(ReadImage(folder / "a.PNG").width, 2);
}

TEST(WriteImage, OptionsWithoutMeaningAreErrors) {
  const TemporaryFolder folder;
  const auto error = [&](const char* name, const WriteOptions& options) {
    const std::string text = ErrorOf([&] { CheckWritable(folder / name, options); });
    EXPECT_EQ(text, ErrorOf([&] { WriteImage(folder / name, Pattern(2, 2), options); }));
    return text;
  };
  EXPECT_NE(error("a.jpg", {.bits = 16}).find(".png"), std::string::npos);
  EXPECT_NE(error("a.png", {.bits = 12}), "");
  EXPECT_NE(error("a.jpg", {.jpegQuality = 0}), "");
  EXPECT_NE(error("a.jpg", {.jpegQuality = 101}), "");
  EXPECT_NE(error("a.png", {.exposure = std::numeric_limits<float>::quiet_NaN()}), "");
  EXPECT_NE(error("a.png", {.metadata = {{"", "x"}}}), "");
  EXPECT_NE(error("a.png", {.metadata = {{" key", "x"}}}), "");
  EXPECT_NE(error("a.png", {.metadata = {{std::string(80, 'k'), "x"}}}), "");
  EXPECT_NE(error("a.png", {.metadata = {{"Schlüssel", "x"}}}), "");
  EXPECT_NE(error("a.png", {.metadata = {{"key", std::string("a\0b", 3)}}}), "");
  EXPECT_EQ(folder.FileCount(), 0u);
  EXPECT_EQ(error("a.png", {.bits = 16, .exrFloat = true}), "");
}

TEST(CheckWritable, FindsFolderFaultsAndLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(CheckWritable(folder / "a.png"));
  EXPECT_NE(ErrorOf([&] { CheckWritable(folder / "no/a.png"); }).find("does not exist"),
            std::string::npos);
  WriteFile(folder / "file", "x");
  EXPECT_NE(ErrorOf([&] { CheckWritable(folder / "file/a.png"); }), "");
  std::filesystem::create_directory(folder / "b.png");
  EXPECT_NE(ErrorOf([&] { CheckWritable(folder / "b.png"); }).find("folder"), std::string::npos);
  EXPECT_EQ(folder.FileCount(), 2u);
}

TEST(CheckWritable, FindsReadOnlyFolders) {
  if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write everywhere";
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "locked");
  std::filesystem::permissions(
      folder / "locked", std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THROW(CheckWritable(folder / "locked/a.png"), Error);
}

TEST(CheckWritable, KeepsTheOldFile) {
  const TemporaryFolder folder;
  WriteFile(folder / "a.png", "old");
  CheckWritable(folder / "a.png");
  EXPECT_EQ(ReadFile(folder / "a.png"), "old");
}

TEST(WriteImage, AFullDiskLeavesTheOldFileAndNoOther) {
  for (const char* extension : {"png", "jpg", "hdr", "exr"}) {
    const TemporaryFolder folder;
    const auto path = folder / (std::string("a.") + extension);
    WriteFile(path, "old");
    std::string error;
    {
      const SmallDisk disk(1000);
      error = ErrorOf([&] { WriteImage(path, Pattern(100, 100)); });
    }
    EXPECT_NE(error.find("cannot write the file"), error.npos) << error;
    EXPECT_EQ(ReadFile(path), "old");
    EXPECT_EQ(folder.FileCount(), 1u);
  }
}

TEST(WriteImage, ReplacesTheOldFile) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.exr", Pattern(3, 3));
  WriteImage(folder / "a.exr", Pattern(5, 5));
  EXPECT_EQ(ReadImage(folder / "a.exr").width, 5);
  EXPECT_EQ(folder.FileCount(), 1u);
}

}  // namespace
}  // namespace snell::image
