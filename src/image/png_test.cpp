// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "image/color.h"
#include "image/read.h"
#include "image/test_images.h"
#include "image/write.h"

namespace snell::image {
namespace {

// A file as another program might write it: `samples` are rows of packed samples, most significant first.
std::string ForeignPng(int width, int height, int depth, int colorType,
                       std::vector<png_byte> samples,
                       const std::function<void(png_structp, png_infop)>& chunks = {},
                       bool interlaced = false) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(data), size);
      },
      nullptr);
  png_set_IHDR(png, info, png_uint_32(width), png_uint_32(height), depth, colorType,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (chunks) chunks(png, info);
  png_write_info(png, info);
  std::vector<png_bytep> rows;
  for (int y = 0; y < height; ++y)
    rows.push_back(samples.data() + png_get_rowbytes(png, info) * std::size_t(y));
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

// The numbers of the first pixels' red channel in 1/255.
std::vector<int> RawReds(const std::string& png) {
  std::vector<int> reds;
  for (const vec3& pixel : DecodeImage(png, "a.png", {ColorSpace::Raw}).pixels)
    reds.push_back(int(std::lround(pixel.x * 255)));
  return reds;
}

Image RoundTrip(const Image& image, const WriteOptions& options, Metadata* metadata = nullptr) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.png", image, options);
  return ReadImage(folder / "a.png", {}, metadata);
}

TEST(Png, RoundTripsAtBothDepths) {
  // The slope of the sRGB function is at most 2.3: half a code is 2.3/2/255 of light
  for (const bool alpha : {false, true}) {
    ExpectSame(RoundTrip(Pattern(37, 23, alpha), {.bits = 8}), Pattern(37, 23, alpha), 0.0046f);
    ExpectSame(RoundTrip(Pattern(37, 23, alpha), {.bits = 16}), Pattern(37, 23, alpha), 0.000018f);
  }
}

TEST(Png, RoundTripsOddSizes) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 19}, {19, 1}, {8, 9}, {4097, 2}})
    ExpectSame(RoundTrip(Pattern(width, height), {.bits = 16}), Pattern(width, height), 0.000018f);
}

TEST(Png, StoresTheNearestCode) {
  Image image(3, 1);
  image.pixels = {vec3(0, DecodeSrgb(100.4f / 255.0f), DecodeSrgb(100.6f / 255.0f)), vec3(2, -1, 1),
                  vec3(0.5f)};
  const TemporaryFolder folder;
  WriteImage(folder / "a.png", image);
  const Image codes = ReadImage(folder / "a.png", {ColorSpace::Raw});
  ExpectNear(codes.pixels[0] * 255.0f, vec3(0, 100, 101), 1e-4f);
  ExpectNear(codes.pixels[1] * 255.0f, vec3(255, 0, 255), 1e-4f);
  ExpectNear(codes.pixels[2] * 255.0f, vec3(188), 1e-4f);
}

TEST(Png, AppliesExposure) {
  const Image darker = RoundTrip(Constant(2, 2, vec3(0.8f)), {.bits = 16, .exposure = -2});
  ExpectNear(darker.pixels[0], vec3(0.2f), 1e-4f);
}

TEST(Png, WritesZeroForWhatIsNotFinite) {
  Image image(2, 1);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  image.pixels = {vec3(nan, 1, std::numeric_limits<float>::infinity()), vec3(0.25f)};
  const Image back = RoundTrip(image, {});
  EXPECT_EQ(back.pixels[0], vec3(0, 1, 0));
}

TEST(Png, DividesPremultipliedColorByAlpha) {
  Image image(2, 1);
  image.pixels = {vec3(0.25f), vec3(0.7f)};
  image.alpha = {0.5f, 0};
  image.premultiplied = true;
  const Image back = RoundTrip(image, {.bits = 16});
  EXPECT_FALSE(back.premultiplied);
  ExpectNear(back.pixels[0], vec3(0.5f), 1e-4f);
  EXPECT_EQ(back.pixels[1], vec3(0));
  EXPECT_NEAR(back.alpha[0], 0.5f, 1e-5f);
}

TEST(Png, KeepsMetadata) {
  const Metadata written{{"Software", "Snell"},
                         {"Comment", "größer als π"},
                         {"Empty", ""},
                         {"Long", std::string(5000, 'x')},
                         {"Lines", "one\ntwo"}};
  Metadata read;
  RoundTrip(Pattern(2, 2), {.metadata = written}, &read);
  for (const auto& [key, value] : written) EXPECT_EQ(Find(read, key), value) << key;
}

TEST(Png, MarksItselfAsSrgb) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.png", Pattern(2, 2));
  const std::string bytes = ReadFile(folder / "a.png");
  EXPECT_NE(bytes.find("sRGB"), bytes.npos);
  EXPECT_NE(bytes.find("gAMA"), bytes.npos);
}

TEST(Png, SameInputGivesTheSameBytes) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.png", Pattern(20, 20));
  WriteImage(folder / "b.png", Pattern(20, 20));
  EXPECT_EQ(ReadFile(folder / "a.png"), ReadFile(folder / "b.png"));
}

TEST(Png, ReadsEveryDepthOfGray) {
  EXPECT_EQ(RawReds(ForeignPng(4, 1, 1, PNG_COLOR_TYPE_GRAY, {0b1010'0000})),
            (std::vector{255, 0, 255, 0}));
  EXPECT_EQ(RawReds(ForeignPng(4, 1, 2, PNG_COLOR_TYPE_GRAY, {0b00'01'10'11})),
            (std::vector{0, 85, 170, 255}));
  EXPECT_EQ(RawReds(ForeignPng(2, 1, 4, PNG_COLOR_TYPE_GRAY, {0x0f})), (std::vector{0, 255}));
  EXPECT_EQ(RawReds(ForeignPng(2, 1, 8, PNG_COLOR_TYPE_GRAY, {7, 200})), (std::vector{7, 200}));
  EXPECT_EQ(RawReds(ForeignPng(1, 1, 16, PNG_COLOR_TYPE_GRAY, {0x64, 0x64})), (std::vector{100}));
}

TEST(Png, ReadsPalettesWithTransparency) {
  png_color colors[] = {{10, 20, 30}, {40, 50, 60}, {70, 80, 90}};
  png_byte alphas[] = {255, 51};
  const std::string png =
      ForeignPng(3, 1, 2, PNG_COLOR_TYPE_PALETTE, {0b00'01'10'00}, [&](png_structp p, png_infop i) {
        png_set_PLTE(p, i, colors, 3);
        png_set_tRNS(p, i, alphas, 2, nullptr);
      });
  const Image image = DecodeImage(png, "a.png", {ColorSpace::Raw});
  ExpectNear(image.pixels[1] * 255.0f, vec3(40, 50, 60), 1e-4f);
  ASSERT_TRUE(image.HasAlpha());
  EXPECT_FLOAT_EQ(image.alpha[0], 1);
  EXPECT_FLOAT_EQ(image.alpha[1], 0.2f);
  EXPECT_FLOAT_EQ(image.alpha[2], 1);
}

TEST(Png, ReadsTransparentColors) {
  png_color_16 transparent = {};
  transparent.gray = 9;
  const std::string png =
      ForeignPng(2, 1, 8, PNG_COLOR_TYPE_GRAY, {9, 10},
                 [&](png_structp p, png_infop i) { png_set_tRNS(p, i, nullptr, 0, &transparent); });
  const Image image = DecodeImage(png, "a.png");
  EXPECT_EQ(image.alpha, (std::vector{0.0f, 1.0f}));
}

TEST(Png, ReadsInterlacedPictures) {
  std::vector<png_byte> samples;
  for (int i = 0; i < 13 * 11 * 3; ++i) samples.push_back(png_byte(i * 7));
  const std::string plain = ForeignPng(13, 11, 8, PNG_COLOR_TYPE_RGB, samples);
  const std::string interlaced = ForeignPng(13, 11, 8, PNG_COLOR_TYPE_RGB, samples, {}, true);
  EXPECT_NE(plain, interlaced);
  ExpectSame(DecodeImage(interlaced, "a.png"), DecodeImage(plain, "a.png"), 0);
}

TEST(Png, HonoursGammaUnlessToldOtherwise) {
  const auto withGamma = [](double gamma) {
    return ForeignPng(1, 1, 8, PNG_COLOR_TYPE_GRAY, {128},
                      [=](png_structp p, png_infop i) { png_set_gAMA(p, i, gamma); });
  };
  const auto value = [](const std::string& png, ColorSpace space) {
    return DecodeImage(png, "a.png", {space}).pixels[0].x;
  };
  const float code = 128.0f / 255.0f;
  EXPECT_FLOAT_EQ(value(withGamma(1.0), ColorSpace::FromFile), code);
  EXPECT_FLOAT_EQ(value(withGamma(0.5), ColorSpace::FromFile), code * code);
  EXPECT_FLOAT_EQ(value(withGamma(0.45455), ColorSpace::FromFile), DecodeSrgb(code));
  EXPECT_FLOAT_EQ(value(withGamma(1.0), ColorSpace::Srgb), DecodeSrgb(code));
  EXPECT_FLOAT_EQ(value(withGamma(0.5), ColorSpace::Raw), code);
}

TEST(Png, TurnsAsItsExifSays) {
  png_byte exif[] = {'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0,
                     3,   0,   0, 0,  1, 0, 6, 0, 0, 0, 0, 0,    0};
  const std::string png =
      ForeignPng(2, 1, 8, PNG_COLOR_TYPE_GRAY, {1, 2},
                 [&](png_structp p, png_infop i) { png_set_eXIf_1(p, i, sizeof(exif), exif); });
  const Image image = DecodeImage(png, "a.png", {ColorSpace::Raw});
  EXPECT_EQ(image.width, 1);
  EXPECT_EQ(image.height, 2);
}

TEST(Png, EveryTruncationIsAnError) {
  std::vector<png_byte> samples(64, 5);
  const std::string whole = ForeignPng(8, 8, 8, PNG_COLOR_TYPE_GRAY, samples);
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW(DecodeImage(whole.substr(0, length), "a.png"), Error) << length;
}

TEST(Png, DamageIsLocated) {
  std::string png = ForeignPng(8, 8, 8, PNG_COLOR_TYPE_GRAY, std::vector<png_byte>(64, 5));
  png[png.find("IDAT") + 8] ^= 0x55;
  const std::string error = ErrorOf([&] { DecodeImage(png, "a.png"); });
  EXPECT_EQ(error.find("a.png, byte "), 0u) << error;
  EXPECT_NE(error.find("the PNG is damaged"), error.npos) << error;
}

TEST(Png, HugePromisesInSmallFilesAreRefusedBeforeMemoryIsTaken) {
  std::string png = ForeignPng(16000, 1, 8, PNG_COLOR_TYPE_RGB, std::vector<png_byte>(48000, 5));
  // Promise 16000 rows; the checksum of the header has to agree
  png[22] = char(16000 >> 8);
  png[23] = char(16000 & 0xff);
  std::uint32_t crc = ~0u;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<unsigned char>(png[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  for (int i = 0; i < 4; ++i) png[29 + std::size_t(i)] = char(~crc >> (24 - 8 * i));
  const std::string error = ErrorOf([&] { DecodeImage(png, "a.png"); });
  EXPECT_NE(error.find("cannot hold"), error.npos) << error;
}

}  // namespace
}  // namespace snell::image
