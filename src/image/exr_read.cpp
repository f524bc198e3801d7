// SPDX-License-Identifier: Apache-2.0
//
// OpenEXR pictures by the reference library: scan lines and tiles, every compression, half, float and
// uint, multi-part, RGB, luminance and luminance/chroma; the data window placed in the display window;
// chromaticities converted to Rec.709. Deep data are refused. (OpenEXR Technical Introduction, 3.1.)
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfTiledInputPart.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <utility>

#include "image/chromaticity.h"
#include "image/codec.h"
#include "image/exr_header.h"

namespace snell::image {

namespace {

using Imath::Box2i;

class MemoryStream : public Imf::IStream {
 public:
  explicit MemoryStream(const Source& source)
      : Imf::IStream(source.name.c_str()), bytes_(source.bytes) {}

  bool read(char to[], int count) override {
    if (count < 0 || position_ > bytes_.size() || std::size_t(count) > bytes_.size() - position_)
      throw std::runtime_error("the file ends early");
    std::memcpy(to, bytes_.data() + position_, std::size_t(count));
    position_ += std::size_t(count);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::uint64_t position_ = 0;
};

enum class Coding { Rgb, Gray, LuminanceChroma };

// Which channels of a part make its colour. Missing ones of the three are black.
struct ColorChannels {
  Coding coding = Coding::Rgb;
  std::array<std::string, 3> names;  // the first one only, if Gray
  std::string alpha;                 // "" if there is none
};

// Find the colour in a list of channels: its own R, G, B or Y, else those of its only layer that has all
// of R, G and B ("beauty.R"). False if there is none.
bool FindColor(const Imf::ChannelList& channels, ColorChannels& found) {
  const auto has = [&](const std::string& name) { return channels.findChannel(name) != nullptr; };
  const auto layer = [&](const std::string& prefix) {
    found = {Coding::Rgb, {prefix + "R", prefix + "G", prefix + "B"}, ""};
    if (has(prefix + "A")) found.alpha = prefix + "A";
  };

  layer("");
  if (has("R") || has("G") || has("B")) return true;
  if (has("Y")) {
    found.names[0] = "Y";
    found.coding = has("RY") || has("BY") ? Coding::LuminanceChroma : Coding::Gray;
    return true;
  }

  std::set<std::string> names;
  channels.layers(names);
  std::erase_if(names, [&](const std::string& name) {
    return !has(name + ".R") || !has(name + ".G") || !has(name + ".B");
  });
  if (names.size() != 1) return false;
  layer(*names.begin() + ".");
  return true;
}

bool IsDeep(const Imf::Header& header) {
  return header.hasType() && Imf::isDeepData(header.type());
}

// The first part with colour.
int FindPart(const Imf::MultiPartInputFile& file, const Source& source, ColorChannels& channels) {
  std::string names;
  for (int part = 0; part < file.parts(); ++part) {
    const Imf::Header& header = file.header(part);
    if (IsDeep(header)) continue;
    if (FindColor(header.channels(), channels)) return part;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
      if (names.size() < 200) names += (names.empty() ? "" : ", ") + Printable(it.name());
  }
  if (names.empty() && file.parts() > 0 && IsDeep(file.header(0)))
    throw source.Fault("deep EXR pictures cannot be read", -1,
                       "flatten it to one colour per pixel first");
  throw source.Fault(fmt::format("the EXR has no colour channels that stand out ({})", names), -1,
                     "name them R, G, B or Y");
}

std::int64_t WidthOf(const Box2i& box) { return std::int64_t(box.max.x) - box.min.x + 1; }
std::int64_t HeightOf(const Box2i& box) { return std::int64_t(box.max.y) - box.min.y + 1; }

// Check everything that memory depends on.
void CheckPart(const Imf::Header& header, const ColorChannels& channels, const Source& source) {
  const Box2i& data = header.dataWindow();
  source.CheckSize(WidthOf(header.displayWindow()), HeightOf(header.displayWindow()));
  source.CheckSize(WidthOf(data), HeightOf(data));
  const std::uint64_t pixels = std::uint64_t(WidthOf(data)) * std::uint64_t(HeightOf(data));

  // A small crop of a picture of 8K is one, of a far larger one is damage
  constexpr std::uint64_t CropOf = std::uint64_t(1) << 25;
  const std::uint64_t framed = std::uint64_t(WidthOf(header.displayWindow())) *
                               std::uint64_t(HeightOf(header.displayWindow()));
  if (framed > std::max(16 * pixels, CropOf))
    throw source.Fault("the display window of the EXR is far larger than its data window");

  // How well a format can pack: deflate 1032 to 1, which DWA applies to what is already 1 in 64
  std::uint64_t bitsPerPixel = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    const std::uint64_t bits = it.channel().type == Imf::HALF ? 16 : 32;
    const auto sampling = std::int64_t(it.channel().xSampling) * it.channel().ySampling;
    bitsPerPixel += bits / std::uint64_t(std::max<std::int64_t>(sampling, 1));
  }
  const bool dwa = header.compression() == Imf::DWAA_COMPRESSION ||
                   header.compression() == Imf::DWAB_COMPRESSION;
  source.CheckPlausible(pixels * bitsPerPixel / 8, dwa ? 100000 : 2000);

  // A tile is held in memory as a whole
  if (header.hasTileDescription()) {
    const std::uint64_t tile =
        std::uint64_t(header.tileDescription().xSize) * header.tileDescription().ySize;
    if (tile > std::max(pixels, std::uint64_t(1) << 22))
      throw source.Fault("the tiles of the EXR are far larger than its picture");
    if (channels.coding == Coding::LuminanceChroma)
      throw source.Fault("tiled luminance/chroma EXR pictures cannot be read");
  }
}

// A slice of memory for one channel, one float in each pixel of the data window.
Imf::Slice FloatSlice(float* first, std::size_t pixelStride, const Box2i& window) {
  return Imf::Slice::Make(Imf::FLOAT, first, window, pixelStride,
                          pixelStride * std::size_t(WidthOf(window)));
}

// The pixels of the data window as floats.
Image ReadDataWindow(Imf::MultiPartInputFile& file, int part, const ColorChannels& channels,
                     const Source& source) {
  const Imf::Header& header = file.header(part);
  const Box2i& window = header.dataWindow();
  Image image{int(WidthOf(window)), int(HeightOf(window))};

  Imf::FrameBuffer buffer;
  const int colors = channels.coding == Coding::Gray ? 1 : 3;
  for (int i = 0; i < colors; ++i)
    buffer.insert(channels.names[std::size_t(i)],
                  FloatSlice(&image.pixels[0][i], sizeof(vec3), window));
  if (!channels.alpha.empty()) {
    image.alpha.resize(image.pixels.size());
    image.premultiplied = true;
    buffer.insert(channels.alpha, FloatSlice(image.alpha.data(), sizeof(float), window));
  }
  for (auto it = buffer.begin(); it != buffer.end(); ++it) {
    const Imf::Channel* channel = header.channels().findChannel(it.name());
    if (channel && (channel->xSampling != 1 || channel->ySampling != 1))
      throw source.Fault("EXR pictures with subsampled colour cannot be read");
  }

  if (header.hasTileDescription()) {
    Imf::TiledInputPart tiles(file, part);
    tiles.setFrameBuffer(buffer);
    tiles.readTiles(0, tiles.numXTiles(0) - 1, 0, tiles.numYTiles(0) - 1, 0, 0);
  } else {
    Imf::InputPart lines(file, part);
    lines.setFrameBuffer(buffer);
    lines.readPixels(window.min.y, window.max.y);
  }
  if (channels.coding == Coding::Gray)
    for (vec3& pixel : image.pixels) pixel = vec3(pixel.x);
  return image;
}

// The same for luminance with subsampled chroma, which the library turns to RGB.
Image ReadLuminanceChroma(const Imf::Header& header, const ColorChannels& channels,
                          const Source& source) {
  // The library throws this too, but then loses its memory
  if (Imf::hasChromaticities(header)) Imf::RGBtoXYZ(Imf::chromaticities(header), 1);

  MemoryStream stream(source);
  Imf::RgbaInputFile file(stream, 0);
  const Box2i window = file.dataWindow();
  Image image{int(WidthOf(window)), int(HeightOf(window))};

  std::vector<Imf::Rgba> pixels(image.pixels.size());
  file.setFrameBuffer(Imf::ComputeBasePointer(pixels.data(), window), 1, std::size_t(image.width));
  file.readPixels(window.min.y, window.max.y);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    image.pixels[i] = vec3(float(pixels[i].r), float(pixels[i].g), float(pixels[i].b));
  if (!channels.alpha.empty()) {
    image.premultiplied = true;
    for (const Imf::Rgba& pixel : pixels) image.alpha.push_back(float(pixel.a));
  }
  return image;
}

// Place the data window in the display window; what it does not cover is black and transparent.
Image Framed(Image data, const Box2i& dataWindow, const Box2i& displayWindow) {
  if (dataWindow == displayWindow) return data;
  Image image{int(WidthOf(displayWindow)), int(HeightOf(displayWindow))};
  image.premultiplied = data.premultiplied;
  if (data.HasAlpha()) image.alpha.resize(image.pixels.size());

  const int left = std::max(dataWindow.min.x, displayWindow.min.x);
  const int right = std::min(dataWindow.max.x, displayWindow.max.x);
  const int top = std::max(dataWindow.min.y, displayWindow.min.y);
  const int bottom = std::min(dataWindow.max.y, displayWindow.max.y);
  if (left > right) return image;
  const std::size_t count = std::size_t(right - left) + 1;
  for (int y = top; y <= bottom; ++y) {
    const std::size_t from = data.Index(left - dataWindow.min.x, y - dataWindow.min.y);
    const std::size_t to = image.Index(left - displayWindow.min.x, y - displayWindow.min.y);
    std::copy_n(&data.pixels[from], count, &image.pixels[to]);
    if (data.HasAlpha()) std::copy_n(&data.alpha[from], count, &image.alpha[to]);
  }
  return image;
}

void CollectText(const Imf::Header& header, Metadata& metadata) {
  for (auto it = header.begin(); it != header.end(); ++it) {
    const std::string name = it.name();
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
    if (text && name != "name" && name != "type" && name != "view")
      metadata.emplace_back(name, text->value());
  }
}

// What the library says, without the file's name, which our message has already, on one line.
std::string Reason(const std::exception& fault) {
  std::string reason = fault.what();
  const std::size_t afterName = reason.find("\". ");
  if (afterName != reason.npos) reason.erase(0, afterName + 3);
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' '; };
  std::replace_if(reason.begin(), reason.end(), isControl, ' ');
  return reason;
}

Image Decode(const Source& source) {
  CheckExrHeaders(source);
  MemoryStream stream(source);
  Imf::MultiPartInputFile file(stream, 0, false);
  ColorChannels channels;
  const int part = FindPart(file, source, channels);
  const Imf::Header& header = file.header(part);
  CheckPart(header, channels, source);
  if (channels.coding == Coding::LuminanceChroma && part != 0)
    throw source.Fault("multi-part luminance/chroma EXR pictures cannot be read");

  Image data = channels.coding == Coding::LuminanceChroma
                   ? ReadLuminanceChroma(header, channels, source)
                   : ReadDataWindow(file, part, channels, source);
  if (source.options.colorSpace != ColorSpace::Raw && Imf::hasChromaticities(header)) {
    const Imf::Chromaticities& c = Imf::chromaticities(header);
    const auto xy = [](const Imath::V2f& v) { return glm::dvec2(v.x, v.y); };
    if (channels.coding != Coding::Gray)
      ConvertToRec709({xy(c.red), xy(c.green), xy(c.blue), xy(c.white)}, data.pixels);
  }
  CollectText(header, *source.metadata);
  return Framed(std::move(data), header.dataWindow(), header.displayWindow());
}

// Run a function of the library; what it throws becomes an Error about the file.
template <class Function>
auto Guarded(const Source& source, Function function) {
  try {
    return function();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& fault) {
    throw source.Fault("the EXR cannot be decoded: " + Reason(fault));
  }
}

}  // namespace

Image DecodeExr(const Source& source) {
  return Guarded(source, [&] { return Decode(source); });
}

ExrSummary SummarizeExr(const std::filesystem::path& path) {
  const std::string bytes = ReadFile(path);
  Metadata ignored;
  const Source source{bytes, path.string(), {}, &ignored};
  return Guarded(source, [&] {
    CheckExrHeaders(source);
    MemoryStream stream(source);
    const Imf::MultiPartInputFile file(stream, 0, false);
    const Imf::Header& header = file.header(0);
    const Box2i& window = header.displayWindow();
    source.CheckSize(WidthOf(window), HeightOf(window));
    ExrSummary summary{int(WidthOf(window)), int(HeightOf(window)), {}};
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
      const Imf::PixelType type = it.channel().type;
      summary.channels.emplace_back(Printable(it.name()), type == Imf::HALF    ? "half"
                                                          : type == Imf::FLOAT ? "float"
                                                                               : "uint");
    }
    return summary;
  });
}

}  // namespace snell::image
