// SPDX-License-Identifier: Apache-2.0
//
// Wavefront OBJ by tinyobjloader's callbacks, which keep nothing of the file themselves: positions, uvs and
// normals go straight into the FaceSet. The reader gets no material reader, so that it opens no other file.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cstdint>
#include <istream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh/colors.h"
#include "io/mesh/obj_lines.h"
#include "io/mesh/readers.h"
#include "io/mesh/text.h"
#include "io/obj/parts.h"
#include "util/text.h"

namespace snell::io {
namespace {

constexpr float Undefined = std::numeric_limits<float>::quiet_NaN();

// Receives tinyobjloader's calls, one for each statement of `lines`.
class ObjBuilder {
 public:
  ObjBuilder(const MeshFile& file, const ObjLines& lines, ObjParts& parts)
      : file_(file), lines_(lines), parts_(parts) {}

  void Read(std::istream& stream) {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, float x, float y, float z, float) {
      static_cast<ObjBuilder*>(self)->AddPosition(x, y, z);
    };
    callbacks.texcoord_cb = [](void* self, float u, float v, float) {
      static_cast<ObjBuilder*>(self)->AddUv(u, v);
    };
    callbacks.normal_cb = [](void* self, float x, float y, float z) {
      static_cast<ObjBuilder*>(self)->AddNormal(x, y, z);
    };
    callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      static_cast<ObjBuilder*>(self)->AddFace(corners, count);
    };
    tinyobj::LoadObjWithCallback(stream, callbacks, this);
  }

  // The faces, after a check that all positions that they use exist. They may be defined after the faces.
  FaceSet Take() {
    if (highest_ >= 0 && std::uint64_t(highest_) >= faces_.positions.size())
      FailIndex(highest_ + 1, "vertex", faces_.positions.size(), highestLine_);
    // Blender and MeshLab write sRGB. Vertices without a color are white
    if (!faces_.colors.empty()) {
      faces_.colors.resize(faces_.positions.size(), scene::vec4(1.0f));
      DecodeColors(faces_, ColorCode::Srgb, file_);
    }
    return std::move(faces_);
  }

 private:
  float Defined(int number, float value) const {
    return lines_.IsUndefined(number) ? Undefined : value;
  }

  void AddPosition(float x, float y, float z) {
    if (lines_.HasColor()) {
      faces_.colors.resize(faces_.positions.size(), scene::vec4(1.0f));
      faces_.colors.emplace_back(lines_.color(), 1.0f);
    }
    faces_.positions.emplace_back(Defined(0, x), Defined(1, y), Defined(2, z));
  }
  void AddUv(float u, float v) { faces_.uvs.emplace_back(Defined(0, u), Defined(1, v)); }
  void AddNormal(float x, float y, float z) {
    faces_.normals.emplace_back(Defined(0, x), Defined(1, y), Defined(2, z));
  }

  void AddFace(const tinyobj::index_t* corners, int count) {
    parts_.BeginFace(faces_);
    for (int i = 0; i < count; ++i) {
      const std::uint32_t position =
          Resolve(corners[i].vertex_index, "vertex", faces_.positions.size());
      if (std::int64_t(position) > highest_) {
        highest_ = position;
        highestLine_ = lines_.line();
      }
      faces_.AddCorner(position, Resolve(corners[i].texcoord_index, "uv", faces_.uvs.size()),
                       Resolve(corners[i].normal_index, "normal", faces_.normals.size()));
    }
    faces_.EndFace(std::uint32_t(count));
  }

  // The index from 0 that stands for one from 1, for one back from the newest element, or for none.
  std::uint32_t Resolve(int index, const char* what, std::size_t count) const {
    if (index > 0) return std::uint32_t(index - 1);
    if (index == 0) return NoIndex;
    if (std::uint64_t(-std::int64_t(index)) > count) FailIndex(index, what, count, lines_.line());
    return std::uint32_t(std::int64_t(count) + index);
  }

  [[noreturn]] void FailIndex(std::int64_t index, const char* what, std::size_t count,
                              int line) const {
    throw Error(fmt::format("the face refers to {} {}, but {} {} defined{}", what, index,
                            count == 0 ? "none" : WithCommas(count), count > 1 ? "are" : "is",
                            index < 0 ? " so far" : ""),
                file_.AtLine(line));
  }

  const MeshFile& file_;
  const ObjLines& lines_;
  ObjParts& parts_;
  FaceSet faces_;
  std::int64_t highest_ = -1;  // of the positions that faces use
  int highestLine_ = 0;
};

// What the file holds besides faces: the noun for one of each.
constexpr std::pair<ObjExtra, const char*> Extras[] = {
    {ObjExtra::Points, "point statement"},       {ObjExtra::Lines, "line statement"},
    {ObjExtra::FreeForm, "free-form statement"}, {ObjExtra::ShortFaces, "degenerate face"},
    {ObjExtra::Unknown, "unknown statement"},
};

[[noreturn]] void FailWithoutFaces(const MeshFile& file, const ObjLines& lines,
                                   std::size_t positions) {
  std::string contents = positions == 0 ? "no vertices" : Plural(positions, "vertex statement");
  for (const auto& [extra, noun] : Extras)
    if (lines.Of(extra).count > 0) contents += ", " + Plural(lines.Of(extra).count, noun);
  throw Error("there are no faces to render; the file has " + contents, file.AtLine(0));
}

void WarnOfExtras(const MeshFile& file, const ObjLines& lines) {
  for (const auto& [extra, noun] : Extras) {
    const ObjLines::Tally& tally = lines.Of(extra);
    if (tally.count == 0) continue;
    file.Warn(fmt::format("{} left out, the first one {}", Plural(tally.count, noun),
                          Quoted(tally.keyword)),
              file.AtLine(tally.line));
  }
}

}  // namespace

ObjFile ReadObjFile(MeshFile& file) {
  ObjFile obj;
  ObjLines lines(file, obj.parts);
  std::istream stream(&lines);
  stream.exceptions(std::ios::badbit);  // lets the lines' Errors through
  ObjBuilder builder(file, lines, obj.parts);
  builder.Read(stream);

  obj.faces = builder.Take();
  if (obj.faces.faceCount == 0) FailWithoutFaces(file, lines, obj.faces.positions.size());
  WarnOfExtras(file, lines);
  obj.faces.name = obj.parts.OnlyName();
  return obj;
}

FaceSet ReadObj(MeshFile& file) {
  ObjFile obj = ReadObjFile(file);
  if (const int line = obj.parts.materialsLine(); line > 0)
    file.Warn("the file's materials are not read", file.AtLine(line));
  return std::move(obj.faces);
}

bool LooksLikeObj(std::string_view bytes) {
  static constexpr std::string_view Keywords[] = {"v", "vn", "vt", "f",      "o",
                                                  "g", "s",  "mg", "mtllib", "usemtl"};
  TextScanner scanner(bytes.substr(0, 65536));
  while (scanner.left() > 0) {
    const std::string_view word = scanner.WordOnLine();
    if (!word.empty() && word[0] != '#')
      return std::find(std::begin(Keywords), std::end(Keywords), word) != std::end(Keywords);
    scanner.RestOfLine();
  }
  return false;
}

}  // namespace snell::io
