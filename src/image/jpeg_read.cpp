// SPDX-License-Identifier: Apache-2.0
//
// JPEG to pictures by libjpeg-turbo: baseline and progressive; grey, YCbCr, RGB, CMYK and YCCK (ITU-T
// T.81, T.872 for Adobe's marker); Exif orientation; comments. Damaged data are an error: a texture with
// a grey lower half is no texture.
#include <array>
#include <utility>
#include <vector>

#include "image/codec.h"
#include "image/color.h"
#include "image/jpeg_guard.h"
#include "image/metadata.h"
#include "image/orientation.h"

namespace snell::image {

namespace {

// A progressive file may hold any number of scans, each of which costs a pass over the whole picture for
// a few bytes. Real files have about ten.
constexpr int MostScans = 500;
constexpr std::uint64_t MostScannedPixels = std::uint64_t(1) << 34;

void LimitScans(j_common_ptr common) {
  auto* jpeg = reinterpret_cast<j_decompress_ptr>(common);
  const std::uint64_t pixels = std::uint64_t(jpeg->image_width) * jpeg->image_height;
  const int scans = jpeg->input_scan_number;
  if (scans > MostScans || std::uint64_t(scans) * pixels > MostScannedPixels) {
    std::snprintf(reinterpret_cast<JpegErrors*>(jpeg->err)->text, JMSG_LENGTH_MAX,
                  "it has too many scans");
    std::longjmp(reinterpret_cast<JpegErrors*>(jpeg->err)->landing, 1);
  }
}

// libjpeg's decompressor and the source that it reads.
class JpegReader {
 public:
  explicit JpegReader(const Source& source) : source_(source) {
    jpeg.err = Install(errors_);
    progress_.progress_monitor = LimitScans;
    Run([&] {
      jpeg_create_decompress(&jpeg);
      jpeg.progress = &progress_;
      jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(source.bytes.data()),
                   static_cast<unsigned long>(source.bytes.size()));
    });
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  // Run a step, and turn libjpeg's error into ours.
  template <typename Step>
  void Run(const Step& step) {
    if (JpegSucceeds(errors_, step)) return;
    const std::size_t left = jpeg.src ? jpeg.src->bytes_in_buffer : source_.bytes.size();
    const std::size_t position = left <= source_.bytes.size() ? source_.bytes.size() - left : 0;
    throw source_.Fault(std::string("the JPEG cannot be decoded: ") + errors_.text,
                        std::int64_t(position));
  }

  jpeg_decompress_struct jpeg = {};

 private:
  const Source& source_;
  JpegErrors errors_;
  jpeg_progress_mgr progress_ = {};
};

// Every 8×8 block of every component costs at least one bit, unless arithmetic coding is used.
std::uint64_t FewestBytes(const jpeg_decompress_struct& jpeg) {
  if (jpeg.arith_code) return 0;
  std::uint64_t blocks = 0;
  for (int i = 0; i < jpeg.num_components; ++i)
    blocks += std::uint64_t(jpeg.comp_info[i].width_in_blocks) * jpeg.comp_info[i].height_in_blocks;
  return blocks / 8;
}

struct RowConverter {
  std::array<float, 256> table;
  bool decodesSrgb;
  int channels;
  bool invertedInk;  // CMYK as Adobe writes it: 255 is no ink

  void operator()(const JSAMPLE* row, int y, Image& image) const {
    vec3* to = &image.At(0, y);
    for (int x = 0; x < image.width; ++x, row += channels)
      to[x] = channels == 1   ? vec3(table[row[0]])
              : channels == 3 ? vec3(table[row[0]], table[row[1]], table[row[2]])
                              : FromInk(row);
  }

  // Each ink lets through what the black ink leaves.
  vec3 FromInk(const JSAMPLE* cmyk) const {
    const auto light = [&](int ink) {
      return float(invertedInk ? cmyk[ink] : 255 - cmyk[ink]) / 255.0f;
    };
    const vec3 encoded = vec3(light(0), light(1), light(2)) * light(3);
    return decodesSrgb ? DecodeSrgb(encoded) : encoded;
  }
};

RowConverter MakeConverter(const jpeg_decompress_struct& jpeg, ColorSpace colorSpace) {
  RowConverter converter = {};
  converter.decodesSrgb = colorSpace != ColorSpace::Raw;
  converter.channels = jpeg.output_components;
  converter.invertedInk = jpeg.saw_Adobe_marker;
  for (std::size_t i = 0; i < 256; ++i) {
    const float value = float(i) / 255.0f;
    converter.table[i] = converter.decodesSrgb ? DecodeSrgb(value) : value;
  }
  return converter;
}

// Read the markers that were kept: comments into `metadata`, Exif for the orientation.
Orientation ReadMarkers(const jpeg_decompress_struct& jpeg, Metadata& metadata) {
  using std::string_view_literals::operator""sv;
  constexpr std::string_view ExifName = "Exif\0\0"sv;
  Orientation orientation;
  for (jpeg_saved_marker_ptr marker = jpeg.marker_list; marker; marker = marker->next) {
    const std::string_view body(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (marker->marker == JPEG_COM)
      AddMetadataLine(body, metadata);
    else if (body.starts_with(ExifName))
      orientation = ExifOrientation(body.substr(ExifName.size()));
  }
  return orientation;
}

}  // namespace

Image DecodeJpeg(const Source& source) {
  JpegReader reader(source);
  jpeg_decompress_struct& jpeg = reader.jpeg;

  // Read what stands before the pixels
  reader.Run([&] {
    jpeg_save_markers(&jpeg, JPEG_COM, 0xffff);
    jpeg_save_markers(&jpeg, JPEG_APP0 + 1, 0xffff);
    jpeg_read_header(&jpeg, TRUE);
  });
  source.CheckSize(jpeg.image_width, jpeg.image_height);
  source.CheckPlausible(FewestBytes(jpeg), 1);

  // Grey, RGB and CMYK are what libjpeg can make of its colour spaces
  reader.Run([&] {
    const bool ink = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
    const bool gray = jpeg.jpeg_color_space == JCS_GRAYSCALE;
    jpeg.out_color_space = ink ? JCS_CMYK : gray ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_start_decompress(&jpeg);
  });

  const Orientation orientation = ReadMarkers(jpeg, *source.metadata);
  Image image{int(jpeg.output_width), int(jpeg.output_height)};
  const RowConverter convert = MakeConverter(jpeg, source.options.colorSpace);
  std::vector<JSAMPLE> row(std::size_t(jpeg.output_width) * std::size_t(jpeg.output_components));
  reader.Run([&] {
    while (jpeg.output_scanline < jpeg.output_height) {
      JSAMPLE* rows[] = {row.data()};
      const int y = int(jpeg.output_scanline);
      if (jpeg_read_scanlines(&jpeg, rows, 1) == 1) convert(row.data(), y, image);
    }
    jpeg_finish_decompress(&jpeg);
  });
  return Upright(std::move(image), orientation);
}

}  // namespace snell::image
