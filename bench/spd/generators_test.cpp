// SPDX-License-Identifier: Apache-2.0
//
// What holds for all standard databases: as many primitives and lights as were published, the view of the
// published counts, and nothing that our own NFF reader would object to.
#include "spd/generators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/nff/nff.h"
#include "spd/print_database.h"

namespace snell::spd {
namespace {

scene::Scene Read(const std::string& text) {
  return io::ParseNff(text, "test.nff", [](const Diagnostic& diagnostic) {
    ADD_FAILURE() << "unexpected warning: " << ToString(diagnostic);
  });
}

// How many lines begin with an entity's keyword.
int Count(const std::string& text, const std::string& keyword) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find("\n" + keyword + " ", at)) != std::string::npos; ++at)
    ++count;
  return count;
}

class EachDatabase : public testing::TestWithParam<Database> {};

TEST_P(EachDatabase, HasThePublishedCounts) {
  const Database& database = GetParam();
  const std::string text = database.generate(database.usualSize);
  const int primitives = Count(text, "s") + Count(text, "c") + Count(text, "p") + Count(text, "pp");
  EXPECT_EQ(primitives, database.published.primitives);
  EXPECT_EQ(Count(text, "l"), database.published.lights);
}

TEST_P(EachDatabase, IsReadWithoutWarnings) {
  const Database& database = GetParam();
  const scene::Scene scene = Read(database.generate(std::min(database.usualSize, 5)));
  EXPECT_EQ(int(scene.lights.size()), database.published.lights);
  EXPECT_EQ(scene.environment.top, scene::Spectrum(0.078f, 0.361f, 0.753f));
  EXPECT_EQ(scene.settings.width, 513);
  EXPECT_EQ(scene.settings.height, 513);
  EXPECT_EQ(scene.settings.maxDepth, 5);
  ASSERT_EQ(scene.cameras.size(), 1u);

  // 45° lie between the middles of the first and last of 512 rows; the outermost two of the 513 rays lie
  // half a row beyond them, and half a row within the edges of the image
  const double row = 2 * std::tan(std::numbers::pi / 8) / 511;
  EXPECT_NEAR(2 * std::tan(0.5 * double(scene.cameras[0].fov)), 513 * row, 1e-6);
}

TEST_P(EachDatabase, ReflectsAndRefractsIfTheCountsSayThatItDoes) {
  const scene::Scene scene = Read(GetParam().generate(2));
  const bool reflects = std::ranges::any_of(scene.materials, [](const scene::Material& material) {
    return material.reflectivity.value != scene::Spectrum(0.0f) || material.Refractive();
  });
  const bool refracts = std::ranges::any_of(scene.materials, &scene::Material::Refractive);
  EXPECT_EQ(reflects, GetParam().published.reflectedRays > 0);
  EXPECT_EQ(refracts, GetParam().published.refractedRays > 0);
}

TEST_P(EachDatabase, RefusesSizesOutOfRange) {
  EXPECT_THROW(GetParam().generate(0), Error);
  EXPECT_THROW(GetParam().generate(-1), Error);
  EXPECT_THROW(GetParam().generate(GetParam().largestSize + 1), Error);
  EXPECT_NO_THROW(GetParam().generate(1));
}

INSTANTIATE_TEST_SUITE_P(Spd, EachDatabase, testing::ValuesIn(Databases()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Spd, CountsFollowTheSize) {
  EXPECT_EQ(Count(Balls(2), "s"), 91);
  EXPECT_EQ(Count(Gears(2), "p"), 8 * 146 + 1);
  EXPECT_EQ(Count(Mount(3), "p"), 128);
  EXPECT_EQ(Count(Rings(3), "c"), 420);
  EXPECT_EQ(Count(Tetra(3), "p"), 64);
  EXPECT_EQ(Count(Tree(3), "c"), 15);
  for (const int n : {2, 3, 5}) {
    EXPECT_EQ(Count(Teapot(n), "pp"), 64 * n * n - 8 * n);
    EXPECT_EQ(Count(Teapot(n), "p"), n * n);
  }
}

TEST(Spd, DatabasesAreFoundByName) {
  EXPECT_EQ(DatabaseNamed("tetra").generate, Tetra);
  try {
    DatabaseNamed("teapott");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "there is no database 'teapott'; did you mean 'teapot'?");
  }
}

}  // namespace
}  // namespace snell::spd
