// SPDX-License-Identifier: Apache-2.0
//
// Radiance pictures (.hdr, .pic) in all their forms: flat pixels, both run-length encodings, RGB and XYZ,
// exposure, colour correction, primaries and the eight orientations of the resolution line. Ward, "Real
// Pixels", Graphics Gems II (1991), §II.5, and the Radiance file formats reference.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "image/chromaticity.h"
#include "image/codec.h"
#include "image/metadata.h"
#include "image/orientation.h"

namespace snell::image {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// Far more pixels per byte than run lengths reach in files that anybody keeps.
constexpr std::uint64_t BestCompression = 4096;

// Reads the file from front to back.
class Cursor {
 public:
  explicit Cursor(const Source& source) : source_(source) {}

  std::uint8_t Byte() {
    if (position_ >= source_.bytes.size()) throw Fault("the HDR ends early");
    return std::uint8_t(source_.bytes[position_++]);
  }
  Rgbe Pixel() {
    Rgbe pixel;
    for (std::uint8_t& component : pixel) component = Byte();
    return pixel;
  }
  void StepBack(std::size_t count) { position_ -= count; }

  // The text up to the next line break, without it.
  std::string_view Line() {
    const std::size_t end = source_.bytes.find('\n', position_);
    if (end == std::string_view::npos) throw Fault("the header of the HDR ends early");
    std::string_view line = source_.bytes.substr(position_, end - position_);
    position_ = end + 1;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  Error Fault(std::string message) const {
    return source_.Fault(std::move(message), std::int64_t(position_));
  }

 private:
  const Source& source_;
  std::size_t position_ = 0;
};

struct Header {
  bool xyz = false;
  vec3 exposure{1.0f};  // what the pixels have been multiplied by
  bool statesPrimaries = false;
  Chromaticities primaries;
  int rows = 0;  // as stored: rows of `columns` pixels each
  int columns = 0;
  Orientation orientation;
};

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// The numbers that a text begins with, at most as many as `numbers` has room for; returns how many.
template <typename Number, std::size_t N>
std::size_t ReadNumbers(std::string_view text, std::array<Number, N>& numbers) {
  for (std::size_t i = 0; i < N; ++i) {
    text = Trimmed(text);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
    if (error != std::errc()) return i;
    text.remove_prefix(std::size_t(end - text.data()));
  }
  return N;
}

// Take what a line "NAME=value" says; false if the name is not one that matters to the pixels.
bool ReadVariable(std::string_view name, std::string_view value, Header& header,
                  const Cursor& cursor) {
  if (name == "FORMAT") {
    value = Trimmed(value);
    header.xyz = value == "32-bit_rle_xyze";
    if (!header.xyz && value != "32-bit_rle_rgbe")
      throw cursor.Fault(
          fmt::format("the HDR has the unknown pixel format '{}'", Printable(value)));
    return true;
  }
  if (name == "EXPOSURE") {
    std::array<float, 1> factor;
    if (ReadNumbers(value, factor) == 1 && factor[0] > 0) header.exposure *= factor[0];
    return true;
  }
  if (name == "COLORCORR") {
    std::array<float, 3> factor;
    if (ReadNumbers(value, factor) == 3 && factor[0] > 0 && factor[1] > 0 && factor[2] > 0)
      header.exposure *= vec3(factor[0], factor[1], factor[2]);
    return true;
  }
  if (name == "PRIMARIES") {
    std::array<double, 8> xy;
    if (ReadNumbers(value, xy) == 8) {
      header.primaries = {{xy[0], xy[1]}, {xy[2], xy[3]}, {xy[4], xy[5]}, {xy[6], xy[7]}};
      header.statesPrimaries = IsUsable(header.primaries);
    }
    return true;
  }
  return false;
}

// Read "-Y 512 +X 1024": the slower axis first, with the directions in which stored pixels run.
void ReadResolution(std::string_view line, Header& header, const Source& source,
                    const Cursor& cursor) {
  const Error fault = cursor.Fault(fmt::format("'{}' is no resolution of an HDR", Printable(line)));
  struct Axis {
    char sign, name;
    std::int64_t count;
  };
  const auto axis = [&] {
    line = Trimmed(line);
    if (line.size() < 2 || (line[0] != '+' && line[0] != '-')) throw fault;
    Axis read{line[0], line[1], 0};
    line = Trimmed(line.substr(2));
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), read.count);
    if (error != std::errc()) throw fault;
    line.remove_prefix(std::size_t(end - line.data()));
    return read;
  };
  const Axis rows = axis(), columns = axis();
  const bool rowsAreY = rows.name == 'Y' && columns.name == 'X';
  if (!rowsAreY && !(rows.name == 'X' && columns.name == 'Y')) throw fault;
  source.CheckSize(columns.count, rows.count);
  header.rows = int(rows.count);
  header.columns = int(columns.count);

  // X runs to the right and Y runs up
  const bool yRunsUp = (rowsAreY ? rows : columns).sign == '+';
  const bool xRunsLeft = (rowsAreY ? columns : rows).sign == '-';
  header.orientation.flipX = rowsAreY ? xRunsLeft : yRunsUp;
  header.orientation.flipY = rowsAreY ? yRunsUp : xRunsLeft;
  header.orientation.transpose = !rowsAreY;
}

Header ReadHeader(Cursor& cursor, const Source& source) {
  Header header;
  cursor.Line();
  for (std::string_view line = cursor.Line(); !line.empty(); line = cursor.Line()) {
    const std::size_t equals = line.find('=');
    if (line.starts_with('#')) {
      AddMetadataLine(Trimmed(line.substr(1)), *source.metadata);
    } else if (equals == line.npos) {
      AddMetadataLine(line, *source.metadata);
    } else {
      const std::string_view name = line.substr(0, equals), value = line.substr(equals + 1);
      if (!ReadVariable(name, value, header, cursor))
        AddMetadataLine(MetadataLine(std::string(name), std::string(value)), *source.metadata);
    }
  }
  ReadResolution(cursor.Line(), header, source, cursor);
  return header;
}

// One component after the other, each as runs (128 + length, value) and literals (length, values …).
void ReadComponentRuns(Cursor& cursor, std::vector<Rgbe>& row) {
  for (std::size_t component = 0; component < 4; ++component) {
    for (std::size_t x = 0; x < row.size();) {
      const std::size_t code = cursor.Byte();
      const std::size_t length = code > 128 ? code - 128 : code;
      if (length == 0 || length > row.size() - x)
        throw cursor.Fault("the HDR is damaged: a run does not fit its row");
      if (code > 128) {
        const std::uint8_t value = cursor.Byte();
        for (std::size_t i = 0; i < length; ++i) row[x++][component] = value;
      } else {
        for (std::size_t i = 0; i < length; ++i) row[x++][component] = cursor.Byte();
      }
    }
  }
}

// Whole pixels; (1, 1, 1, n) repeats the last one n times, 256·n times if it follows another, and so on.
void ReadPixelRuns(Cursor& cursor, std::vector<Rgbe>& row) {
  int shift = 0;
  for (std::size_t x = 0; x < row.size();) {
    const Rgbe pixel = cursor.Pixel();
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      row[x++] = pixel;
      shift = 0;
      continue;
    }
    const std::size_t length = shift < 32 ? std::size_t(pixel[3]) << shift : row.size();
    if (x == 0 || length > row.size() - x)
      throw cursor.Fault("the HDR is damaged: a run does not fit its row");
    for (std::size_t i = 0; i < length; ++i, ++x) row[x] = row[x - 1];
    shift += 8;
  }
}

void ReadRow(Cursor& cursor, std::vector<Rgbe>& row) {
  if (row.size() < 8 || row.size() > 0x7fff) return ReadPixelRuns(cursor, row);
  const Rgbe mark = cursor.Pixel();
  if (mark[0] != 2 || mark[1] != 2 || mark[2] >= 128) {
    cursor.StepBack(4);
    return ReadPixelRuns(cursor, row);
  }
  if (std::size_t(mark[2] << 8 | mark[3]) != row.size())
    throw cursor.Fault("the HDR is damaged: a row has another length than the picture");
  ReadComponentRuns(cursor, row);
}

}  // namespace

Image DecodeHdr(const Source& source) {
  Cursor cursor(source);
  const Header header = ReadHeader(cursor, source);
  source.CheckPlausible(std::uint64_t(header.rows) * std::uint64_t(header.columns),
                        BestCompression);

  // The shared exponent is that of a binary fraction of eight bits
  std::array<float, 256> scale;
  for (int e = 0; e < 256; ++e) scale[std::size_t(e)] = e == 0 ? 0.0f : std::ldexp(1.0f, e - 136);

  Image image{header.columns, header.rows};
  std::vector<Rgbe> row(std::size_t(header.columns));
  for (int y = 0; y < header.rows; ++y) {
    ReadRow(cursor, row);
    vec3* to = &image.At(0, y);
    for (const Rgbe& p : row) *to++ = vec3(p[0], p[1], p[2]) * scale[p[3]];
  }

  // Undo the exposure and go to Rec.709, which is what files mean that say nothing
  if (source.options.colorSpace != ColorSpace::Raw) {
    if (header.exposure != vec3(1.0f))
      for (vec3& pixel : image.pixels) pixel = pixel / header.exposure;
    if (header.xyz)
      Transform(XyzToRec709(header.statesPrimaries ? header.primaries.white
                                                   : glm::dvec2(1.0 / 3.0, 1.0 / 3.0)),
                image.pixels);
    else if (header.statesPrimaries)
      ConvertToRec709(header.primaries, image.pixels);
  }
  return Upright(std::move(image), header.orientation);
}

}  // namespace snell::image
