// SPDX-License-Identifier: Apache-2.0
//
// Every group of oracles, as a test of its own; and that wrong numbers would be noticed.
#include "selftest/selftest.h"

#include <gtest/gtest.h>

#include <cmath>

namespace snell::selftest {
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
  EXPECT_GT(count, 4);
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

}  // namespace
}  // namespace snell::selftest
