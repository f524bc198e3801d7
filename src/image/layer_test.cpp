// SPDX-License-Identifier: Apache-2.0
//
// EXRs with layers, as other programs read them.
#include "image/layer.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "image/read.h"
#include "image/test_images.h"
#include "image/write.h"

namespace snell::image {
namespace {

constexpr int Width = 5, Height = 3;

Layers LayersOf() {
  Layers layers;
  layers.layers = {{"albedo", {"R", "G", "B"}, true, {}},
                   {"depth", {"Z"}, false, {}},
                   {"crypto_object00", {"R", "G", "B", "A"}, false, {}}};
  for (Layer& layer : layers.layers) {
    for (std::size_t i = 0; i < Width * Height * layer.channels.size(); ++i)
      layer.values.push_back(layer.isColor ? float(i) / 64
                                           : std::bit_cast<float>(0x13851a76 + std::uint32_t(i)));
  }
  layers.metadata = {{"cryptomatte/1234567/name", "crypto_object"}};
  return layers;
}

std::vector<float> ChannelOf(Imf::InputFile& file, const std::string& name) {
  std::vector<float> values(Width * Height);
  Imf::FrameBuffer buffer;
  buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), file.header().dataWindow()));
  file.setFrameBuffer(buffer);
  file.readPixels(0, Height - 1);
  return values;
}

TEST(Layers, StandBesideThePicture) {
  const TemporaryFolder folder;
  const Layers layers = LayersOf();
  WriteOptions options;
  options.layers = &layers;
  WriteImage(folder / "a.exr", Pattern(Width, Height), options);

  // The picture is read as ever
  Metadata metadata;
  ExpectSame(ReadImage(folder / "a.exr", {}, &metadata), Pattern(Width, Height), 1.0f / 2048);
  EXPECT_EQ(metadata, layers.metadata);

  Imf::InputFile file((folder / "a.exr").c_str(), 0);
  const Imf::ChannelList& channels = file.header().channels();
  EXPECT_EQ(channels.findChannel("albedo.R")->type, Imf::HALF);
  EXPECT_EQ(channels.findChannel("depth.Z")->type, Imf::FLOAT);
  for (const Layer& layer : layers.layers) {
    for (std::size_t c = 0; c < layer.channels.size(); ++c) {
      const std::vector<float> read = ChannelOf(file, layer.name + "." + layer.channels[c]);
      for (std::size_t i = 0; i < read.size(); ++i) {
        const float written = layer.values[i * layer.channels.size() + c];
        EXPECT_EQ(std::bit_cast<std::uint32_t>(read[i]), std::bit_cast<std::uint32_t>(written));
      }
    }
  }
}

TEST(Layers, AreListed) {
  const TemporaryFolder folder;
  const Layers layers = LayersOf();
  WriteOptions options;
  options.layers = &layers;
  WriteImage(folder / "a.exr", Pattern(Width, Height), options);
  const ExrSummary summary = SummarizeExr(folder / "a.exr");
  EXPECT_EQ(summary.width, Width);
  EXPECT_EQ(summary.height, Height);
  ASSERT_EQ(summary.channels.size(), 11u);
  EXPECT_EQ(summary.channels[0], (std::pair<std::string, std::string>("B", "half")));
  EXPECT_EQ(summary.channels[10], (std::pair<std::string, std::string>("depth.Z", "float")));
}

TEST(Layers, FormatsWithoutThemLeaveThemOut) {
  const TemporaryFolder folder;
  const Layers layers = LayersOf();
  WriteOptions options;
  options.layers = &layers;
  WriteImage(folder / "a.png", Pattern(Width, Height), options);
  EXPECT_EQ(ReadImage(folder / "a.png").width, Width);
}

}  // namespace
}  // namespace snell::image
