// SPDX-License-Identifier: Apache-2.0
//
// What the tests of this room share: small pictures, a folder that goes away, places of test files.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "image/image.h"
#include "image/write.h"
#include "util/error.h"

namespace snell::image {

// A folder for one test's files, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("snell-image-") + test->name() + std::to_string(::getpid());
    for (char& c : name)
      if (c == '/') c = '-';
    path_ = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t FileCount() const {
    return std::size_t(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

// The folder with pictures of many origins; it is not part of the repository.
inline std::filesystem::path Assets() {
  return std::filesystem::path(SNELL_SOURCE_DIR) / ".." / "shared" / "assets";
}

// Colours in [0, 1] that differ from pixel to pixel and channel to channel.
inline Image Pattern(int width, int height, bool alpha = false) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.At(x, y) = vec3(float(x) / float(width), float(y) / float(height),
                            float((3 * x + 5 * y) % 17) / 16.0f);
  if (alpha)
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.alpha.push_back(float(i % 5 + 1) / 5.0f);
  return image;
}

inline Image Constant(int width, int height, const vec3& color) {
  Image image(width, height);
  for (vec3& pixel : image.pixels) pixel = color;
  return image;
}

inline void ExpectNear(const vec3& actual, const vec3& expected, float tolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

inline void ExpectSame(const Image& actual, const Image& expected, float tolerance) {
  ASSERT_EQ(actual.width, expected.width);
  ASSERT_EQ(actual.height, expected.height);
  ASSERT_EQ(actual.alpha.size(), expected.alpha.size());
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    SCOPED_TRACE("pixel " + std::to_string(i));
    ExpectNear(actual.pixels[i], expected.pixels[i], tolerance);
    if (expected.HasAlpha()) {
      EXPECT_NEAR(actual.alpha[i], expected.alpha[i], tolerance);
    }
    if (testing::Test::HasFailure()) return;
  }
}

// The text of the Error that a call throws; "" if it throws none.
template <typename Call>
std::string ErrorOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// The first entry with a key, or "".
inline std::string Find(const Metadata& metadata, const std::string& key) {
  for (const auto& [name, value] : metadata)
    if (name == key) return value;
  return "";
}

}  // namespace snell::image
