// SPDX-License-Identifier: Apache-2.0
#include "image/exr_header.h"

#include <algorithm>
#include <iterator>

namespace snell::image {

namespace {

// Bytes of the types that have a fixed size. (OpenEXR File Layout, "Predefined Attribute Types".)
struct TypeSize {
  std::string_view type;
  std::uint32_t bytes;
};
constexpr TypeSize FixedSizes[] = {
    {"box2i", 16},
    {"box2f", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"double", 8},
    {"envmap", 1},
    {"deepImageState", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33f", 36},
    {"m33d", 72},
    {"m44f", 64},
    {"m44d", 128},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2i", 8},
    {"v2f", 8},
    {"v2d", 16},
    {"v3i", 12},
    {"v3f", 12},
    {"v3d", 24},
};

// Reads the headers from front to back; every function throws where the file ends early.
class HeaderWalk {
 public:
  explicit HeaderWalk(const Source& source) : source_(source), rest_(source.bytes) {}

  std::string_view Take(std::size_t count) {
    if (count > rest_.size()) throw Fault();
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::string_view Text() {
    const std::size_t length = rest_.find('\0');
    if (length == rest_.npos) throw Fault();
    return Take(length + 1).substr(0, length);
  }
  std::uint32_t Number() {
    std::uint32_t number = 0;
    for (int shift = 0; shift < 32; shift += 8)
      number |= std::uint32_t(std::uint8_t(Take(1)[0])) << shift;
    return number;
  }
  bool AtEnd() const { return rest_.empty(); }
  bool AtZero() const { return !rest_.empty() && rest_[0] == '\0'; }
  std::size_t Left() const { return rest_.size(); }

  Error Fault() const {
    return source_.Fault("the EXR ends early or is damaged: an attribute has an impossible size",
                         std::int64_t(source_.bytes.size() - rest_.size()));
  }

 private:
  const Source& source_;
  std::string_view rest_;
};

// A list of channels: name, then 16 bytes, for each; an empty name ends it.
void PassChannels(HeaderWalk& walk, std::uint32_t size) {
  const std::size_t before = walk.Left();
  while (!walk.Text().empty()) walk.Take(16);
  if (before - walk.Left() != size) throw walk.Fault();
}

// A small picture: width, height, four bytes a pixel.
void PassPreview(HeaderWalk& walk, std::uint32_t size) {
  const std::uint64_t width = walk.Number(), height = walk.Number();
  if (width > size || height > size || 8 + 4 * width * height != size) throw walk.Fault();
  walk.Take(size - 8);
}

void PassAttribute(HeaderWalk& walk) {
  const std::string_view type = walk.Text();
  const std::uint32_t size = walk.Number();
  const auto* fixed = std::find_if(std::begin(FixedSizes), std::end(FixedSizes),
                                   [&](const TypeSize& entry) { return entry.type == type; });
  if (fixed != std::end(FixedSizes) && fixed->bytes != size) throw walk.Fault();
  if (type == "floatvector" && size % 4 != 0) throw walk.Fault();

  if (type == "chlist")
    PassChannels(walk, size);
  else if (type == "preview")
    PassPreview(walk, size);
  else
    walk.Take(size);
}

}  // namespace

void CheckExrHeaders(const Source& source) {
  HeaderWalk walk(source);
  constexpr std::uint32_t MultiPart = 0x1000;
  walk.Number();  // the signature
  const bool multiPart = walk.Number() & MultiPart;

  // A header ends with an empty name, and so does the list of headers in a multi-part file
  do {
    while (!walk.AtZero()) {
      walk.Text();
      PassAttribute(walk);
    }
    walk.Take(1);
  } while (multiPart && !walk.AtEnd() && !walk.AtZero());
}

}  // namespace snell::image
