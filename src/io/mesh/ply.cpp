// SPDX-License-Identifier: Apache-2.0
//
// PLY, in ASCII and both binary encodings: polygons and triangle strips, normals, colours, and texture
// coordinates of vertices or of faces' corners. Integer colours are sRGB, as scanners and MeshLab write them;
// floats are linear. A reader of our own, unlike OBJ's: Assimp 5.2 (Debian 12) keeps one
// triangle of every strip and one texture coordinate of every vertex on a seam, takes files cut short for
// whole ones, and reads past its buffers on headers that are cut short.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/mesh/colors.h"
#include "io/mesh/ply_header.h"
#include "io/mesh/ply_source.h"
#include "io/mesh/readers.h"
#include "scene/places.h"
#include "util/index_table.h"
#include "util/text.h"

namespace snell::io {
namespace {

// What a vertex's property stands for.
enum Role { X, Y, Z, NormalX, NormalY, NormalZ, U, V, Red, Green, Blue, Alpha, RoleCount };

// What full intensity is. Programs write bytes, whatever the type that has room for them.
float WhiteOf(PlyType type) {
  switch (type) {
    case PlyType::Int8: return 127;
    case PlyType::Uint16: return 65535;
    case PlyType::Float32:
    case PlyType::Float64: return 1;
    default: return 255;
  }
}

// Reads the elements in the order of the file, which may give faces before vertices.
template <class Source>
class PlyBody {
 public:
  PlyBody(const MeshFile& file, const PlyHeader& header)
      : file_(file), header_(header), source_(file, header.size) {
    if (const PlyElement* vertices = header.Find("vertex")) vertexCount_ = vertices->count;
  }

  FaceSet Read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        ReadVertices(element);
      } else if (element.properties.empty()) {
        continue;
      } else if (element.name == "face") {
        ReadFaces(element);
      } else if (element.name == "tristrips") {
        ReadStrips(element);
      } else {
        for (std::uint64_t i = 0; i < element.count; ++i) SkipRecord(element);
      }
    }
    if (degenerate_ > 0)
      file_.Warn(Plural(degenerate_, "degenerate face") + " left out", file_.AtLine(0));
    return std::move(faces_);
  }

 private:
  void ReadVertices(const PlyElement& element) {
    // Which properties matter
    const int at[RoleCount] = {element.Find({"x"}),
                               element.Find({"y"}),
                               element.Find({"z"}),
                               element.Find({"nx"}),
                               element.Find({"ny"}),
                               element.Find({"nz"}),
                               element.Find({"u", "s", "texture_u", "texture_s"}),
                               element.Find({"v", "t", "texture_v", "texture_t"}),
                               element.Find({"red", "r", "diffuse_red"}),
                               element.Find({"green", "g", "diffuse_green"}),
                               element.Find({"blue", "b", "diffuse_blue"}),
                               element.Find({"alpha", "a"})};
    for (int role = X; role <= Z; ++role)
      if (at[role] < 0 || element.properties[std::size_t(at[role])].isList)
        throw Error(fmt::format("the vertices have no property '{}'", "xyz"[role]),
                    file_.AtLine(element.line));
    std::vector<int> roleOf(element.properties.size(), RoleCount);
    for (int role = 0; role < RoleCount; ++role)
      if (at[role] >= 0) roleOf[std::size_t(at[role])] = role;
    faces_.normalsGoWithPositions = at[NormalX] >= 0 && at[NormalY] >= 0 && at[NormalZ] >= 0;
    faces_.uvsGoWithPositions = at[U] >= 0 && at[V] >= 0;
    const bool colored = at[Red] >= 0 && at[Green] >= 0 && at[Blue] >= 0;
    float white[4] = {1, 1, 1, 1};
    for (int role = Red; role <= Alpha; ++role)
      if (at[role] >= 0)
        white[role - Red] = WhiteOf(element.properties[std::size_t(at[role])].type);
    faces_.positions.reserve(element.count);
    if (colored) faces_.colors.reserve(element.count);
    if (faces_.normalsGoWithPositions) faces_.normals.reserve(element.count);
    if (faces_.uvsGoWithPositions) faces_.uvs.reserve(element.count);

    for (std::uint64_t i = 0; i < element.count; ++i) {
      float values[RoleCount] = {};
      values[Alpha] = white[3];
      for (std::size_t p = 0; p < roleOf.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (property.isList || roleOf[p] == RoleCount)
          SkipProperty(property);
        else
          values[roleOf[p]] = float(source_.Number(property.type));
      }
      source_.EndRecord();
      faces_.positions.emplace_back(values[X], values[Y], values[Z]);
      if (faces_.normalsGoWithPositions)
        faces_.normals.emplace_back(values[NormalX], values[NormalY], values[NormalZ]);
      if (faces_.uvsGoWithPositions) faces_.uvs.emplace_back(values[U], values[V]);
      if (colored)
        faces_.colors.emplace_back(values[Red] / white[0], values[Green] / white[1],
                                   values[Blue] / white[2], values[Alpha] / white[3]);
    }
    if (!colored) return;
    const bool integer = IsInteger(element.properties[std::size_t(at[Red])].type);
    DecodeColors(faces_, integer ? ColorCode::Srgb : ColorCode::Linear, file_);
  }

  void ReadFaces(const PlyElement& element) {
    const int indices = FindIndices(element);
    const int wedges = HasVertexUvs() ? -1 : element.Find({"texcoord"});
    Reserve(element, indices);

    for (std::uint64_t i = 0; i < element.count; ++i) {
      corners_.clear();
      uvs_.clear();
      for (int p = 0; p < int(element.properties.size()); ++p) {
        const PlyProperty& property = element.properties[std::size_t(p)];
        if (p == indices)
          ReadIndices(property, element, i);
        else if (p == wedges && property.isList)
          ReadList(property, uvs_);
        else
          SkipProperty(property);
      }
      source_.EndRecord();
      AddFace();
    }
  }

  // Strips of triangles, each with every other turned around; −1 begins a new one.
  void ReadStrips(const PlyElement& element) {
    const int indices = FindIndices(element);
    Reserve(element, indices);
    std::vector<double> strip;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      strip.clear();
      for (int p = 0; p < int(element.properties.size()); ++p) {
        const PlyProperty& property = element.properties[std::size_t(p)];
        if (p == indices)
          ReadList(property, strip);
        else
          SkipProperty(property);
      }
      source_.EndRecord();

      corners_.clear();
      bool turned = false;
      for (const double value : strip) {
        if (value == -1) {
          corners_.clear();
          turned = false;
          continue;
        }
        corners_.push_back(ToIndex(value, element, i));
        if (corners_.size() < 3) continue;
        faces_.AddCorner(corners_[turned ? 1 : 0]);
        faces_.AddCorner(corners_[turned ? 0 : 1]);
        faces_.AddCorner(corners_[2]);
        faces_.EndFace(3);
        corners_.erase(corners_.begin());
        turned = !turned;
      }
    }
  }

  bool HasVertexUvs() const {
    const PlyElement* vertices = header_.Find("vertex");
    return vertices && vertices->Find({"u", "s", "texture_u", "texture_s"}) >= 0;
  }

  int FindIndices(const PlyElement& element) const {
    const int indices = element.Find({"vertex_indices", "vertex_index"});
    if (indices < 0 || !element.properties[std::size_t(indices)].isList)
      throw Error(
          fmt::format("the elements {} have no list 'vertex_indices'", Quoted(element.name)),
          file_.AtLine(element.line));
    return indices;
  }

  // Make room for triangles, if there are bytes for as many.
  void Reserve(const PlyElement& element, int indices) {
    const std::size_t size = header_.encoding == PlyEncoding::Ascii
                                 ? 2
                                 : SizeOf(element.properties[std::size_t(indices)].type);
    faces_.positionOf.reserve(std::min<std::uint64_t>(element.count * 3, source_.left() / size));
  }

  void ReadIndices(const PlyProperty& property, const PlyElement& element, std::uint64_t face) {
    const std::uint64_t count = ReadCount(property);
    for (std::uint64_t i = 0; i < count; ++i)
      corners_.push_back(ToIndex(source_.Number(property.type), element, face));
  }

  std::uint32_t ToIndex(double value, const PlyElement& element, std::uint64_t record) const {
    if (!(value >= 0 && value < double(vertexCount_)) || value != std::floor(value))
      source_.Fail(fmt::format("{} {} refers to vertex {}, but there are {}, counted from 0",
                               element.name, record, value, WithCommas(vertexCount_)));
    return std::uint32_t(value);
  }

  void ReadList(const PlyProperty& property, std::vector<double>& list) {
    const std::uint64_t count = ReadCount(property);
    for (std::uint64_t i = 0; i < count; ++i) list.push_back(source_.Number(property.type));
  }

  // The length of a list that the file is long enough for.
  std::uint64_t ReadCount(const PlyProperty& property) {
    const double count = source_.Number(property.countType);
    if (!(count >= 0 && count <= 4294967295.0) || count != std::floor(count))
      source_.Fail(fmt::format("a list {} of length {}", Quoted(property.name), count));
    source_.ExpectNumbers(property.type, std::uint64_t(count));
    return std::uint64_t(count);
  }

  void SkipProperty(const PlyProperty& property) {
    source_.Skip(property.type, property.isList ? ReadCount(property) : 1);
  }

  void SkipRecord(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) SkipProperty(property);
    source_.EndRecord();
  }

  // Add the face of corners_; uvs_ has two numbers for each, or is not used.
  void AddFace() {
    if (corners_.size() < 3) {
      ++degenerate_;
      return;
    }
    const bool hasUvs = uvs_.size() == 2 * corners_.size();
    for (std::size_t i = 0; i < corners_.size(); ++i)
      faces_.AddCorner(corners_[i],
                       hasUvs ? AddUv(float(uvs_[2 * i]), float(uvs_[2 * i + 1])) : NoIndex);
    faces_.EndFace(std::uint32_t(corners_.size()));
  }

  // The index of a uv among those of corners; equal ones are joined.
  std::uint32_t AddUv(float u, float v) {
    const std::uint32_t bitsU = scene::CoordinateBits(u), bitsV = scene::CoordinateBits(v);
    const std::uint32_t next = std::uint32_t(faces_.uvs.size());
    const std::uint32_t index =
        uvTable_.FindOrAdd(HashOf(bitsU, bitsV, 0), next, [&](std::uint32_t i) {
          return scene::CoordinateBits(faces_.uvs[i].x) == bitsU &&
                 scene::CoordinateBits(faces_.uvs[i].y) == bitsV;
        });
    if (index == next) faces_.uvs.emplace_back(u, v);
    return index;
  }

  const MeshFile& file_;
  const PlyHeader& header_;
  Source source_;
  FaceSet faces_;
  std::uint64_t vertexCount_ = 0;
  std::uint64_t degenerate_ = 0;
  IndexTable uvTable_{0};
  std::vector<std::uint32_t> corners_;  // of the current face
  std::vector<double> uvs_;
};

// Fail if the file has no faces, and say what it has instead.
void CheckContents(const MeshFile& file, const PlyHeader& header) {
  const PlyElement* vertices = header.Find("vertex");
  if (!vertices) throw Error("the file has no element 'vertex'", file.AtLine(0));
  if (vertices->count > NoIndex)
    throw Error(fmt::format("{} vertices; the limit is {}", WithCommas(vertices->count),
                            WithCommas(NoIndex)),
                file.AtLine(vertices->line));
  for (const char* name : {"face", "tristrips"})
    if (const PlyElement* element = header.Find(name); element && element->count > 0) return;

  std::string contents = vertices->count > 0 ? "a cloud of " : "";
  contents += Plural(vertices->count, "point");
  if (const PlyElement* edges = header.Find("edge"); edges && edges->count > 0)
    contents += ", " + Plural(edges->count, "edge");
  throw Error("there are no faces to render; the file has " + contents, file.AtLine(0));
}

}  // namespace

FaceSet ReadPly(const MeshFile& file) {
  const PlyHeader header = ReadPlyHeader(file);
  CheckContents(file, header);
  if (const PlyElement* element = header.Find("face"); element && element->Find({"red", "r"}) >= 0)
    file.Warn("the faces' colors are not used", file.AtLine(element->line));

  constexpr bool LittleEndianHost = std::endian::native == std::endian::little;
  const bool little = header.encoding == PlyEncoding::LittleEndian;
  FaceSet faces = header.encoding == PlyEncoding::Ascii ? PlyBody<PlyWords>(file, header).Read()
                  : little == LittleEndianHost ? PlyBody<PlyBytes<false>>(file, header).Read()
                                               : PlyBody<PlyBytes<true>>(file, header).Read();
  if (faces.faceCount == 0)
    throw Error("there are no faces to render: none has three corners", file.AtLine(0));
  return faces;
}

bool LooksLikePly(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

}  // namespace snell::io
