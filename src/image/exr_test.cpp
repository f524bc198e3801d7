// SPDX-License-Identifier: Apache-2.0
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "image/read.h"
#include "image/test_images.h"
#include "image/write.h"

namespace snell::image {
namespace {

using Imath::Box2i;
using Imath::V2i;

// One value per pixel of the data window for every channel, the same in all of them plus its number.
void WriteForeign(const std::filesystem::path& path, Imf::Header header,
                  const std::vector<std::string>& names, Imf::PixelType type = Imf::FLOAT) {
  const Box2i& window = header.dataWindow();
  const std::size_t width = std::size_t(window.max.x - window.min.x + 1);
  const std::size_t count = width * std::size_t(window.max.y - window.min.y + 1);
  std::vector<std::vector<float>> floats(names.size());
  std::vector<std::vector<unsigned>> integers(names.size());
  Imf::FrameBuffer buffer;
  for (std::size_t n = 0; n < names.size(); ++n) {
    for (std::size_t i = 0; i < count; ++i) {
      floats[n].push_back(float(i + 10 * n));
      integers[n].push_back(unsigned(i + 10 * n));
    }
    header.channels().insert(names[n], Imf::Channel(type));
    char* first = type == Imf::UINT ? reinterpret_cast<char*>(integers[n].data())
                                    : reinterpret_cast<char*>(floats[n].data());
    buffer.insert(names[n], Imf::Slice::Make(type, first, window, 4, 4 * width));
  }
  if (header.hasTileDescription()) {
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(window.max.y - window.min.y + 1);
  }
}

Image RoundTrip(const Image& image, const WriteOptions& options = {},
                Metadata* metadata = nullptr) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.exr", image, options);
  return ReadImage(folder / "a.exr", {}, metadata);
}

TEST(Exr, FloatIsExact) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 17}, {17, 1}, {33, 35}})
    ExpectSame(RoundTrip(Pattern(width, height), {.exrFloat = true}), Pattern(width, height), 0);
}

TEST(Exr, HalfRoundsToElevenBits) {
  ExpectSame(RoundTrip(Pattern(33, 35)), Pattern(33, 35), 1.0f / 2048);
  EXPECT_EQ(RoundTrip(Constant(1, 1, vec3(1, 0.5f, 1000))).pixels[0], vec3(1, 0.5f, 1000));
}

TEST(Exr, HalfClampsWhatItCannotHold) {
  const float infinity = std::numeric_limits<float>::infinity();
  Image image(2, 1);
  image.pixels = {vec3(1e6f, -1e6f, infinity), vec3(65519, 65504, std::nanf(""))};
  const Image back = RoundTrip(image);
  EXPECT_EQ(back.pixels[0], vec3(65504, -65504, 65504));
  EXPECT_EQ(back.pixels[1].x, 65504);
  EXPECT_TRUE(std::isnan(back.pixels[1].z));
}

TEST(Exr, FloatKeepsEverything) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Image back = RoundTrip(Constant(1, 1, vec3(3e38f, -1e-40f, infinity)), {.exrFloat = true});
  EXPECT_EQ(back.pixels[0], vec3(3e38f, -1e-40f, infinity));
}

TEST(Exr, ExposureAndBitsChangeNothing) {
  const Image back = RoundTrip(Constant(1, 1, vec3(0.5f, 2, 8)), {.bits = 16, .exposure = 5});
  EXPECT_EQ(back.pixels[0], vec3(0.5f, 2, 8));
}

TEST(Exr, AlphaIsPremultiplied) {
  const Image back = RoundTrip(Pattern(5, 5, true), {.exrFloat = true});
  EXPECT_TRUE(back.premultiplied);
  for (std::size_t i = 0; i < back.pixels.size(); ++i)
    ExpectNear(back.pixels[i], Pattern(5, 5, true).Premultiplied(i), 1e-7f);
  EXPECT_EQ(back.alpha, Pattern(5, 5, true).alpha);

  // Light without coverage, as of a flame, survives
  Image flame = Constant(1, 1, vec3(3));
  flame.alpha = {0};
  flame.premultiplied = true;
  EXPECT_EQ(RoundTrip(flame).pixels[0], vec3(3));
}

TEST(Exr, KeepsMetadata) {
  const Metadata written{{"Software", "Snell"},
                         {"comments", "zwölf\nStühle"},
                         {"Empty", ""},
                         {"A key of more than thirty-one characters", "x"}};
  Metadata read;
  RoundTrip(Pattern(2, 2), {.metadata = written}, &read);
  for (const auto& [key, value] : written) EXPECT_EQ(Find(read, key), value) << key;
}

TEST(Exr, NamesOfOpenExrAreNoMetadata) {
  const TemporaryFolder folder;
  for (const char* name : {"compression", "type", "tiles", "dataWindow"})
    EXPECT_THROW(WriteImage(folder / "a.exr", Pattern(2, 2), {.metadata = {{name, "x"}}}), Error);
  EXPECT_EQ(folder.FileCount(), 0u);
}

TEST(Exr, ReadsTiles) {
  const TemporaryFolder folder;
  for (const auto mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS}) {
    Imf::Header header(37, 21);
    header.setTileDescription(Imf::TileDescription(16, 8, mode));
    WriteForeign(folder / "a.exr", header, {"R", "G", "B"});
    const Image image = ReadImage(folder / "a.exr");
    ASSERT_EQ(image.pixels.size(), 37u * 21u);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      ASSERT_EQ(image.pixels[i], vec3(float(i), float(i + 10), float(i + 20)));
  }
}

TEST(Exr, ReadsLuminance) {
  const TemporaryFolder folder;
  WriteForeign(folder / "a.exr", Imf::Header(4, 2), {"Y"});
  EXPECT_EQ(ReadImage(folder / "a.exr").pixels[5], vec3(5));
  WriteForeign(folder / "b.exr", Imf::Header(4, 2), {"A", "Y"});
  EXPECT_EQ(ReadImage(folder / "b.exr").alpha[5], 5);
  EXPECT_EQ(ReadImage(folder / "b.exr").pixels[5], vec3(15));
}

TEST(Exr, ReadsIntegersAndMissingChannels) {
  const TemporaryFolder folder;
  WriteForeign(folder / "a.exr", Imf::Header(4, 2), {"R", "G"}, Imf::UINT);
  EXPECT_EQ(ReadImage(folder / "a.exr").pixels[7], vec3(7, 17, 0));
}

TEST(Exr, ReadsTheOnlyLayerWithColor) {
  const TemporaryFolder folder;
  WriteForeign(folder / "a.exr", Imf::Header(4, 2),
               {"View.Color.R", "View.Color.G", "View.Color.B", "View.Color.A", "View.Depth.Z"});
  const Image image = ReadImage(folder / "a.exr");
  EXPECT_EQ(image.pixels[1], vec3(1, 11, 21));
  EXPECT_EQ(image.alpha[1], 31);
}

TEST(Exr, NamesTheChannelsWhenNoneIsColor) {
  const TemporaryFolder folder;
  WriteForeign(folder / "a.exr", Imf::Header(4, 2), {"Z", "id"});
  const std::string error = ErrorOf([&] { ReadImage(folder / "a.exr"); });
  EXPECT_NE(error.find("Z, id"), error.npos) << error;
}

TEST(Exr, ReadsLuminanceChroma) {
  const TemporaryFolder folder;
  {
    std::vector<Imf::Rgba> pixels(32 * 16, Imf::Rgba(0.5f, 0.25f, 0.125f));
    Imf::RgbaOutputFile file((folder / "a.exr").c_str(), 32, 16, Imf::WRITE_YC);
    file.setFrameBuffer(pixels.data(), 1, 32);
    file.writePixels(16);
  }
  const Image image = ReadImage(folder / "a.exr");
  ASSERT_EQ(image.width, 32);
  ExpectNear(image.At(10, 5), vec3(0.5f, 0.25f, 0.125f), 0.004f);
}

TEST(Exr, PlacesTheDataWindowInTheDisplayWindow) {
  const TemporaryFolder folder;
  const Box2i display(V2i(10, 20), V2i(15, 23));
  const auto read = [&](const Box2i& data, const std::vector<std::string>& names) {
    WriteForeign(folder / "a.exr", Imf::Header(display, data), names);
    const Image image = ReadImage(folder / "a.exr");
    EXPECT_EQ(image.width, 6);
    EXPECT_EQ(image.height, 4);
    return image;
  };
  // Inside: the rest is black and transparent
  const Image inside = read(Box2i(V2i(12, 21), V2i(13, 22)), {"R", "G", "B", "A"});
  EXPECT_EQ(inside.At(1, 1), vec3(0));
  EXPECT_EQ(inside.alpha[inside.Index(1, 1)], 0);
  EXPECT_EQ(inside.At(2, 1), vec3(0, 10, 20));
  EXPECT_EQ(inside.At(3, 2), vec3(3, 13, 23));
  EXPECT_EQ(inside.alpha[inside.Index(3, 2)], 33);
  // Larger: the overscan goes; negative coordinates are coordinates too
  const Image larger = read(Box2i(V2i(-5, -7), V2i(30, 40)), {"R", "G", "B"});
  EXPECT_EQ(larger.At(0, 0).x, float(27 * 36 + 15));
  // Elsewhere: nothing is seen
  const Image elsewhere = read(Box2i(V2i(100, 100), V2i(101, 101)), {"R", "G", "B"});
  for (const vec3& pixel : elsewhere.pixels) EXPECT_EQ(pixel, vec3(0));
}

TEST(Exr, ASmallCropTakesNoLargeMemory) {
  const TemporaryFolder folder;
  const Box2i crop(V2i(1, 1), V2i(1, 1));
  WriteForeign(folder / "a.exr", Imf::Header(Box2i(V2i(0, 0), V2i(16383, 16382)), crop), {"Y"});
  EXPECT_NE(ErrorOf([&] { ReadImage(folder / "a.exr"); }).find("far larger"), std::string::npos);
}

TEST(Exr, ConvertsChromaticitiesUnlessRaw) {
  const TemporaryFolder folder;
  Imf::Header header(4, 2);
  Imf::addChromaticities(header, Imf::Chromaticities({0.708f, 0.292f}, {0.170f, 0.797f},
                                                     {0.131f, 0.046f}, {0.3127f, 0.3290f}));
  WriteForeign(folder / "a.exr", header, {"G"});  // 0 1 2 … of Rec.2020 green
  ExpectNear(ReadImage(folder / "a.exr").pixels[1], vec3(-0.5876f, 1.1329f, -0.1006f), 1e-3f);
  EXPECT_EQ(ReadImage(folder / "a.exr", {ColorSpace::Raw}).pixels[1], vec3(0, 1, 0));
}

TEST(Exr, AttributesMustFitTheFileAndTheirTypes) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.exr", Pattern(4, 4), {.metadata = {{"Note", "hello"}}});
  const std::string whole = ReadFile(folder / "a.exr");
  const auto withSize = [&](const std::string& nameAndType, char low, char high) {
    std::string bytes = whole;
    const std::size_t size = bytes.find(nameAndType) + nameAndType.size();
    bytes[size] = low;
    bytes[size + 3] = high;
    return ErrorOf([&] { DecodeImage(bytes, "a.exr"); });
  };
  using std::string_literals::operator""s;
  for (const std::string& error :
       {withSize("Note\0string\0"s, 5, 0x7f), withSize("Note\0string\0"s, 0, -1),
        withSize("dataWindow\0box2i\0"s, 12, 0), withSize("channels\0chlist\0"s, 9, 0)})
    EXPECT_NE(error.find("impossible size"), error.npos) << error;
}

TEST(Exr, EveryTruncationIsAnError) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.exr", Pattern(9, 40));
  const std::string whole = ReadFile(folder / "a.exr");
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW(DecodeImage(whole.substr(0, length), "a.exr"), Error) << length;
}

}  // namespace
}  // namespace snell::image
