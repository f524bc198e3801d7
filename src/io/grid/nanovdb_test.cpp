// SPDX-License-Identifier: Apache-2.0
//
// NanoVDB files: values come back where they were put, in all kinds that are read, also where one value stands for many;
// whatever else is in a file gives one error.
#include "io/grid/nanovdb.h"

#include <gtest/gtest.h>
#define NANOVDB_USE_ZIP
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>
#include <nanovdb/util/Primitives.h>

#include <glm/matrix.hpp>

#include "support/random.h"
#include "support/scratch_folder.h"
#include "util/error.h"

namespace snell::io {
namespace {

using nanovdb::Coord;
using scene::DensityGrid;

// The bytes of a file with this grid.
std::string Written(const nanovdb::GridHandle<>& handle,
                    nanovdb::io::Codec codec = nanovdb::io::Codec::NONE) {
  const test::ScratchFolder folder;
  nanovdb::io::writeGrid(folder.Path("grid.nvdb"), handle, codec);
  return folder.Read("grid.nvdb");
}

float ValueAt(const DensityGrid& grid, glm::dvec3 p) {
  const glm::dvec3 q(glm::inverse(grid.toObject) * glm::dvec4(p, 1.0));
  const glm::ivec3 at(glm::round(q));
  const glm::uvec3 brick(at / 8);
  if (at.x < 0 || at.y < 0 || at.z < 0 || brick.x >= grid.bricks.x || brick.y >= grid.bricks.y ||
      brick.z >= grid.bricks.z)
    return 0;
  const int number = grid.table[(brick.z * grid.bricks.y + brick.y) * grid.bricks.x + brick.x];
  if (number < 0) return 0;
  return grid
      .values[std::size_t(number) * 512 + std::size_t((at.x % 8 * 8 + at.y % 8) * 8 + at.z % 8)];
}

// Values here and there, on both sides of the origin.
template <class Build>
std::string Scattered(nanovdb::GridClass kind = nanovdb::GridClass::FogVolume,
                      nanovdb::io::Codec codec = nanovdb::io::Codec::NONE) {
  nanovdb::GridBuilder<float, Build> builder(0.0f, kind);
  auto accessor = builder.getAccessor();
  for (int i = 0; i < 40; ++i) accessor.setValue(Coord(i - 20, 3 * i - 60, 7), 0.5f + float(i));
  return Written(builder.getHandle(0.5, nanovdb::Vec3d(1, 2, 3), "smoke"), codec);
}

TEST(NanoVdb, ValuesComeBackWhereTheyWerePut) {
  const DensityGrid grids[] = {ReadNanoVdb(Scattered<float>(), "f", ""),
                               ReadNanoVdb(Scattered<nanovdb::Fp16>(), "f", "smoke"),
                               ReadNanoVdb(Scattered<nanovdb::Fp8>(), "f", "")};
  const float tolerances[] = {0, 1e-3f, 0.2f};
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 40; ++i) {
      const glm::dvec3 p(1 + 0.5 * (i - 20), 2 + 0.5 * (3 * i - 60), 3 + 0.5 * 7);
      EXPECT_NEAR(ValueAt(grids[k], p), 0.5f + float(i), tolerances[k]);
      EXPECT_NEAR(ValueAt(grids[k], p + glm::dvec3(0, 0, 0.5)), 0, tolerances[k]);
    }
  }
}

// The inside of a ball is kept as a few values for many points.
TEST(NanoVdb, BallsAreFull) {
  const DensityGrid grid = ReadNanoVdb(
      Written(nanovdb::createFogVolumeSphere<float>(60.0f, nanovdb::Vec3f(0), 1.0, 3.0)), "f", "");
  double sum = 0;
  for (const int brick : grid.table) {
    for (int i = 0; brick >= 0 && i < 512; ++i)
      sum += double(grid.values[std::size_t(brick * 512 + i)]);
  }
  EXPECT_LT(grid.values.size() / 512, grid.table.size() / 2) << "bricks of one value are shared";
  EXPECT_NEAR(sum, 4.18879 * 58.5 * 58.5 * 58.5, 0.01 * sum);
  EXPECT_EQ(ValueAt(grid, {0, 0, 0}), 1);
  EXPECT_EQ(ValueAt(grid, {40, -30, 20}), 1);
  EXPECT_EQ(ValueAt(grid, {62, 0, 0}), 0);
}

TEST(NanoVdb, CompressedFilesAreTheSame) {
  const std::string plain = Scattered<float>();
  const std::string zip = Scattered<float>(nanovdb::GridClass::FogVolume, nanovdb::io::Codec::ZIP);
  EXPECT_LT(zip.size(), plain.size() / 8);
  const DensityGrid a = ReadNanoVdb(plain, "f", ""), b = ReadNanoVdb(zip, "f", "");
  EXPECT_EQ(a.table, b.table);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.toObject, b.toObject);
}

void ExpectError(const std::string& bytes, const std::string& name, const char* message) {
  try {
    ReadNanoVdb(bytes, "file.nvdb", name);
    ADD_FAILURE() << "no error: " << message;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(NanoVdb, OtherFilesGiveAnError) {
  const std::string good = Scattered<float>();
  ExpectError("", "", "no grid of numbers");
  ExpectError("no grid at all, but as long as a header", "", "no NanoVDB file");
  ExpectError(good, "flame", "there is no grid called 'flame'");
  ExpectError(good.substr(0, good.size() / 2), "", "the file ends within a grid");
  ExpectError(Scattered<float>(nanovdb::GridClass::LevelSet), "", "level set");
  std::string packed = Scattered<float>(nanovdb::GridClass::FogVolume, nanovdb::io::Codec::ZIP);
  packed[packed.size() / 2] = char(packed[packed.size() / 2] + 1);
  ExpectError(packed, "", "damaged");
  packed[14] = 2;  // the codec: Blosc
  ExpectError(packed, "", "compressed by a codec that is not read");
  nanovdb::GridBuilder<nanovdb::Vec3f> vectors(nanovdb::Vec3f(0));
  vectors.getAccessor().setValue(Coord(0), nanovdb::Vec3f(1));
  ExpectError(Written(vectors.getHandle(1.0, nanovdb::Vec3d(0), "v")), "v", "not read");
}

// Damage gives a grid or one error, never a reading beyond the file's end.
TEST(NanoVdb, DamagedFilesGiveAGridOrAnError) {
  const std::string good = Scattered<float>();
  test::Random random(73);
  int errors = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::string bytes = good;
    // Most of what is not values stands at the beginning
    const std::size_t reach = trial % 2 == 0 ? 2048 : bytes.size();
    for (int i = 0; i < 3; ++i) bytes[random.Index(std::uint32_t(reach))] = char(random.Index(256));
    if (trial % 5 == 0) bytes.resize(random.Index(std::uint32_t(bytes.size())));
    try {
      const DensityGrid grid = ReadNanoVdb(bytes, "f", "");
      EXPECT_EQ(grid.table.size(), std::size_t(grid.bricks.x) * grid.bricks.y * grid.bricks.z);
    } catch (const Error&) {
      ++errors;
    }
  }
  EXPECT_GT(errors, 50);
}

}  // namespace
}  // namespace snell::io
