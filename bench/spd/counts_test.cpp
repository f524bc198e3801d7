// SPDX-License-Identifier: Apache-2.0
//
// The published numbers of rays, "within about 10 %" of which every classic ray tracer should be: ours are
// within 4 %, and where nothing is a matter of taste (which rays meet which surfaces) within 1 %.
#include "spd/counts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

namespace snell::spd {

// What test lists show.
void PrintTo(const Database& database, std::ostream* out) { *out << database.name; }

namespace {

class RaysOf : public testing::TestWithParam<Database> {};

TEST_P(RaysOf, AreAsManyAsPublished) {
  // A third of the published side: a ninth of the rays
  const RayCounts counts = CountRays(GetParam(), 171);
  const Published& published = GetParam().published;
  EXPECT_EQ(counts.eye, 171 * 171);
  EXPECT_NEAR(double(counts.reflected), double(published.reflectedRays) / 9,
              0.015 * double(published.reflectedRays) / 9);
  EXPECT_NEAR(double(counts.refracted), double(published.refractedRays) / 9,
              0.05 * double(published.refractedRays) / 9);
  EXPECT_NEAR(double(counts.shadow), double(published.shadowRays) / 9,
              0.02 * double(published.shadowRays) / 9);
}

INSTANTIATE_TEST_SUITE_P(Spd, RaysOf, testing::ValuesIn(Databases()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace snell::spd
