// SPDX-License-Identifier: Apache-2.0
//
// Photometric files: the planes that symmetry adds, the axes of all types, what is multiplied, and one error at its line
// for what is no such file.
#include "io/ies/ies.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "util/error.h"

namespace snell::io {
namespace {

using scene::LightProfile;

constexpr double Degree = std::numbers::pi / 180;

std::string File(const std::string& counts, const std::string& angles, const std::string& candela) {
  return fmt::format("IESNA:LM-63-2002\n[TEST] 7\nTILT=NONE\n1 -1 {} 2 0 0 0\n1 1 10\n{}\n{}\n",
                     counts, angles, candela);
}

// The candela at a measured or added angle, in degrees.
double At(const LightProfile& profile, double vertical, double horizontal) {
  for (std::size_t h = 0; h < profile.horizontals.size(); ++h) {
    if (std::abs(double(profile.horizontals[h]) - horizontal * Degree) > 1e-5) continue;
    for (std::size_t v = 0; v < profile.verticals.size(); ++v) {
      if (std::abs(double(profile.verticals[v]) - vertical * Degree) < 1e-5)
        return 683 * double(profile.intensities[h * profile.verticals.size() + v]);
    }
  }
  return -1;
}

TEST(Ies, SymmetryGivesThePlanesThatAreNotMeasured) {
  const LightProfile one = ReadIes(File("1 3 1 1", "0 45 90 0", "30 20 10"), "f");
  EXPECT_EQ(one.horizontals.size(), 1u);
  EXPECT_NEAR(At(one, 45, 0), 20, 1e-4);

  const LightProfile quarter = ReadIes(File("1 2 3 1", "0 90 0 30 90", "1 2 3 4 5 6"), "f");
  for (const double angle : {30, 150, 210, 330}) EXPECT_NEAR(At(quarter, 90, angle), 4, 1e-5);
  for (const double angle : {90, 270}) EXPECT_NEAR(At(quarter, 90, angle), 6, 1e-5);
  for (const double angle : {0, 180, 360}) EXPECT_NEAR(At(quarter, 0, angle), 1, 1e-5);

  const LightProfile half = ReadIes(File("1 2 3 1", "0 90 0 60 180", "1 2 3 4 5 6"), "f");
  for (const double angle : {60, 300}) EXPECT_NEAR(At(half, 90, angle), 4, 1e-5);
  EXPECT_NEAR(At(half, 90, 180), 6, 1e-5);

  const LightProfile side = ReadIes(File("1 2 3 1", "0 90 90 200 270", "1 2 3 4 5 6"), "f");
  for (const double angle : {200, 340}) EXPECT_NEAR(At(side, 90, angle), 4, 1e-5);
  EXPECT_NEAR(At(side, 90, 0), 2 + 2 * 90.0 / 110, 1e-5);

  const LightProfile open = ReadIes(File("1 2 4 1", "0 90 0 90 180 290", "1 2 3 4 5 6 7 8"), "f");
  EXPECT_NEAR(At(open, 90, 290), 8, 1e-5);
  EXPECT_NEAR(At(open, 90, 360), 2, 1e-5);
}

TEST(Ies, FactorsMultiplyTheCandela) {
  const std::string text =
      "a lamp\r\nTILT=INCLUDE\r\n1\r\n2\r\n0 90\r\n1 0.5\r\n1,1000,2,2,1,1,1,0,0,0\r\n0.5 0.8 "
      "9\r\n0 180\r\n0\r\n10 20";
  EXPECT_NEAR(At(ReadIes(text, "f"), 180, 0), 16, 1e-4);
}

// Ahead is the vertical angle 0; a profile's horizontal angle 0 is to the right and 90° up.
TEST(Ies, TypesAAndBCountFromAhead) {
  const std::string angles = "-60 0 60 -60 0 60", candela = "1 2 3 4 5 6 7 8 9";
  for (const char* type : {"2", "3"}) {
    const LightProfile profile = ReadIes(File(fmt::format("1 3 3 {}", type), angles, candela), "f");
    EXPECT_NEAR(At(profile, 0, 0), 5, 1e-4);
    EXPECT_NEAR(At(profile, 30, 0), 6.5, 1e-4);
    EXPECT_NEAR(At(profile, 30, 90), 5.5, 1e-4);
    EXPECT_NEAR(At(profile, 30, 180), 3.5, 1e-4);
    EXPECT_EQ(At(profile, 80, 90), 0);
  }
  // By their vertical angles
  const LightProfile b = ReadIes(File("1 2 2 2", "0 90 0 90", "0 90 0 90"), "f");
  const LightProfile a = ReadIes(File("1 2 2 3", "0 90 0 90", "0 90 0 90"), "f");
  EXPECT_NEAR(At(b, 45, 90), 45, 1e-3);
  EXPECT_NEAR(At(a, 45, 90), 45, 1e-3);
  EXPECT_NEAR(At(b, 60, 46), std::atan2(std::sin(46 * Degree) * std::tan(60 * Degree), 1) / Degree,
              1e-3);
  EXPECT_NEAR(At(a, 60, 46), std::asin(std::sin(46 * Degree) * std::sin(60 * Degree)) / Degree,
              1e-3);
}

void ExpectError(const std::string& text, const char* message, int line) {
  try {
    ReadIes(text, "lamp.ies");
    ADD_FAILURE() << "no error: " << message;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    EXPECT_EQ(error.diagnostics().front().place.line, line) << error.what();
  }
}

TEST(Ies, OtherFilesGiveAnErrorAtItsLine) {
  ExpectError("", "no IES file", 1);
  ExpectError("a\nb\n", "no line TILT=", 2);
  ExpectError("a\nTILT=other.tlt\n", "in another file", 2);
  ExpectError("TILT=NONE\n1 1 1 x", "a number is missing: the number of vertical angles", 2);
  ExpectError("TILT=NONE\n1 1 1 999999999 999999999", "cannot be 1e+09", 2);
  ExpectError(File("1 2 1 1", "0 90 0", "1"), "the file ends before the candela", 8);
  ExpectError(File("1 2 1 1", "90 0 0", "1 2"), "vertical angles do not rise", 6);
  ExpectError(File("1 2 1 1", "0 270 0", "1 2"), "between 0 and 180", 7);
  ExpectError(File("1 2 2 1", "0 90 0 120", "1 2 3 4"), "from 0 to 120", 7);
  ExpectError(File("1 2 1 4", "0 90 0", "1 2"), "type 4 is not known", 7);
  ExpectError(File("1 2 1 1", "0 90 0", "1 nan"), "a number is missing", 7);
}

}  // namespace
}  // namespace snell::io
