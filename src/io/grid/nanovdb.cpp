// SPDX-License-Identifier: Apache-2.0
//
// The tree of a grid is not walked by its links: nodes of a level stand in a row, each with its place, and every row is
// checked against the file's end before it is read. Leaves are 8³ values; a value that a node of higher level has in
// place of a child stands for 8³ or 128³ of the same.
#include "io/grid/nanovdb.h"

#include <fmt/format.h>
#include <nanovdb/NanoVDB.h>
#include <nanovdb/util/IO.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "util/error.h"

namespace snell::io {

namespace {

using scene::DensityGrid;

// Bricks that a grid may have, and places for bricks in its box.
constexpr std::size_t MostBricks = std::size_t(1) << 21;
constexpr double MostPlaces = double(1 << 26);
constexpr int FarthestVoxel = 1 << 24;

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

// Bricks by their place, in numbers of bricks.
class Bricks {
 public:
  explicit Bricks(const GridBytes& from) : from_(from) {}

  // The 512 values of the brick that begins at this voxel.
  float* Add(const nanovdb::Coord& voxel) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(voxel[axis]) > FarthestVoxel) from_.Refuse("a grid reaches too far");
    }
    const glm::ivec3 place(voxel[0] >> 3, voxel[1] >> 3, voxel[2] >> 3);
    const auto [entry, isNew] = places_.try_emplace({place.z, place.y, place.x}, places_.size());
    if (isNew) {
      if (places_.size() > MostBricks) from_.Refuse("a grid has more than 2 million bricks of 8³");
      lower_ = glm::min(lower_, place);
      upper_ = glm::max(upper_, place);
      values_.resize(places_.size() * 512);
    }
    return values_.data() + entry->second * 512;
  }

  // One value for `size`³ voxels.
  void Fill(const nanovdb::Coord& voxel, int size, float value) {
    if (!(value > 0)) return;
    for (int x = 0; x < size; x += 8) {
      for (int y = 0; y < size; y += 8) {
        for (int z = 0; z < size; z += 8)
          std::fill_n(Add(voxel + nanovdb::Coord(x, y, z)), 512, value);
      }
    }
  }

  DensityGrid Finish(const glm::dmat4& toObject) {
    DensityGrid grid;
    if (places_.empty()) from_.Refuse("the grid is empty");
    // What lies before the first voxel counts a little, too
    lower_ -= 1;
    const glm::dvec3 size(upper_ - lower_ + 1);
    if (size.x * size.y * size.z > MostPlaces) from_.Refuse("a grid's parts lie too far apart");
    grid.bricks = glm::uvec3(upper_ - lower_ + 1);
    grid.table.assign(std::size_t(grid.bricks.x) * grid.bricks.y * grid.bricks.z, -1);
    for (const auto& [place, number] : places_) {
      const glm::uvec3 at = glm::uvec3(glm::ivec3(place[2], place[1], place[0]) - lower_);
      grid.table[(std::size_t(at.z) * grid.bricks.y + at.y) * grid.bricks.x + at.x] = int(number);
    }
    grid.values = std::move(values_);
    for (float& value : grid.values) value = std::isfinite(value) && value > 0 ? value : 0.0f;
    glm::dmat4 shift(1.0);
    shift[3] = glm::dvec4(glm::dvec3(lower_) * 8.0, 1.0);
    grid.toObject = toObject * shift;
    return grid;
  }

 private:
  const GridBytes& from_;
  std::map<std::array<int, 3>, std::size_t> places_;
  std::vector<float> values_;
  glm::ivec3 lower_{std::numeric_limits<int>::max()};
  glm::ivec3 upper_{std::numeric_limits<int>::min()};
};

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
    const nanovdb::Coord origin = data.mBBox.min() & ~(width - 1);
    for (std::uint32_t n = 0; n < Node::SIZE; ++n) {
      if (data.mChildMask.isOn(n) || !data.mValueMask.isOn(n)) continue;
      const nanovdb::Coord place = Node::OffsetToLocalCoord(n);
      bricks.Fill(origin + nanovdb::Coord(place[0] * size, place[1] * size, place[2] * size), size,
                  data.mTable[n].value);
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
  Bricks bricks(bytes);
  ReadTiles<nanovdb::NanoUpper<Build>>(bytes, first + tree.mNodeOffset[2], tree.mNodeCount[2], 128,
                                       bricks);
  ReadTiles<nanovdb::NanoLower<Build>>(bytes, first + tree.mNodeOffset[1], tree.mNodeCount[1], 8,
                                       bricks);
  bytes.Require(first + tree.mNodeOffset[0], tree.mNodeCount[0], sizeof(LeafData));
  const auto leaf = std::make_unique<Raw<LeafData>>();
  for (std::uint32_t i = 0; i < tree.mNodeCount[0]; ++i) {
    bytes.Copy(first + tree.mNodeOffset[0], i, &leaf->get());
    float* values = bricks.Add(leaf->get().mBBoxMin & ~7);
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

DensityGrid ReadGrid(const GridBytes& bytes) {
  bytes.Require(0, 1, sizeof(nanovdb::GridData));
  nanovdb::GridData grid = {};
  bytes.Copy(0, 0, &grid);
  if (grid.mMagic != NANOVDB_MAGIC_NUMBER) bytes.Refuse("no grid where the file announces one");
  const glm::dmat4 toObject = ToAffine(grid.mMap);
  const double determinant = glm::determinant(glm::dmat3(toObject));
  if (!std::isfinite(determinant) || determinant == 0 ||
      !std::isfinite(glm::dot(toObject[3], toObject[3])))
    bytes.Refuse("a grid's place in space is not sound");
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

bool IsRead(nanovdb::GridType type) {
  return type == nanovdb::GridType::Float || type == nanovdb::GridType::Fp4 ||
         type == nanovdb::GridType::Fp8 || type == nanovdb::GridType::Fp16;
}

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
    if (header.codec != nanovdb::io::Codec::NONE)
      whole.Refuse("the file is compressed", "convert it without a codec");
    at += sizeof header;
    std::vector<std::pair<std::uint64_t, bool>> grids;  // sizes, and whether it is the one
    for (int i = 0; i < header.gridCount; ++i) {
      Raw<nanovdb::io::MetaData> raw;
      whole.Require(at, 1, sizeof(nanovdb::io::MetaData));
      whole.Copy(at, 0, &raw.get());
      const nanovdb::io::MetaData& about = raw.get();
      at += sizeof(nanovdb::io::MetaData);
      whole.Require(at, about.nameSize, 1);
      const std::string_view called(bytes.data() + at, std::max(about.nameSize, 1u) - 1);
      at += about.nameSize;
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", called);
      grids.emplace_back(about.fileSize, name.empty() ? IsRead(about.gridType) : called == name);
    }
    for (const auto& [size, isIt] : grids) {
      whole.Require(at, size, 1);
      if (isIt) return ReadGrid(GridBytes(std::string_view(bytes).substr(at, size), file));
      at += size;
    }
  }
  if (name.empty()) whole.Refuse("the file has no grid of numbers");
  whole.Refuse(fmt::format("there is no grid called '{}'", name), "there are " + names);
}

}  // namespace snell::io
