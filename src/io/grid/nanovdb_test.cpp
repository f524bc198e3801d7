// SPDX-License-Identifier: Apache-2.0
//
// NanoVDB files: values come back where they were put, in all kinds that are read, also where one value stands for many;
// whatever else is in a file gives one error.
#include "io/grid/nanovdb.h"

#include <gtest/gtest.h>
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
std::string Written(const nanovdb::GridHandle<>& handle) {
  const test::ScratchFolder folder;
  nanovdb::io::writeGrid(folder.Path("grid.nvdb"), handle);
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
std::string Scattered(nanovdb::GridClass kind = nanovdb::GridClass::FogVolume) {
  nanovdb::GridBuilder<float, Build> builder(0.0f, kind);
  auto accessor = builder.getAccessor();
  for (int i = 0; i < 40; ++i) accessor.setValue(Coord(i - 20, 3 * i - 60, 7), 0.5f + float(i));
  return Written(builder.getHandle(0.5, nanovdb::Vec3d(1, 2, 3), "smoke"));
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
  for (const float value : grid.values) sum += double(value);
  EXPECT_NEAR(sum, 4.18879 * 58.5 * 58.5 * 58.5, 0.01 * sum);
  EXPECT_EQ(ValueAt(grid, {0, 0, 0}), 1);
  EXPECT_EQ(ValueAt(grid, {40, -30, 20}), 1);
  EXPECT_EQ(ValueAt(grid, {62, 0, 0}), 0);
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
