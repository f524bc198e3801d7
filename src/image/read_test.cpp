// SPDX-License-Identifier: Apache-2.0
#include "image/read.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "image/test_images.h"
#include "image/write.h"
#include "util/file.h"

namespace snell::image {
namespace {

TEST(ReadImage, GoesByContentNotByName) {
  const TemporaryFolder folder;
  for (const char* extension : {"png", "jpg", "hdr", "exr"}) {
    const auto path = folder / (std::string("a.") + extension);
    WriteImage(path, Constant(4, 3, vec3(0.5f)));
    std::filesystem::rename(path, folder / "picture.dat");
    const Image image = ReadImage(folder / "picture.dat");
    EXPECT_EQ(image.width, 4) << extension;
    ExpectNear(image.pixels[0], vec3(0.5f), 0.01f);
  }
}

TEST(ReadImage, NamesFormatsThatItCannotRead) {
  using std::string_literals::operator""s;
  const std::pair<std::string, const char*> cases[] = {{"RIFF\x10\0\0\0WEBPVP8 "s, "WebP"},
                                                       {"GIF89a", "GIF"},
                                                       {"II*\0"s, "TIFF"},
                                                       {"hello", "not a known picture format"},
                                                       {"", "empty"}};
  for (const auto& [bytes, expected] : cases) {
    const std::string error = ErrorOf([&, b = bytes] { DecodeImage(b, "a.png"); });
    EXPECT_EQ(error.find("a.png: "), 0u) << error;
    EXPECT_NE(error.find(expected), error.npos) << error;
  }
}

TEST(ReadImage, LimitsArePromises) {
  const TemporaryFolder folder;
  for (const char* extension : {"png", "jpg", "hdr", "exr"}) {
    const auto path = folder / (std::string("a.") + extension);
    WriteImage(path, Pattern(10, 10));
    EXPECT_NO_THROW(ReadImage(path, {.limits = {.pixels = 100}}));
    EXPECT_NE(ErrorOf([&] { ReadImage(path, {.limits = {.pixels = 99}}); }).find("the limit is 99"),
              std::string::npos);
    EXPECT_THROW(ReadImage(path, {.limits = {.fileBytes = 40}}), Error);
    EXPECT_THROW(DecodeImage(ReadFile(path), "a", {.limits = {.fileBytes = 40}}), Error);
  }
}

TEST(ReadImage, MissingFilesAreNamed) {
  const std::string error = ErrorOf([] { ReadImage("no/such/picture.png"); });
  EXPECT_EQ(error.find("no/such/picture.png: "), 0u) << error;
}

}  // namespace
}  // namespace snell::image
