// SPDX-License-Identifier: Apache-2.0
//
// Real files of many programs, and broken ones: the good ones open, the broken ones give a picture or one
// Error, in bounded memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "image/read.h"
#include "image/test_images.h"
#include "util/file.h"
#include "util/timer.h"

namespace snell::image {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> FilesUnder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Assets : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(image::Assets())) GTEST_SKIP() << image::Assets() << " does not exist";
  }
};

TEST_F(Assets, GoodPicturesOpen) {
  // Files whose channels are not colour, or deep
  const std::vector<std::string> refused = {
      "11.deep.exr", "depth32f.exr", "depth32f-custom-channels.exr", "rgba32f-custom-channels.exr"};
  for (const char* folder : {"images", "env"}) {
    for (const fs::path& path : FilesUnder(image::Assets() / folder)) {
      SCOPED_TRACE(path.filename());
      const std::string error = ErrorOf([&] {
        const Image image = ReadImage(path);
        EXPECT_EQ(image.pixels.size(), std::size_t(image.width) * std::size_t(image.height));
      });
      const bool mayFail =
          std::find(refused.begin(), refused.end(), path.filename()) != refused.end();
      EXPECT_EQ(error.empty(), !mayFail) << error;
    }
  }
}

TEST_F(Assets, BrokenPicturesAreErrorsOrPictures) {
  for (const char* folder : {"bad/png", "bad/jpeg", "bad/exr", "bad/hdr", "bad/empty"}) {
    for (const fs::path& path : FilesUnder(image::Assets() / folder)) {
      const std::string error = ErrorOf([&] { ReadImage(path); });
      if (!error.empty()) {
        EXPECT_EQ(error.find(path.string()), 0u) << error;
        EXPECT_EQ(error.find('\n'), error.npos) << error;
      }
    }
  }
  EXPECT_LT(PeakMemoryBytes(), std::uint64_t(1) << 30);
}

TEST_F(Assets, CompressionsOfOnePictureAgree) {
  const fs::path folder = image::Assets() / "images/exr/compression";
  const Image exact = ReadImage(folder / "none_half.exr");
  for (const char* name : {"rle_half", "zip_half", "zips_half", "piz_half", "tiled16_zip_half"})
    ExpectSame(ReadImage(folder / (std::string(name) + ".exr")), exact, 0);
  for (const char* name : {"zip_float", "none_float"})
    ExpectSame(ReadImage(folder / (std::string(name) + ".exr")), exact, 1e-3f);
}

TEST_F(Assets, WebpOpens) {
  for (const fs::path& path : FilesUnder(image::Assets() / "gltf"))
    if (path.extension() == ".webp") {
      EXPECT_EQ(ErrorOf([&] { ReadImage(path); }), "") << path;
    }
}

}  // namespace
}  // namespace snell::image
