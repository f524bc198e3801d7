// SPDX-License-Identifier: Apache-2.0
//
// Pictures to OpenEXR by the reference library: scan lines, ZIP compression, half or float, linear
// Rec.709 with its chromaticities, alpha premultiplied, metadata as string attributes.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <type_traits>
#include <vector>

#include "image/codec.h"

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

// All samples of the picture, channels interleaved in the order R, G, B, A.
template <typename Sample>
std::vector<Sample> Samples(const Image& image) {
  const auto convert = [](float value) {
    if constexpr (std::is_same_v<Sample, float>)
      return value;
    else
      return ToHalf(value);
  };
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

template <typename Sample>
void Write(Imf::OStream& stream, Imf::Header& header, Imf::PixelType type, const Image& image) {
  const std::vector<Sample> samples = Samples<Sample>(image);
  const std::size_t channels = image.HasAlpha() ? 4 : 3;
  const std::size_t stride = channels * sizeof(Sample);

  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < channels; ++i) {
    const std::string name(1, "RGBA"[i]);
    header.channels().insert(name, Imf::Channel(type));
    buffer.insert(name, Imf::Slice::Make(type, samples.data() + i, header.dataWindow(), stride,
                                         stride * std::size_t(image.width)));
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

    StringStream stream(bytes, place);
    if (options.exrFloat)
      Write<float>(stream, header, Imf::FLOAT, image);
    else
      Write<Imath::half>(stream, header, Imf::HALF, image);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& fault) {
    throw Error(std::string("cannot encode the EXR: ") + fault.what(), place);
  }
  return bytes;
}

}  // namespace snell::image
