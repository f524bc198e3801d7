// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdio>

#include <jpeglib.h>

#include <cstdlib>
#include <functional>
#include <vector>

#include "image/color.h"
#include "image/read.h"
#include "image/test_images.h"
#include "image/write.h"

namespace snell::image {
namespace {

// A file as another program might write it, of interleaved samples.
std::string ForeignJpeg(int width, int height, J_COLOR_SPACE space, int components,
                        std::vector<JSAMPLE> samples,
                        const std::function<void(j_compress_ptr)>& configure = {},
                        const std::function<void(j_compress_ptr)>& markers = {}) {
  jpeg_error_mgr errors;
  jpeg_compress_struct jpeg = {};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &memory, &size);
  jpeg.image_width = JDIMENSION(width);
  jpeg.image_height = JDIMENSION(height);
  jpeg.input_components = components;
  jpeg.in_color_space = space;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  if (configure) configure(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  if (markers) markers(&jpeg);
  for (int y = 0; y < height; ++y) {
    JSAMPLE* row = samples.data() + std::size_t(y) * std::size_t(width * components);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string bytes(reinterpret_cast<char*>(memory), size);
  std::free(memory);
  return bytes;
}

std::vector<JSAMPLE> Repeated(std::vector<JSAMPLE> pixel, int count) {
  std::vector<JSAMPLE> samples;
  for (int i = 0; i < count; ++i) samples.insert(samples.end(), pixel.begin(), pixel.end());
  return samples;
}

// Smooth enough for JPEG to keep.
Image Ramp(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.At(x, y) = DecodeSrgb(vec3(0.2f + 0.6f * float(x) / float(width),
                                       0.3f + 0.4f * float(y) / float(height), 0.5f));
  return image;
}

Image RoundTrip(const Image& image, const WriteOptions& options, Metadata* metadata = nullptr) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.jpg", image, options);
  return ReadImage(folder / "a.jpg", {}, metadata);
}

TEST(Jpeg, RoundTripsSmoothPictures) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 33}, {33, 1}, {61, 47}})
    ExpectSame(RoundTrip(Ramp(width, height), {.jpegQuality = 98}), Ramp(width, height), 0.02f);
}

TEST(Jpeg, KeepsColorAtFullResolutionAtHighQuality) {
  // Columns of red and blue, one pixel wide, would mix if colour were subsampled
  Image image(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) image.At(x, y) = x % 2 ? vec3(1, 0, 0) : vec3(0, 0, 1);
  ExpectNear(RoundTrip(image, {.jpegQuality = 98}).At(5, 5), vec3(1, 0, 0), 0.1f);
}

TEST(Jpeg, QualityTradesSize) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.jpg", Pattern(64, 64), {.jpegQuality = 95});
  WriteImage(folder / "b.jpeg", Pattern(64, 64), {.jpegQuality = 30});
  EXPECT_GT(ReadFile(folder / "a.jpg").size(), 2 * ReadFile(folder / "b.jpeg").size());
}

TEST(Jpeg, AlphaIsSeenAgainstBlack) {
  Image image = Constant(8, 8, vec3(0.8f));
  image.alpha.assign(64, 0.25f);
  const Image back = RoundTrip(image, {});
  EXPECT_FALSE(back.HasAlpha());
  ExpectNear(back.pixels[0], vec3(0.2f), 0.01f);
}

TEST(Jpeg, KeepsMetadataAsComments) {
  Metadata read;
  RoundTrip(Ramp(8, 8), {.metadata = {{"Software", "Snell"}, {"Note", "zwölf\nStühle"}}}, &read);
  EXPECT_EQ(Find(read, "Software"), "Snell");
  EXPECT_EQ(Find(read, "Note"), "zwölf Stühle");
}

TEST(Jpeg, TooLongMetadataAreAnError) {
  const TemporaryFolder folder;
  EXPECT_THROW(
      WriteImage(folder / "a.jpg", Ramp(8, 8), {.metadata = {{"Note", std::string(70000, 'x')}}}),
      Error);
}

TEST(Jpeg, TooManyPixelsAreAnError) {
  const TemporaryFolder folder;
  const std::string error = ErrorOf([&] { WriteImage(folder / "a.jpg", Image(65501, 1)); });
  EXPECT_NE(error.find("65500"), error.npos) << error;
}

TEST(Jpeg, ReadsGray) {
  const std::string jpeg = ForeignJpeg(9, 9, JCS_GRAYSCALE, 1, Repeated({77}, 81));
  ExpectNear(DecodeImage(jpeg, "a.jpg", {ColorSpace::Raw}).At(8, 8) * 255.0f, vec3(77), 1.01f);
}

TEST(Jpeg, ReadsRgbStoredAsRgb) {
  const std::string jpeg = ForeignJpeg(8, 8, JCS_RGB, 3, Repeated({200, 100, 50}, 64),
                                       [](j_compress_ptr j) { jpeg_set_colorspace(j, JCS_RGB); });
  ExpectNear(DecodeImage(jpeg, "a.jpg", {ColorSpace::Raw}).At(3, 3) * 255.0f, vec3(200, 100, 50),
             1.01f);
}

TEST(Jpeg, ReadsProgressive) {
  const auto progressive = [](j_compress_ptr j) { jpeg_simple_progression(j); };
  const std::string jpeg = ForeignJpeg(8, 8, JCS_RGB, 3, Repeated({200, 100, 50}, 64), progressive);
  ExpectNear(DecodeImage(jpeg, "a.jpg", {ColorSpace::Raw}).At(3, 3) * 255.0f, vec3(200, 100, 50),
             2.01f);
}

TEST(Jpeg, ReadsInk) {
  // Adobe stores light instead of ink; libjpeg writes its marker for both of these
  const std::vector<JSAMPLE> samples = Repeated({255, 128, 0, 204}, 64);
  for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
    const std::string jpeg = ForeignJpeg(8, 8, JCS_CMYK, 4, samples,
                                         [&](j_compress_ptr j) { jpeg_set_colorspace(j, stored); });
    const Image image = DecodeImage(jpeg, "a.jpg", {ColorSpace::Raw});
    ExpectNear(image.At(2, 2) * 255.0f, vec3(204, 102.4f, 0), 2.01f);
  }
  // Without the marker, 255 is full ink
  const std::string plain = ForeignJpeg(8, 8, JCS_CMYK, 4, samples,
                                        [](j_compress_ptr j) { j->write_Adobe_marker = FALSE; });
  ExpectNear(DecodeImage(plain, "a.jpg", {ColorSpace::Raw}).At(2, 2) * 255.0f, vec3(0, 25.4f, 51),
             2.01f);
}

TEST(Jpeg, TurnsAsItsExifSays) {
  std::vector<JSAMPLE> samples;
  for (int i = 0; i < 16 * 8; ++i) samples.push_back(i % 16 < 8 ? 0 : 255);  // bright at the right
  const auto exif = [](j_compress_ptr j) {
    const unsigned char body[] = {'E',  'x', 'i', 'f', 0, 0, 'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0,
                                  0x12, 1,   3,   0,   1, 0, 0,   0,   6,  0, 0, 0, 0, 0, 0, 0};
    jpeg_write_marker(j, JPEG_APP0 + 1, body, sizeof(body));
  };
  const Image image = DecodeImage(ForeignJpeg(16, 8, JCS_GRAYSCALE, 1, samples, {}, exif), "a.jpg");
  ASSERT_EQ(image.width, 8);
  ASSERT_EQ(image.height, 16);
  EXPECT_LT(image.At(4, 0).x, 0.01f);
  EXPECT_GT(image.At(4, 15).x, 0.99f);
}

TEST(Jpeg, EveryTruncationIsAnError) {
  const std::string whole = ForeignJpeg(24, 24, JCS_RGB, 3, Repeated({1, 2, 3}, 576));
  for (std::size_t length = 0; length + 2 < whole.size(); ++length)
    EXPECT_THROW(DecodeImage(whole.substr(0, length), "a.jpg"), Error) << length;
}

TEST(Jpeg, TooManyScansAreAnError) {
  // Repeat the first scan of a progressive picture, which costs a pass over it each time
  const std::string first = ForeignJpeg(8, 8, JCS_GRAYSCALE, 1, Repeated({9}, 64),
                                        [&](auto j) { jpeg_simple_progression(j); });
  const std::size_t scan = first.find("\xff\xda"), next = first.find("\xff\xc4", scan);
  ASSERT_NE(next, first.npos);
  std::string many = first.substr(0, next);
  for (int i = 0; i < 600; ++i) many += first.substr(scan, next - scan);
  many += first.substr(next);
  const std::string error = ErrorOf([&] { DecodeImage(many, "a.jpg"); });
  EXPECT_NE(error.find("too many scans"), error.npos) << error;
}

}  // namespace
}  // namespace snell::image
