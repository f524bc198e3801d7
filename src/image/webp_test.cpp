// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <webp/encode.h>

#include <vector>

#include "image/color.h"
#include "image/read.h"
#include "image/test_images.h"

namespace snell::image {
namespace {

// A lossless file of 8-bit pixels with alpha.
std::string Lossless(int width, int height, const std::vector<std::uint8_t>& rgba) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), width, height, width * 4, &bytes);
  const std::string file(reinterpret_cast<char*>(bytes), size);
  WebPFree(bytes);
  return file;
}

std::string Lossy(int width, int height, const std::vector<std::uint8_t>& rgb) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeRGB(rgb.data(), width, height, width * 3, 95, &bytes);
  const std::string file(reinterpret_cast<char*>(bytes), size);
  WebPFree(bytes);
  return file;
}

TEST(Webp, LosslessPixelsAreExact) {
  const std::string file = Lossless(2, 1, {10, 20, 30, 255, 200, 100, 50, 51});
  const Image raw = DecodeImage(file, "a.webp", {ColorSpace::Raw});
  ASSERT_EQ(raw.width, 2);
  ASSERT_EQ(raw.height, 1);
  ExpectNear(raw.pixels[0] * 255.0f, vec3(10, 20, 30), 1e-4f);
  ExpectNear(raw.pixels[1] * 255.0f, vec3(200, 100, 50), 1e-4f);
  ASSERT_TRUE(raw.HasAlpha());
  EXPECT_FLOAT_EQ(raw.alpha[1], 0.2f);
  EXPECT_FALSE(raw.premultiplied);
  EXPECT_FLOAT_EQ(DecodeImage(file, "a.webp").pixels[1].x, DecodeSrgb(200.0f / 255.0f));
}

TEST(Webp, LossyPixelsAreNear) {
  const Image image = DecodeImage(Lossy(16, 8, std::vector<std::uint8_t>(16 * 8 * 3, 128)),
                                  "a.webp", {ColorSpace::Raw});
  EXPECT_EQ(image.width, 16);
  EXPECT_EQ(image.height, 8);
  EXPECT_FALSE(image.HasAlpha());
  ExpectNear(image.At(7, 3) * 255.0f, vec3(128), 3);
}

TEST(Webp, EveryTruncationIsAnError) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 9 * 7 * 4; ++i) rgba.push_back(std::uint8_t(i * 37));
  const std::string whole = Lossless(9, 7, rgba);
  for (std::size_t length = 0; length + 1 < whole.size(); ++length)
    EXPECT_THROW(DecodeImage(whole.substr(0, length), "a.webp"), Error) << length;
}

TEST(Webp, SizesAreLimited) {
  const std::string file = Lossless(8, 8, std::vector<std::uint8_t>(8 * 8 * 4, 9));
  ReadOptions options;
  options.limits.pixels = 63;
  const std::string error = ErrorOf([&] { DecodeImage(file, "a.webp", options); });
  EXPECT_NE(error.find("the limit is 63"), error.npos) << error;
}

}  // namespace
}  // namespace snell::image
