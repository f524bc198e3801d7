// SPDX-License-Identifier: Apache-2.0
//
// The tree of a grid is not walked by its links: nodes of a level stand in a row, each with its place, and every row is
// checked against the file's end before it is read. Leaves are 8³ values; a value that a node of higher level has in
// place of a child stands for 8³ or 128³ of the same.
#include "io/grid/nanovdb.h"

#include <fmt/format.h>
#include <nanovdb/NanoVDB.h>
#include <nanovdb/util/IO.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/matrix.hpp>
#include <memory>
#include <vector>

#include "io/grid/bricks.h"
#include "util/error.h"

namespace snell::io {

namespace {

using scene::DensityGrid;

// The bytes of one grid.
class GridBytes {
 public:
  GridBytes(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  [[noreturn]] void Refuse(const std::string& why, std::string hint = {}) const {
    throw Error(why, {file_}, std::move(hint));
  }

  // `count` records of a kind from `offset` on, of which the one of this number is copied.
  void Require(std::uint64_t offset, std::uint64_t count, std::size_t size) const {
    if (offset > bytes_.size() || count > (bytes_.size() - offset) / size)
      Refuse("the file ends within a grid");
  }
  template <class T>
  void Copy(std::uint64_t offset, std::uint64_t number, T* record) const {
    std::memcpy(static_cast<void*>(record), bytes_.data() + offset + number * sizeof(T), sizeof(T));
  }
  std::size_t size() const { return bytes_.size(); }
  std::string_view Part(std::uint64_t offset, std::uint64_t size) const {
    Require(offset, size, 1);
    return bytes_.substr(offset, size);
  }
  const std::string& file() const { return file_; }

 private:
  std::string_view bytes_;
  const std::string& file_;
};

// A record of the format, which need not be constructible.
template <class T>
struct Raw {
  alignas(64) std::byte bytes[sizeof(T)] = {};
  T& get() { return *reinterpret_cast<T*>(bytes); }
};

glm::ivec3 ToPoint(const nanovdb::Coord& voxel) { return {voxel[0], voxel[1], voxel[2]}; }

// The values that nodes of a level have in place of children, each for `size`³ voxels.
template <class Node>
void ReadTiles(const GridBytes& bytes, std::uint64_t offset, std::uint32_t count, int size,
               Bricks& bricks) {
  using Data = typename Node::DataType;
  bytes.Require(offset, count, sizeof(Data));
  const auto node = std::make_unique<Raw<Data>>();
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes.Copy(offset, i, &node->get());
    Data& data = node->get();
    const int width = int(Node::DIM);
    const glm::ivec3 origin = ToPoint(data.mBBox.min() & ~(width - 1));
    for (std::uint32_t n = 0; n < Node::SIZE; ++n) {
      if (data.mChildMask.isOn(n) || !data.mValueMask.isOn(n)) continue;
      const nanovdb::Coord place = Node::OffsetToLocalCoord(n);
      bricks.Fill(origin, ToPoint(place) * size, size, data.mTable[n].value);
    }
  }
}

// A grid whose values are kept as `Build`.
template <class Build>
DensityGrid ReadTree(const GridBytes& bytes, const glm::dmat4& toObject) {
  using Leaf = nanovdb::NanoLeaf<Build>;
  using LeafData = typename Leaf::DataType;
  const std::uint64_t first = sizeof(nanovdb::GridData);
  bytes.Require(first, 1, sizeof(nanovdb::TreeData<3>));
  nanovdb::TreeData<3> tree = {};
  bytes.Copy(first, 0, &tree);
  for (const std::uint64_t offset : tree.mNodeOffset) {
    if (offset > bytes.size()) bytes.Refuse("the file ends within a grid");
  }
  Bricks bricks(bytes.file());
  ReadTiles<nanovdb::NanoUpper<Build>>(bytes, first + tree.mNodeOffset[2], tree.mNodeCount[2], 128,
                                       bricks);
  ReadTiles<nanovdb::NanoLower<Build>>(bytes, first + tree.mNodeOffset[1], tree.mNodeCount[1], 8,
                                       bricks);
  bytes.Require(first + tree.mNodeOffset[0], tree.mNodeCount[0], sizeof(LeafData));
  const auto leaf = std::make_unique<Raw<LeafData>>();
  for (std::uint32_t i = 0; i < tree.mNodeCount[0]; ++i) {
    bytes.Copy(first + tree.mNodeOffset[0], i, &leaf->get());
    float* values = bricks.Add(ToPoint(leaf->get().mBBoxMin & ~7));
    for (std::uint32_t n = 0; n < 512; ++n) values[n] = leaf->get().getValue(n);
  }
  return bricks.Finish(toObject);
}

glm::dmat4 ToAffine(const nanovdb::Map& map) {
  glm::dmat4 m(1.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) m[column][row] = map.mMatD[3 * row + column];
    m[3][row] = map.mVecD[row];
  }
  return m;
}

// Whether it can be turned round, also in single precision.
bool IsSound(const glm::dmat4& map) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!(std::abs(map[column][row]) < 1e12)) return false;
    }
  }
  return std::abs(glm::determinant(glm::dmat3(map))) > 1e-30;
}

DensityGrid ReadGrid(const GridBytes& bytes) {
  bytes.Require(0, 1, sizeof(nanovdb::GridData));
  nanovdb::GridData grid = {};
  bytes.Copy(0, 0, &grid);
  if (grid.mMagic != NANOVDB_MAGIC_NUMBER) bytes.Refuse("no grid where the file announces one");
  const glm::dmat4 toObject = ToAffine(grid.mMap);
  if (!IsSound(toObject)) bytes.Refuse("a grid's place in space is not sound");
  if (grid.mGridClass == nanovdb::GridClass::LevelSet)
    bytes.Refuse("the grid is a level set, no density", "convert it to a fog volume");
  switch (grid.mGridType) {
    case nanovdb::GridType::Float: return ReadTree<float>(bytes, toObject);
    case nanovdb::GridType::Fp4: return ReadTree<nanovdb::Fp4>(bytes, toObject);
    case nanovdb::GridType::Fp8: return ReadTree<nanovdb::Fp8>(bytes, toObject);
    case nanovdb::GridType::Fp16: return ReadTree<nanovdb::Fp16>(bytes, toObject);
    default:
      bytes.Refuse("the grid's values are of a kind that is not read",
                   "float, Fp4, Fp8 and Fp16 are");
  }
}

// A grid that is compressed as a zlib stream, after its length.
std::string Unpacked(const GridBytes& packed, std::uint64_t size) {
  std::uint64_t length = 0;
  packed.Require(0, 1, sizeof length);
  packed.Copy(0, 0, &length);
  const std::string_view stream = packed.Part(sizeof length, length);
  // No stream holds more than that (zlib's technical details)
  if (size > 1032 * length + 64) packed.Refuse("a compressed grid is shorter than it says");
  std::string bytes(size, '\0');
  uLongf written = uLongf(size);
  const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &written,
                                reinterpret_cast<const Bytef*>(stream.data()), uLong(length));
  if (status != Z_OK || written != size) packed.Refuse("a compressed grid is damaged");
  return bytes;
}

bool IsRead(nanovdb::GridType type) {
  return type == nanovdb::GridType::Float || type == nanovdb::GridType::Fp4 ||
         type == nanovdb::GridType::Fp8 || type == nanovdb::GridType::Fp16;
}

// Names in a message.
constexpr std::size_t LongestList = 300;
std::string Printable(std::string_view name) {
  std::string text(name.substr(0, 60));
  std::ranges::replace_if(
      text, [](char c) { return c < 0x20 || c > 0x7e; }, '?');
  return text;
}

// What a header says of a grid.
struct GridPart {
  std::uint64_t fileSize;
  std::uint64_t size;  // when it is not compressed
  bool isWanted;
};

}  // namespace

DensityGrid ReadNanoVdb(const std::string& bytes, const std::string& file, std::string_view name) {
  const GridBytes whole(bytes, file);
  std::uint64_t at = 0;
  std::string names;
  while (at < bytes.size()) {
    // Segments of a header, what there is to know of each grid, and the grids
    nanovdb::io::Header header;
    whole.Require(at, 1, sizeof header);
    whole.Copy(at, 0, &header);
    if (header.magic != NANOVDB_MAGIC_NUMBER) whole.Refuse("this is no NanoVDB file");
    if (header.version.getMajor() != NANOVDB_MAJOR_VERSION_NUMBER)
      whole.Refuse(fmt::format("NanoVDB files of version {} are not read, only of {}",
                               header.version.getMajor(), NANOVDB_MAJOR_VERSION_NUMBER));
    const bool isZip = header.codec == nanovdb::io::Codec::ZIP;
    if (!isZip && header.codec != nanovdb::io::Codec::NONE)
      whole.Refuse("the file is compressed by a codec that is not read",
                   "convert it with zip or without a codec (nanovdb_convert --zip)");
    at += sizeof header;
    std::vector<GridPart> grids;
    for (int i = 0; i < header.gridCount; ++i) {
      Raw<nanovdb::io::MetaData> raw;
      whole.Require(at, 1, sizeof(nanovdb::io::MetaData));
      whole.Copy(at, 0, &raw.get());
      const nanovdb::io::MetaData& about = raw.get();
      at += sizeof(nanovdb::io::MetaData);
      std::string_view called = whole.Part(at, about.nameSize);
      called = called.substr(0, called.find('\0'));
      at += about.nameSize;
      if (names.size() < LongestList)
        names += fmt::format("{}'{}'", names.empty() ? "" : ", ", Printable(called));
      grids.push_back(
          {about.fileSize, about.gridSize, name.empty() ? IsRead(about.gridType) : called == name});
    }
    for (const GridPart& grid : grids) {
      const GridBytes part(whole.Part(at, grid.fileSize), file);
      at += grid.fileSize;
      if (!grid.isWanted) continue;
      if (!isZip) return ReadGrid(part);
      const std::string unpacked = Unpacked(part, grid.size);
      return ReadGrid(GridBytes(unpacked, file));
    }
  }
  if (name.empty()) whole.Refuse("the file has no grid of numbers");
  whole.Refuse(fmt::format("there is no grid called '{}'", name), "there are " + names);
}

}  // namespace snell::io
