// SPDX-License-Identifier: Apache-2.0
//
// Pictures to OpenEXR by the reference library: scan lines, ZIP compression, half or float, linear
// Rec.709 with its chromaticities, alpha premultiplied, metadata as string attributes; further layers as
// channels with their names before a point.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <new>
#include <type_traits>
#include <vector>

#include "image/codec.h"
#include "util/check.h"

namespace snell::image {

namespace {

// Writes into a string, at any position up to its end.
class StringStream : public Imf::OStream {
 public:
  StringStream(std::string& bytes, const Place& place)
      : Imf::OStream(place.file.c_str()), bytes_(bytes) {}

  void write(const char from[], int count) override {
    if (position_ > bytes_.size()) bytes_.resize(position_);
    const std::size_t replaced = std::min(std::size_t(count), bytes_.size() - position_);
    bytes_.replace(position_, replaced, from, std::size_t(count));
    position_ += std::size_t(count);
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

 private:
  std::string& bytes_;
  std::size_t position_ = 0;
};

// Half ends at 65504; beyond, infinity would be stored.
Imath::half ToHalf(float value) {
  return Imath::half(std::isnan(value) ? value : std::clamp(value, -65504.0f, 65504.0f));
}

template <typename Sample>
Sample Converted(float value) {
  if constexpr (std::is_same_v<Sample, float>)
    return value;
  else
    return ToHalf(value);
}

// All samples of the picture, channels interleaved in the order R, G, B, A.
template <typename Sample>
std::vector<Sample> Samples(const Image& image) {
  const auto convert = Converted<Sample>;
  std::vector<Sample> samples;
  samples.reserve(image.pixels.size() * (image.HasAlpha() ? 4 : 3));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const vec3 color = image.Premultiplied(i);
    samples.push_back(convert(color.x));
    samples.push_back(convert(color.y));
    samples.push_back(convert(color.z));
    if (image.HasAlpha()) samples.push_back(convert(image.alpha[i]));
  }
  return samples;
}

// Name interleaved channels in the header and in the buffer that is written from.
template <typename Sample>
void Insert(const std::vector<std::string>& names, const Sample* samples, Imf::Header& header,
            Imf::FrameBuffer& buffer) {
  const Imf::PixelType type = std::is_same_v<Sample, float> ? Imf::FLOAT : Imf::HALF;
  const Imath::Box2i& window = header.dataWindow();
  const std::size_t stride = names.size() * sizeof(Sample);
  const std::size_t width = std::size_t(window.max.x - window.min.x) + 1;
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.channels().insert(names[i], Imf::Channel(type));
    buffer.insert(names[i], Imf::Slice::Make(type, samples + i, window, stride, stride * width));
  }
}

template <typename Sample>
void Write(Imf::OStream& stream, Imf::Header& header, const Image& image, const Layers& layers) {
  Imf::FrameBuffer buffer;
  std::vector<std::string> names = {"R", "G", "B"};
  if (image.HasAlpha()) names.emplace_back("A");
  const std::vector<Sample> samples = Samples<Sample>(image);
  Insert(names, samples.data(), header, buffer);

  // Further layers: colours like the picture's own, all else in full
  std::list<std::vector<Sample>> colors;
  for (const Layer& layer : layers.layers) {
    names.clear();
    for (const std::string& channel : layer.channels) names.push_back(layer.name + "." + channel);
    CHECK(layer.values.size() == image.pixels.size() * names.size());
    if (!layer.isColor) {
      Insert(names, layer.values.data(), header, buffer);
      continue;
    }
    std::vector<Sample>& converted = colors.emplace_back();
    converted.reserve(layer.values.size());
    for (const float value : layer.values) converted.push_back(Converted<Sample>(value));
    Insert(names, converted.data(), header, buffer);
  }
  Imf::OutputFile file(stream, header, 0);
  file.setFrameBuffer(buffer);
  file.writePixels(image.height);
}

}  // namespace

std::string EncodeExr(const Image& image, const WriteOptions& options, const Place& place) {
  std::string bytes;
  try {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities());
    for (const auto& [key, value] : options.metadata)
      header.insert(key, Imf::StringAttribute(value));

    static const Layers none;
    const Layers& layers = options.layers ? *options.layers : none;
    for (const auto& [key, value] : layers.metadata)
      header.insert(key, Imf::StringAttribute(value));

    StringStream stream(bytes, place);
    if (options.exrFloat)
      Write<float>(stream, header, image, layers);
    else
      Write<Imath::half>(stream, header, image, layers);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& fault) {
    throw Error(std::string("cannot encode the EXR: ") + fault.what(), place);
  }
  return bytes;
}

}  // namespace snell::image
