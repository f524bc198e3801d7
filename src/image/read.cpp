// SPDX-License-Identifier: Apache-2.0
#include "image/read.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>

#include "image/codec.h"

namespace snell::image {

namespace {

using Decoder = Image (*)(const Source&);

// The bytes that a kind of file begins with, at an offset. Kinds without a decoder are those that people
// try, so that the message can name them.
struct Signature {
  std::size_t offset;
  std::string_view bytes;
  const char* kind;
  Decoder decode;
};

using std::string_view_literals::operator""sv;

constexpr Signature Signatures[] = {
    {0, "\x89PNG\r\n\x1a\n"sv, "PNG", DecodePng},
    {0, "\xff\xd8\xff"sv, "JPEG", DecodeJpeg},
    {0, "\x76\x2f\x31\x01"sv, "OpenEXR", DecodeExr},
    {0, "#?"sv, "Radiance HDR", DecodeHdr},
    {8, "WEBP"sv, "WebP", DecodeWebp},
    {0, "GIF8"sv, "GIF", nullptr},
    {0, "II*\0"sv, "TIFF", nullptr},
    {0, "MM\0*"sv, "TIFF", nullptr},
    {0, "\xabKTX"sv, "KTX", nullptr},
    {0, "DDS "sv, "DDS", nullptr},
    {0, "qoif"sv, "QOI", nullptr},
    {0, "8BPS"sv, "Photoshop", nullptr},
    {4, "ftypavif"sv, "AVIF", nullptr},
    {4, "ftypheic"sv, "HEIC", nullptr},
    {0, "\0\0\0\x0cjP  "sv, "JPEG 2000", nullptr},
    {0, "\0\0\0\x0cJXL "sv, "JPEG XL", nullptr},
    {0, "\xff\x0a"sv, "JPEG XL", nullptr},
    {0, "PF\n"sv, "PFM", nullptr},
    {0, "P6"sv, "PPM", nullptr},
    {0, "BM"sv, "BMP", nullptr},
};

constexpr const char* Readable = "Snell reads PNG, JPEG, WebP, OpenEXR and Radiance HDR pictures";

Decoder DecoderFor(const Source& source) {
  if (source.bytes.empty()) throw source.Fault("the file is empty");
  for (const Signature& signature : Signatures) {
    if (source.bytes.size() < signature.offset) continue;
    if (!source.bytes.substr(signature.offset).starts_with(signature.bytes)) continue;
    if (signature.decode) return signature.decode;
    throw source.Fault(fmt::format("{} pictures cannot be read", signature.kind), -1, Readable);
  }
  throw source.Fault("not a known picture format", -1, Readable);
}

}  // namespace

Image DecodeImage(std::string_view bytes, const std::string& name, const ReadOptions& options,
                  Metadata* metadata) {
  Metadata ignored;
  const Source source{bytes, name, options, metadata ? metadata : &ignored};
  if (bytes.size() > options.limits.fileBytes)
    throw source.Fault(fmt::format("the file has {} bytes; the limit is {}", bytes.size(),
                                   options.limits.fileBytes));
  try {
    source.metadata->clear();
    return DecoderFor(source)(source);
  } catch (const std::bad_alloc&) {
    throw source.Fault("there is not enough memory for the picture");
  } catch (const std::length_error&) {
    throw source.Fault("there is not enough memory for the picture");
  }
}

Image ReadImage(const std::filesystem::path& path, const ReadOptions& options, Metadata* metadata) {
  return DecodeImage(ReadFile(path, options.limits.fileBytes), path.string(), options, metadata);
}

}  // namespace snell::image
