// SPDX-License-Identifier: Apache-2.0
//
// STL, in ASCII and binary. Its triangles share no vertices: those in equal places are joined as they are
// read, so that faces can be smoothed and memory holds each only once. The normals and the colors that some
// programs write are not used: normals are those of the faces, and often wrong or zero. A reader of our
// own, as Assimp takes fifteen to forty times the finished mesh in memory and tells no lines.
// Format: 3D Systems 1989, "StereoLithography interface specification".
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "io/mesh/readers.h"
#include "io/mesh/text.h"
#include "scene/places.h"
#include "util/index_table.h"
#include "util/text.h"

namespace snell::io {
namespace {

using scene::uvec3;
using scene::vec3;

// Of the binary encoding, in bytes: a header, the count of triangles; normal, three corners, attribute.
constexpr std::size_t HeaderSize = 80;
constexpr std::size_t BodyOffset = HeaderSize + 4;
constexpr std::size_t TriangleSize = 50;

// The count of triangles that a binary file claims. The format is little-endian.
std::uint64_t ClaimedTriangles(std::string_view bytes) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    count |= std::uint64_t(std::uint8_t(bytes[HeaderSize + i])) << (8 * i);
  return count;
}

bool HasExactSize(std::string_view bytes) {
  return bytes.size() >= BodyOffset &&
         bytes.size() == BodyOffset + ClaimedTriangles(bytes) * TriangleSize;
}

// Binary headers may begin with "solid" too, but text has no zero bytes.
bool IsText(std::string_view bytes) {
  if (HasExactSize(bytes)) return false;
  TextScanner scanner(bytes);
  return EqualsIgnoringCase(scanner.Word(), "solid") &&
         bytes.substr(0, 1024).find('\0') == bytes.npos;
}

// Collects triangles over joined positions.
class StlBuilder {
 public:
  explicit StlBuilder(std::uint64_t triangles) : table_(triangles / 2) {
    faces_.positionOf.reserve(triangles * 3);
  }

  void AddCorner(const vec3& position) {
    const uvec3 bits = scene::PositionBits(position);
    const std::uint32_t next = std::uint32_t(faces_.positions.size());
    const std::uint32_t index = table_.FindOrAdd(
        HashOf(bits.x, bits.y, bits.z), next,
        [&](std::uint32_t i) { return scene::PositionBits(faces_.positions[i]) == bits; });
    if (index == next) faces_.positions.push_back(position);
    faces_.AddCorner(index);
  }
  void EndFace(std::uint32_t corners) { faces_.EndFace(corners); }

  FaceSet Take() { return std::move(faces_); }

 private:
  FaceSet faces_;
  IndexTable table_;
};

float FloatAt(const char* bytes) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) bits |= std::uint32_t(std::uint8_t(bytes[i])) << (8 * i);
  return std::bit_cast<float>(bits);
}

FaceSet ReadBinary(const MeshFile& file) {
  // Check the claimed size before anything is made of it
  const std::uint64_t count = ClaimedTriangles(file.bytes);
  const std::uint64_t expected = BodyOffset + count * TriangleSize;
  if (expected > file.bytes.size())
    throw Error(
        fmt::format("the file claims {}, which take {}, but has only {}", Plural(count, "triangle"),
                    ByteSize(expected), ByteSize(file.bytes.size())),
        file.AtByte(HeaderSize), "the file may be cut short");
  if (expected < file.bytes.size())
    file.Warn(fmt::format("{} bytes after the last triangle ignored", file.bytes.size() - expected),
              file.AtByte(expected));

  // Magics names a color in the header; VisCAM and SolidView set the highest bit of the attribute
  bool colored =
      std::string_view(file.bytes).substr(0, HeaderSize).find("COLOR=") != std::string::npos;
  StlBuilder builder(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const char* corner = file.bytes.data() + BodyOffset + i * TriangleSize + 12;
    colored = colored || (corner[37] & 0x80) != 0;
    for (int k = 0; k < 3; ++k, corner += 12)
      builder.AddCorner(vec3(FloatAt(corner), FloatAt(corner + 4), FloatAt(corner + 8)));
    builder.EndFace(3);
  }
  if (colored) file.Warn("the triangles' colors are not used", file.AtLine(0));
  return builder.Take();
}

// Reads "solid", "facet normal", "outer loop", "vertex", "endloop", "endfacet" and "endsolid".
class StlText {
 public:
  explicit StlText(const MeshFile& file)
      : file_(file), scanner_(file.bytes), builder_(file.bytes.size() / BytesPerFacet) {}

  FaceSet Read() {
    for (std::string_view word; !(word = scanner_.Word()).empty();) {
      if (EqualsIgnoringCase(word, "vertex")) {
        ReadVertex();
      } else if (EqualsIgnoringCase(word, "endloop")) {
        EndLoop();
      } else if (EqualsIgnoringCase(word, "solid")) {
        StartSolid();
      } else if (EqualsIgnoringCase(word, "endsolid")) {
        if (corners_ > 0) Fail("'endsolid' within a facet");
        inSolid_ = false;
        scanner_.RestOfLine();
      } else if (EqualsIgnoringCase(word, "facet") || EqualsIgnoringCase(word, "outer")) {
        scanner_.RestOfLine();
      } else if (!EqualsIgnoringCase(word, "endfacet")) {
        Fail("unknown word " + Quoted(word));
      }
    }
    if (corners_ > 0) Fail("the file ends within a facet", "it may be cut short");
    if (inSolid_)
      file_.Warn("the file ends without 'endsolid': it may be cut short",
                 file_.AtLine(scanner_.Line()));
    FaceSet faces = builder_.Take();
    if (solids_ == 1) faces.name = name_;
    return faces;
  }

 private:
  // About what programs write for one.
  static constexpr std::size_t BytesPerFacet = 160;

  void StartSolid() {
    if (corners_ > 0) Fail("'solid' within a facet");
    name_ = scanner_.RestOfLine();
    inSolid_ = true;
    ++solids_;
  }

  void ReadVertex() {
    vec3 position;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = scanner_.WordOnLine();
      double value = 0;
      if (word.empty()) Fail("a vertex needs three coordinates", "the file may be cut short");
      if (!ParseNumber(word, value)) Fail(Quoted(word) + " is not a number");
      position[axis] = float(value);
    }
    builder_.AddCorner(position);
    ++corners_;
  }

  void EndLoop() {
    if (corners_ < 3) Fail(fmt::format("a facet with {}", Plural(corners_, "vertex statement")));
    builder_.EndFace(corners_);
    corners_ = 0;
  }

  [[noreturn]] void Fail(std::string message, std::string hint = "") const {
    throw Error(std::move(message), file_.AtLine(scanner_.Line()), std::move(hint));
  }

  const MeshFile& file_;
  TextScanner scanner_;
  StlBuilder builder_;
  std::string name_;
  int solids_ = 0;
  bool inSolid_ = false;
  std::uint32_t corners_ = 0;  // of the current facet
};

}  // namespace

FaceSet ReadStl(const MeshFile& file) {
  const bool isText = IsText(file.bytes);
  if (!isText && file.bytes.size() < BodyOffset)
    throw Error(
        "not an STL file: too short for the binary format, and no text that begins with 'solid'",
        file.AtLine(0));
  FaceSet faces = isText ? StlText(file).Read() : ReadBinary(file);
  if (faces.faceCount == 0) throw Error("the file has no triangles", file.AtLine(0));
  return faces;
}

bool LooksLikeStl(std::string_view bytes) { return HasExactSize(bytes) || IsText(bytes); }

}  // namespace snell::io
