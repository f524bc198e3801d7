// SPDX-License-Identifier: Apache-2.0
//
// Pictures to PNG by libpng: RGB or RGBA, 8 or 16 bits, marked as sRGB, text as tEXt where it is ASCII
// and as iTXt where it is not (PNG Specification, 2nd edition, ISO/IEC 15948:2003).
#include <png.h>

#include <algorithm>
#include <new>
#include <vector>

#include "image/codec.h"
#include "image/color.h"
#include "image/png_guard.h"

namespace snell::image {

namespace {

bool Append(std::string& to, const void* bytes, std::size_t count) {
  try {
    to.append(static_cast<const char*>(bytes), count);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void WriteBytes(png_structp png, png_bytep from, std::size_t count) {
  if (!Append(*static_cast<std::string*>(png_get_io_ptr(png)), from, count))
    png_error(png, "not enough memory");
}

void FlushNothing(png_structp) {}

// libpng's writing structures and the bytes that they fill.
class PngWriter {
 public:
  explicit PngWriter(const Place& place) : place_(place) {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message_, OnPngError, OnPngWarning);
    if (png) info = png_create_info_struct(png);
    if (!info) {
      png_destroy_write_struct(&png, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png, &bytes, WriteBytes, FlushNothing);
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  template <typename Step>
  void Run(const Step& step) {
    if (!PngSucceeds(png, step))
      throw Error(std::string("cannot encode the PNG: ") + message_.text, place_);
  }

  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string bytes;

 private:
  const Place& place_;
  PngMessage message_;
};

// Entries for libpng; they point into `metadata`.
std::vector<png_text> TextEntries(const Metadata& metadata) {
  static char empty[] = "";
  std::vector<png_text> entries;
  for (const auto& [key, value] : metadata) {
    const bool ascii = std::none_of(value.begin(), value.end(), [](char c) { return c & 0x80; });
    png_text entry = {};
    entry.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(key.c_str());
    entry.text = const_cast<char*>(value.c_str());
    entry.text_length = ascii ? value.size() : 0;
    entry.itxt_length = ascii ? 0 : value.size();
    entry.lang = empty;
    entry.lang_key = empty;
    entries.push_back(entry);
  }
  return entries;
}

png_byte* PutSample(png_byte* to, float value, int bits) {
  if (bits == 8) {
    *to++ = Quantize8(value);
  } else {
    const std::uint16_t code = Quantize16(value);
    *to++ = png_byte(code >> 8);
    *to++ = png_byte(code & 0xff);
  }
  return to;
}

void ConvertRow(const Image& image, int y, const WriteOptions& options, png_byte* to) {
  for (int x = 0; x < image.width; ++x) {
    const std::size_t index = image.Index(x, y);
    const vec3 color = DisplayColor(image.Straight(index), options);
    to = PutSample(to, color.x, options.bits);
    to = PutSample(to, color.y, options.bits);
    to = PutSample(to, color.z, options.bits);
    if (image.HasAlpha()) to = PutSample(to, image.alpha[index], options.bits);
  }
}

}  // namespace

std::string EncodePng(const Image& image, const WriteOptions& options, const Place& place) {
  PngWriter writer(place);
  const png_structp png = writer.png;
  const png_infop info = writer.info;
  const std::vector<png_text> text = TextEntries(options.metadata);
  const std::size_t samples = image.HasAlpha() ? 4 : 3;
  std::vector<png_byte> row(std::size_t(image.width) * samples * std::size_t(options.bits / 8));

  writer.Run([&] {
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png, info, png_uint_32(image.width), png_uint_32(image.height), options.bits,
                 image.HasAlpha() ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (!text.empty()) png_set_text(png, info, text.data(), int(text.size()));
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y) {
      ConvertRow(image, y, options, row.data());
      png_write_row(png, row.data());
    }
    png_write_end(png, info);
  });
  return std::move(writer.bytes);
}

}  // namespace snell::image
