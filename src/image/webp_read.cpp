// SPDX-License-Identifier: Apache-2.0
//
// WebP to pictures by libwebp: lossy and lossless, with and without alpha (RFC 9649). Of animations, none;
// metadata is not read.
#include <webp/decode.h>

#include <array>
#include <memory>

#include "image/codec.h"
#include "image/color.h"

namespace snell::image {

static const char* Reason(VP8StatusCode status) {
  switch (status) {
    case VP8_STATUS_NOT_ENOUGH_DATA: return "the WebP ends early";
    case VP8_STATUS_UNSUPPORTED_FEATURE: return "the WebP has a feature that libwebp does not know";
    default: return "the WebP is damaged";
  }
}

// What each code of 8 bits stands for.
static std::array<float, 256> DecodingTable(ColorSpace colorSpace) {
  std::array<float, 256> table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const float value = float(i) / 255.0f;
    table[i] = colorSpace == ColorSpace::Raw ? value : DecodeSrgb(value);
  }
  return table;
}

Image DecodeWebp(const Source& source) {
  // Read what stands before the pixels
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(source.bytes.data());
  WebPDecoderConfig config;
  if (!WebPInitDecoderConfig(&config)) throw source.Fault("libwebp is of another version");
  const VP8StatusCode features = WebPGetFeatures(bytes, source.bytes.size(), &config.input);
  if (features != VP8_STATUS_OK) throw source.Fault(Reason(features));
  if (config.input.has_animation) throw source.Fault("animated WebP pictures cannot be read");
  source.CheckSize(config.input.width, config.input.height);

  // Decode, four bytes a pixel
  config.output.colorspace = MODE_RGBA;
  const std::unique_ptr<WebPDecBuffer, decltype(&WebPFreeDecBuffer)> guard(&config.output,
                                                                           WebPFreeDecBuffer);
  const VP8StatusCode status = WebPDecode(bytes, source.bytes.size(), &config);
  if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status != VP8_STATUS_OK) throw source.Fault(Reason(status));

  Image image{config.output.width, config.output.height};
  if (config.input.has_alpha) image.alpha.resize(image.pixels.size());
  const std::array<float, 256> table = DecodingTable(source.options.colorSpace);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* row =
        config.output.u.RGBA.rgba + std::ptrdiff_t(y) * config.output.u.RGBA.stride;
    for (int x = 0; x < image.width; ++x, row += 4) {
      image.At(x, y) = vec3(table[row[0]], table[row[1]], table[row[2]]);
      if (image.HasAlpha()) image.alpha[image.Index(x, y)] = float(row[3]) / 255.0f;
    }
  }
  return image;
}

}  // namespace snell::image
