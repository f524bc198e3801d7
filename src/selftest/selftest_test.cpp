// SPDX-License-Identifier: Apache-2.0
//
// Every group of oracles, as a test of its own; and that wrong numbers would be noticed.
#include "selftest/selftest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "selftest/bodies.h"
#include "selftest/densities.h"

namespace snell::selftest {

void PrintTo(const Group& group, std::ostream* out) { *out << group.name; }

namespace {

class Oracles : public testing::TestWithParam<Group> {};

TEST_P(Oracles, Hold) {
  int count = 0;
  GetParam().run([&](const Check& check) {
    ++count;
    EXPECT_EQ(check.group, GetParam().name);
    EXPECT_TRUE(check.passed) << check.name << ": " << check.measured << " is not "
                              << check.expected << " ± " << check.tolerance;
  });
  EXPECT_GT(count, 3);
}

INSTANTIATE_TEST_SUITE_P(Of, Oracles, testing::ValuesIn(Groups()),
                         [](const auto& group) { return std::string(group.param.name); });

TEST(Check, FailsBeyondItsTolerance) {
  EXPECT_TRUE(Near("group", "name", 1.001, 1, 0.002).passed);
  EXPECT_FALSE(Near("group", "name", 1.003, 1, 0.002).passed);
  EXPECT_FALSE(Near("group", "name", std::nan(""), 1, 0.002).passed);
  EXPECT_TRUE(Likely("group", "name", 0.3, 1e-4).passed);
  EXPECT_TRUE(Likely("group", "name", 1, 1e-4).passed);
  EXPECT_FALSE(Likely("group", "name", 1e-5, 1e-4).passed);
}

// Directions that are uniform over a hemisphere, against their density and against that by the cosine.
TEST(PValueOfDirections, TellsRightFromWrong) {
  const DirectionSampler sample = [](uint i) {
    const vec2 u = RandomPoint(i, 1);
    return std::optional(DirectionAt(u.x, 2 * kernel::Pi * u.y));
  };
  const auto uniform = [](vec3 w) { return w.z > 0 ? 0.5 / double(kernel::Pi) : 0; };
  const auto byCosine = [](vec3 w) { return double(std::max(w.z, 0.0f) * kernel::InvPi); };
  const auto slightlyTilted = [&](vec3 w) { return uniform(w) * (1 + 0.2 * double(w.x)); };
  EXPECT_GT(PValueOfDirections({}, sample, uniform), 1e-3);
  EXPECT_LT(PValueOfDirections({}, sample, byCosine), 1e-9);
  EXPECT_LT(PValueOfDirections({}, sample, slightlyTilted), 1e-4);
  EXPECT_EQ(PValueOfDirections({}, sample, [&](vec3 w) { return 2 * uniform(w); }), 0);
}

}  // namespace
}  // namespace snell::selftest
