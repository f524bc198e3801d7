// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "image/read.h"
#include "image/test_images.h"
#include "image/write.h"

namespace snell::image {
namespace {

using std::string_literals::operator""s;

// Pixels of mantissas (r, g, b) under exponent 128 + 8, so that they are the numbers themselves.
std::string Flat(const std::string& mantissas) {
  std::string pixels;
  for (std::size_t i = 0; i < mantissas.size(); i += 3) pixels += mantissas.substr(i, 3) + '\x88';
  return pixels;
}

std::string File(const std::string& variables, const std::string& resolution,
                 const std::string& pixels) {
  return "#?RADIANCE\n" + variables + "FORMAT=32-bit_rle_rgbe\n\n" + resolution + "\n" + pixels;
}

Image Decode(const std::string& bytes) { return DecodeImage(bytes, "a.hdr"); }

Image RoundTrip(const Image& image, const WriteOptions& options = {},
                Metadata* metadata = nullptr) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.hdr", image, options);
  return ReadImage(folder / "a.hdr", {}, metadata);
}

TEST(Hdr, RoundTripsWithinItsPrecision) {
  // Half a step of eight bits, relative to the largest channel
  for (const auto& [width, height] :
       {std::pair(1, 1), {1, 9}, {7, 3}, {8, 3}, {300, 5}, {40000, 1}})
    ExpectSame(RoundTrip(Pattern(width, height)), Pattern(width, height), 0.5f / 128.0f);
}

TEST(Hdr, RoundTripsTheWholeRange) {
  for (int e = -120; e <= 126; e += 3) {
    const float value = std::ldexp(1.37f, e);
    const Image back = RoundTrip(Constant(9, 1, vec3(value, value / 2, 0)));
    EXPECT_NEAR(back.pixels[4].x / value, 1, 1.0f / 256) << e;
    EXPECT_NEAR(back.pixels[4].y / value, 0.5f, 1.0f / 256) << e;
    EXPECT_EQ(back.pixels[4].z, 0) << e;
  }
}

TEST(Hdr, RoundsUpIntoTheNextExponent) {
  const Image back = RoundTrip(Constant(1, 1, vec3(0.9999f, 0.5f, 0.25f)));
  EXPECT_EQ(back.pixels[0], vec3(1, 0.5f, 0.25f));
}

TEST(Hdr, KeepsValuesFinite) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Image image(3, 1);
  image.pixels = {vec3(infinity, 1, -1), vec3(nan, 1, 0), vec3(3e38f, 0, -infinity)};
  const Image back = RoundTrip(image);
  EXPECT_TRUE(std::isfinite(back.pixels[0].x));
  EXPECT_GT(back.pixels[0].x, 1e38f);
  EXPECT_EQ(back.pixels[1], vec3(0, 1, 0));
  EXPECT_GT(back.pixels[2].x, 1e38f);
  EXPECT_EQ(back.pixels[2].z, 0);
}

TEST(Hdr, IgnoresExposure) {
  EXPECT_EQ(RoundTrip(Constant(1, 1, vec3(0.5f)), {.exposure = 3}).pixels[0], vec3(0.5f));
}

TEST(Hdr, CompressesRuns) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.hdr", Constant(1000, 10, vec3(0.5f)));
  EXPECT_LT(ReadFile(folder / "a.hdr").size(), 1200u);
}

TEST(Hdr, KeepsMetadata) {
  Metadata read;
  RoundTrip(Pattern(2, 2), {.metadata = {{"Software", "Snell"}, {"EXPOSURE", "8\n9"}}}, &read);
  EXPECT_EQ(Find(read, "Software"), "Snell");
  EXPECT_EQ(Find(read, "EXPOSURE"), "8 9");
}

TEST(Hdr, ReadsFlatPixels) {
  const Image image =
      Decode(File("", "-Y 2 +X 2", Flat("\x01\x02\x03\x04\x05\x06\x07\x08\x09\x10\x11\x12")));
  EXPECT_EQ(image.At(0, 0), vec3(1, 2, 3));
  EXPECT_EQ(image.At(1, 0), vec3(4, 5, 6));
  EXPECT_EQ(image.At(1, 1), vec3(16, 17, 18));
}

TEST(Hdr, ReadsRunsOfPixels) {
  // 7, then 2 + 1·256 more of it in two codes
  const std::string runs =
      Flat("\x07\x07\x07") + "\x01\x01\x01\x02\x01\x01\x01\x01" + Flat("\x05\x05\x05");
  const Image image = Decode(File("", "-Y 1 +X 260", runs));
  EXPECT_EQ(image.At(0, 0), vec3(7));
  EXPECT_EQ(image.At(258, 0), vec3(7));
  EXPECT_EQ(image.At(259, 0), vec3(5));
}

TEST(Hdr, ReadsRunsOfComponents) {
  const std::string row = "\x02\x02\0\x09"s + "\x89\x01"s +
                          "\x09"
                          "ABCDEFGHI"s +
                          "\x84\x02\x85\x03"s + "\x89\x88"s;
  const Image image = Decode(File("", "-Y 1 +X 9", row));
  EXPECT_EQ(image.At(0, 0), vec3(1, 'A', 2));
  EXPECT_EQ(image.At(8, 0), vec3(1, 'I', 3));
}

TEST(Hdr, ReadsEveryOrientation) {
  // Stored rows "1 2 3" and "4 5 6"
  const std::string pixels = Flat("\1\1\1\2\2\2\3\3\3\4\4\4\5\5\5\6\6\6");
  const std::pair<const char*, std::string> cases[] = {
      {"-Y 2 +X 3", "123/456"},  {"-Y 2 -X 3", "321/654"},  {"+Y 2 +X 3", "456/123"},
      {"+Y 2 -X 3", "654/321"},  {"+X 2 -Y 3", "14/25/36"}, {"-X 2 -Y 3", "41/52/63"},
      {"+X 2 +Y 3", "36/25/14"}, {"-X 2 +Y 3", "63/52/41"}};
  for (const auto& [resolution, expected] : cases) {
    // Two codes (1, 1, 1) would be a run: shift the numbers by one
    std::string shifted = pixels;
    for (std::size_t i = 0; i < shifted.size(); ++i)
      if (i % 4 != 3) ++shifted[i];
    const Image image = Decode(File("", resolution, shifted));
    std::string digits;
    for (int y = 0; y < image.height; ++y) {
      if (y > 0) digits += '/';
      for (int x = 0; x < image.width; ++x) digits += char('0' + int(image.At(x, y).x) - 1);
    }
    EXPECT_EQ(digits, expected) << resolution;
  }
}

TEST(Hdr, UndoesExposureAndColorCorrection) {
  const std::string pixel = Flat("\x08\x08\x08");
  EXPECT_EQ(Decode(File("EXPOSURE=4\nEXPOSURE= 0.5\n", "-Y 1 +X 1", pixel)).pixels[0], vec3(4));
  EXPECT_EQ(Decode(File("COLORCORR=1 2 4\n", "-Y 1 +X 1", pixel)).pixels[0], vec3(8, 4, 2));
  EXPECT_EQ(Decode(File("EXPOSURE=0\nEXPOSURE=x\n", "-Y 1 +X 1", pixel)).pixels[0], vec3(8));
}

TEST(Hdr, ConvertsPrimariesAndXyz) {
  const std::string white = Flat("\x08\x08\x08");
  const std::string radiance = "PRIMARIES=.640 .330 .290 .600 .150 .060 .333 .333\n";
  ExpectNear(Decode(File(radiance, "-Y 1 +X 1", white)).pixels[0], vec3(8), 1e-4f);
  const Image green = Decode(File(radiance, "-Y 1 +X 1", Flat("\2\x80\2")));
  EXPECT_GT(std::fabs(green.pixels[0].x - 2), 0.1f);

  const std::string xyz = "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + white;
  ExpectNear(Decode(xyz).pixels[0], vec3(8), 1e-3f);
}

TEST(Hdr, UnknownPrimariesChangeNothing) {
  const std::string file = File("PRIMARIES=0 0 0 0 0 0 0 0\n", "-Y 1 +X 1", Flat("\x08\x05\x02"));
  EXPECT_EQ(Decode(file).pixels[0], vec3(8, 5, 2));
}

TEST(Hdr, EveryTruncationIsAnError) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.hdr", Pattern(20, 3));
  const std::string whole = ReadFile(folder / "a.hdr");
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW(Decode(whole.substr(0, length)), Error) << length;
}

TEST(Hdr, DamageIsNamed) {
  const auto error = [](const std::string& resolution, const std::string& pixels) {
    return ErrorOf([&] { Decode(File("", resolution, pixels)); });
  };
  EXPECT_NE(error("-Y 1 +X 9", "\x02\x02\0\x0a"s).find("another length"), std::string::npos);
  EXPECT_NE(error("-Y 1 +X 9", "\x02\x02\0\x09\xff\x01"s).find("run"), std::string::npos);
  EXPECT_NE(error("-Y 1 +X 9", "\x02\x02\0\x09\0\x01"s).find("run"), std::string::npos);
  EXPECT_NE(error("-Y 1 +X 2", "\x01\x01\x01\x02"s).find("run"), std::string::npos);
  EXPECT_NE(error("-Y 1 -Y 2", "").find("resolution"), std::string::npos);
  EXPECT_NE(error("-Y 1", "").find("resolution"), std::string::npos);
  EXPECT_NE(error("-Y 0 +X 5", "").find("no size"), std::string::npos);
  EXPECT_NE(error("-Y 20000 +X 10000", "").find("cannot hold"), std::string::npos);
  EXPECT_NE(error("-Y 99999999999 +X 9", "").find("no size"), std::string::npos);
  const std::string other = "#?RADIANCE\nFORMAT=64-bit\n\n-Y 1 +X 1\nabcd";
  EXPECT_NE(ErrorOf([&] { Decode(other); }).find("64-bit"), std::string::npos);
}

}  // namespace
}  // namespace snell::image
