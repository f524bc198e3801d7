// SPDX-License-Identifier: Apache-2.0
//
// Pictures to JPEG by libjpeg-turbo: baseline with optimal Huffman codes, JFIF, sRGB. Metadata become
// comments, one marker each.
#include <fmt/format.h>

#include <array>
#include <vector>

#include "image/codec.h"
#include "image/color.h"
#include "image/jpeg_guard.h"
#include "image/metadata.h"

namespace snell::image {

namespace {

constexpr std::size_t LongestComment = 65533;

// Collects what libjpeg writes in a string. `manager` must come first so that its pointer leads back.
struct StringTarget {
  jpeg_destination_mgr manager = {};
  std::array<JOCTET, 16384> block;
  std::string bytes;

  void Rewind() {
    manager.next_output_byte = block.data();
    manager.free_in_buffer = block.size();
  }
  bool Append(std::size_t count) {
    try {
      bytes.append(reinterpret_cast<const char*>(block.data()), count);
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }
};

StringTarget& TargetOf(j_compress_ptr jpeg) { return *reinterpret_cast<StringTarget*>(jpeg->dest); }

void OnStart(j_compress_ptr jpeg) { TargetOf(jpeg).Rewind(); }

boolean OnFull(j_compress_ptr jpeg) {
  StringTarget& target = TargetOf(jpeg);
  if (!target.Append(target.block.size())) ERREXIT1(jpeg, JERR_OUT_OF_MEMORY, 0);
  target.Rewind();
  return TRUE;
}

void OnEnd(j_compress_ptr jpeg) {
  StringTarget& target = TargetOf(jpeg);
  if (!target.Append(target.block.size() - target.manager.free_in_buffer))
    ERREXIT1(jpeg, JERR_OUT_OF_MEMORY, 0);
}

// libjpeg's compressor and the bytes that it fills.
class JpegWriter {
 public:
  explicit JpegWriter(const Place& place) : place_(place) {
    jpeg.err = Install(errors_);
    target.manager.init_destination = OnStart;
    target.manager.empty_output_buffer = OnFull;
    target.manager.term_destination = OnEnd;
    Run([&] {
      jpeg_create_compress(&jpeg);
      jpeg.dest = &target.manager;
    });
  }
  ~JpegWriter() { jpeg_destroy_compress(&jpeg); }
  JpegWriter(const JpegWriter&) = delete;
  JpegWriter& operator=(const JpegWriter&) = delete;

  template <typename Step>
  void Run(const Step& step) {
    if (!JpegSucceeds(errors_, step))
      throw Error(std::string("cannot encode the JPEG: ") + errors_.text, place_);
  }

  jpeg_compress_struct jpeg = {};
  StringTarget target;

 private:
  const Place& place_;
  JpegErrors errors_;
};

void Configure(jpeg_compress_struct& jpeg, const Image& image, const WriteOptions& options) {
  jpeg.image_width = JDIMENSION(image.width);
  jpeg.image_height = JDIMENSION(image.height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, options.jpegQuality, TRUE);
  jpeg.optimize_coding = TRUE;
  if (options.jpegQuality >= 90) {
    jpeg.comp_info[0].h_samp_factor = 1;
    jpeg.comp_info[0].v_samp_factor = 1;
  }
}

void ConvertRow(const Image& image, int y, const WriteOptions& options, JSAMPLE* to) {
  for (int x = 0; x < image.width; ++x) {
    const vec3 color = DisplayColor(image.Premultiplied(image.Index(x, y)), options);
    *to++ = Quantize8(color.x);
    *to++ = Quantize8(color.y);
    *to++ = Quantize8(color.z);
  }
}

std::vector<std::string> Comments(const Metadata& metadata, const Place& place) {
  std::vector<std::string> comments;
  for (const auto& [key, value] : metadata) {
    comments.push_back(MetadataLine(key, value));
    if (comments.back().size() > LongestComment)
      throw Error(fmt::format("the metadata entry '{}' is too long for a JPEG", key), place,
                  fmt::format("it may have {} bytes", LongestComment));
  }
  return comments;
}

}  // namespace

std::string EncodeJpeg(const Image& image, const WriteOptions& options, const Place& place) {
  if (image.width > JPEG_MAX_DIMENSION || image.height > JPEG_MAX_DIMENSION)
    throw Error(fmt::format("{}×{} pixels are too many for a JPEG", image.width, image.height),
                place,
                fmt::format("its sides have at most {}; write a .png or an .exr instead",
                            JPEG_MAX_DIMENSION));
  JpegWriter writer(place);
  jpeg_compress_struct& jpeg = writer.jpeg;
  const std::vector<std::string> comments = Comments(options.metadata, place);
  std::vector<JSAMPLE> row(std::size_t(image.width) * 3);

  writer.Run([&] {
    Configure(jpeg, image, options);
    jpeg_start_compress(&jpeg, TRUE);
    for (const std::string& comment : comments)
      jpeg_write_marker(&jpeg, JPEG_COM, reinterpret_cast<const JOCTET*>(comment.data()),
                        static_cast<unsigned int>(comment.size()));
    for (int y = 0; y < image.height; ++y) {
      ConvertRow(image, y, options, row.data());
      JSAMPLE* rows[] = {row.data()};
      jpeg_write_scanlines(&jpeg, rows, 1);
    }
    jpeg_finish_compress(&jpeg);
  });
  return std::move(writer.target.bytes);
}

}  // namespace snell::image
