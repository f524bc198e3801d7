// SPDX-License-Identifier: Apache-2.0
#include "image/orientation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace snell::image {
namespace {

using std::string_literals::operator""s;

// The body of an Exif block whose only entry is an orientation.
std::string Tiff(char number) {
  return "II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0"s + number + "\0\0\0\0\0\0\0"s;
}

// Stored as
//   1 2 3
//   4 5 6
Image Stored() {
  Image image(3, 2);
  for (std::size_t i = 0; i < 6; ++i) {
    image.pixels[i] = vec3(float(i + 1));
    image.alpha.push_back(float(i + 1));
  }
  return image;
}

std::string Digits(const Image& image) {
  std::string digits;
  for (int y = 0; y < image.height; ++y) {
    if (y > 0) digits += '/';
    for (int x = 0; x < image.width; ++x) digits += char('0' + int(image.At(x, y).x));
  }
  return digits;
}

TEST(Orientation, TurnsAsExifSays) {
  // Row 0 and column 0 as the standard places them: 6 has row 0 at the right and column 0 at the top
  const char* expected[] = {"123/456",  "321/654",  "654/321",  "456/123",
                            "14/25/36", "41/52/63", "63/52/41", "36/25/14"};
  for (char number = 1; number <= 8; ++number) {
    const Image upright = Upright(Stored(), ExifOrientation(Tiff(number)));
    EXPECT_EQ(Digits(upright), expected[number - 1]) << "orientation " << int(number);
    EXPECT_EQ(upright.alpha[0], upright.pixels[0].x);
  }
}

TEST(Orientation, ReadsBothByteOrders) {
  const std::string big = "MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0"s;
  EXPECT_TRUE(ExifOrientation(big).transpose);
  EXPECT_TRUE(ExifOrientation(big).flipY);
}

TEST(Orientation, DamagedExifIsUpright) {
  const std::string whole = Tiff(6);
  for (std::size_t length = 0; length < 19; ++length) {
    const Orientation orientation = ExifOrientation(whole.substr(0, length));
    EXPECT_FALSE(orientation.transpose) << length;
  }
  EXPECT_FALSE(ExifOrientation("II*\0\xff\xff\xff\xff"s).transpose);
  EXPECT_FALSE(ExifOrientation("II*\0\x08\0\0\0\xff\xff"s).transpose);
  EXPECT_FALSE(ExifOrientation(Tiff(9)).transpose);
}

}  // namespace
}  // namespace snell::image
