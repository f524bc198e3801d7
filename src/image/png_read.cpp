// SPDX-License-Identifier: Apache-2.0
//
// PNG to pictures by libpng: every colour type and bit depth, tRNS transparency, interlacing, gAMA, text
// and Exif orientation (PNG Specification, 2nd edition, ISO/IEC 15948:2003; extensions 1.5.0).
#include <png.h>

#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "image/codec.h"
#include "image/color.h"
#include "image/orientation.h"
#include "image/png_guard.h"

namespace snell::image {

namespace {

// Deflate packs no more than 1032 bytes into one; a little is added for safety.
constexpr std::uint64_t BestCompression = 1040;

struct Input {
  std::string_view bytes;
  std::size_t position = 0;
};

void ReadBytes(png_structp png, png_bytep to, std::size_t count) {
  Input& input = *static_cast<Input*>(png_get_io_ptr(png));
  if (count > input.bytes.size() - input.position) png_error(png, "the file ends early");
  std::memcpy(to, input.bytes.data() + input.position, count);
  input.position += count;
}

// Throw unless every chunk up to IEND lies within the file: libpng takes memory for some before it looks.
void CheckChunks(const Source& source) {
  const auto byte = [&](std::size_t i) { return std::uint32_t(std::uint8_t(source.bytes[i])); };
  std::size_t position = 8;
  std::string_view type;
  while (type != "IEND") {
    const std::size_t left = source.bytes.size() - position;
    if (left < 12) throw source.Fault("the PNG ends early", std::int64_t(source.bytes.size()));
    const std::uint32_t length = byte(position) << 24 | byte(position + 1) << 16 |
                                 byte(position + 2) << 8 | byte(position + 3);
    if (length > left - 12)
      throw source.Fault("the PNG ends early or is damaged: a chunk reaches beyond its end",
                         std::int64_t(position));
    type = source.bytes.substr(position + 4, 4);
    position += 12 + length;
  }
}

// libpng's reading structures and the source that they read.
class PngReader {
 public:
  explicit PngReader(const Source& source) : source_(source), input_{source.bytes} {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, OnPngError, OnPngWarning);
    if (png) info = png_create_info_struct(png);
    if (!info) {
      png_destroy_read_struct(&png, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png, &input_, ReadBytes);
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  // Run a step, and turn libpng's error into ours.
  template <typename Step>
  void Run(const Step& step) {
    if (!PngSucceeds(png, step))
      throw source_.Fault(std::string("the PNG is damaged: ") + message_.text,
                          std::int64_t(input_.position));
  }

  png_structp png = nullptr;
  png_infop info = nullptr;

 private:
  const Source& source_;
  Input input_;
  PngMessage message_;
};

// The power that takes the file's numbers to light: 1 for none, 0 for the sRGB function.
double Gamma(const PngReader& reader, ColorSpace colorSpace) {
  if (colorSpace == ColorSpace::Raw) return 1;
  const bool statesSpace = png_get_valid(reader.png, reader.info, PNG_INFO_sRGB) ||
                           png_get_valid(reader.png, reader.info, PNG_INFO_iCCP);
  double encoding = 0;
  if (colorSpace == ColorSpace::Srgb || statesSpace ||
      !png_get_gAMA(reader.png, reader.info, &encoding) || !(encoding > 0))
    return 0;
  const bool meansSrgb = std::fabs(encoding - 0.45455) < 0.02;
  return meansSrgb ? 0 : 1 / encoding;
}

// What each code of 8 or 16 bits stands for.
std::vector<float> DecodingTable(int bits, double gamma) {
  std::vector<float> table(std::size_t(1) << bits);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = double(i) / double(table.size() - 1);
    table[i] = gamma == 0 ? DecodeSrgb(float(value)) : float(std::pow(value, gamma));
  }
  return table;
}

// How the rows that libpng delivers are laid out.
struct Layout {
  int bits;      // 8 or 16, most significant byte first
  int channels;  // 1: grey, 2: grey and alpha, 3: RGB, 4: RGB and alpha
};

void ConvertRow(const png_byte* row, const Layout& layout, const std::vector<float>& table, int y,
                Image& image) {
  const auto code = [&](std::size_t i) -> std::size_t {
    return layout.bits == 8 ? row[i] : std::size_t(row[2 * i] << 8 | row[2 * i + 1]);
  };
  const float alphaScale = 1.0f / float(table.size() - 1);
  const std::size_t first = image.Index(0, y), channels = std::size_t(layout.channels);
  for (std::size_t x = 0; x < std::size_t(image.width); ++x) {
    const std::size_t at = x * channels;
    vec3& pixel = image.pixels[first + x];
    if (channels >= 3)
      pixel = vec3(table[code(at)], table[code(at + 1)], table[code(at + 2)]);
    else
      pixel = vec3(table[code(at)]);
    if (image.HasAlpha()) image.alpha[first + x] = float(code(at + channels - 1)) * alphaScale;
  }
}

std::string Latin1ToUtf8(const char* text) {
  std::string utf8;
  for (; *text; ++text) {
    const auto c = static_cast<unsigned char>(*text);
    if (c >= 0x80) utf8 += char(0xc0 | c >> 6);
    utf8 += c >= 0x80 ? char(0x80 | (c & 0x3f)) : char(c);
  }
  return utf8;
}

void CollectText(const PngReader& reader, Metadata& metadata) {
  png_textp entries = nullptr;
  int count = 0;
  png_get_text(reader.png, reader.info, &entries, &count);
  for (int i = 0; i < count; ++i) {
    if (!entries[i].text || !entries[i].key || !*entries[i].key) continue;
    const bool utf8 = entries[i].compression >= PNG_ITXT_COMPRESSION_NONE;
    metadata.emplace_back(Latin1ToUtf8(entries[i].key),
                          utf8 ? entries[i].text : Latin1ToUtf8(entries[i].text));
  }
}

Orientation OrientationOf(const PngReader& reader) {
  png_uint_32 size = 0;
  png_bytep exif = nullptr;
  if (!png_get_eXIf_1(reader.png, reader.info, &size, &exif) || !exif) return {};
  return ExifOrientation({reinterpret_cast<const char*>(exif), size});
}

}  // namespace

Image DecodePng(const Source& source) {
  CheckChunks(source);
  PngReader reader(source);
  const png_structp png = reader.png;
  const png_infop info = reader.info;

  // Read what stands before the pixels; we check sizes ourselves, libpng bounds side data
  reader.Run([&] {
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_chunk_cache_max(png, 256);
    png_set_chunk_malloc_max(png, 4u << 20);
    png_read_info(png, info);
  });
  const png_uint_32 width = png_get_image_width(png, info);
  const png_uint_32 height = png_get_image_height(png, info);
  source.CheckSize(width, height);
  source.CheckPlausible(std::uint64_t(png_get_rowbytes(png, info)) * height, BestCompression);

  // Have palettes, transparent colours and small bit depths expanded
  int passes = 1;
  reader.Run([&] {
    png_set_expand(png);
    passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
  });
  const Layout layout{png_get_bit_depth(png, info), png_get_channels(png, info)};
  const std::size_t rowBytes = png_get_rowbytes(png, info);

  Image image{int(width), int(height)};
  if (layout.channels % 2 == 0) image.alpha.resize(image.pixels.size());
  const std::vector<float> table =
      DecodingTable(layout.bits, Gamma(reader, source.options.colorSpace));

  // Convert rows as they come; an interlaced picture needs all its rows until the last pass
  const std::size_t keptRows = passes > 1 ? height : 1;
  std::vector<png_byte> rows(rowBytes * keptRows);
  reader.Run([&] {
    for (int pass = 0; pass < passes; ++pass) {
      for (int y = 0; y < image.height; ++y) {
        png_byte* row = rows.data() + rowBytes * (passes > 1 ? std::size_t(y) : 0);
        png_read_row(png, row, nullptr);
        if (pass == passes - 1) ConvertRow(row, layout, table, y, image);
      }
    }
    png_read_end(png, info);
  });

  CollectText(reader, *source.metadata);
  return Upright(std::move(image), OrientationOf(reader));
}

}  // namespace snell::image
