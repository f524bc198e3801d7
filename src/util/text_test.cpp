// SPDX-License-Identifier: Apache-2.0
#include "util/text.h"

#include <gtest/gtest.h>

#include <limits>

#include "util/check.h"
#include "util/error.h"
#include "util/timer.h"

namespace snell {
namespace {

TEST(NearestWord, FindsWordsThatWereMistyped) {
  const std::vector<std::string> words = {"radius", "position", "direction", "color", "up"};
  EXPECT_EQ(NearestWord("radios", words), "radius");
  EXPECT_EQ(NearestWord("raduis", words), "radius");
  EXPECT_EQ(NearestWord("colour", words), "color");
  EXPECT_EQ(NearestWord("postion", words), "position");
  EXPECT_EQ(NearestWord("radius", words), "radius");
  EXPECT_EQ(NearestWord("pu", words), "up");
}

TEST(NearestWord, IsSilentAboutOthers) {
  const std::vector<std::string> words = {"radius", "position"};
  EXPECT_EQ(NearestWord("transparency", words), "");
  EXPECT_EQ(NearestWord("", words), "");
  EXPECT_EQ(NearestWord("radius", {}), "");
  EXPECT_EQ(NearestWord(std::string(1000, 'x'), words), "");
}

TEST(NearestWord, CountsASwapAsOneAndTakesTheFirstOfEquals) {
  // Three letters allow a distance of two: a swap is one, two replacements are two
  EXPECT_EQ(NearestWord("abc", {"axy", "acb"}), "acb");
  EXPECT_EQ(NearestWord("abc", {"abd", "abe"}), "abd");
}

TEST(DidYouMean, IsAHintOrNothing) {
  EXPECT_EQ(DidYouMean("radios", {"radius"}), "did you mean 'radius'?");
  EXPECT_EQ(DidYouMean("qqqqqqqq", {"radius"}), "");
}

TEST(WithCommas, PartsThousands) {
  EXPECT_EQ(WithCommas(0), "0");
  EXPECT_EQ(WithCommas(999), "999");
  EXPECT_EQ(WithCommas(1000), "1,000");
  EXPECT_EQ(WithCommas(1234567), "1,234,567");
  EXPECT_EQ(WithCommas(std::numeric_limits<std::uint64_t>::max()), "18,446,744,073,709,551,615");
}

TEST(ByteSize, HasOneDigitAfterThePoint) {
  EXPECT_EQ(ByteSize(0), "0 B");
  EXPECT_EQ(ByteSize(1023), "1023 B");
  EXPECT_EQ(ByteSize(1024), "1.0 KiB");
  EXPECT_EQ(ByteSize(1536), "1.5 KiB");
  EXPECT_EQ(ByteSize(std::uint64_t(3) << 30), "3.0 GiB");
  EXPECT_EQ(ByteSize(std::numeric_limits<std::uint64_t>::max()), "16777216.0 TiB");
  // Rounding must not reach the next unit's size
  EXPECT_EQ(ByteSize((1 << 20) - 1), "1.0 MiB");
  EXPECT_EQ(ByteSize(1023 * 1024 + 900), "1023.9 KiB");
}

TEST(Duration, ChangesItsFormWithLength) {
  EXPECT_EQ(Duration(0), "0.00 s");
  EXPECT_EQ(Duration(0.5), "0.50 s");
  EXPECT_EQ(Duration(12.3), "12.3 s");
  EXPECT_EQ(Duration(75.25), "1:15");
  EXPECT_EQ(Duration(3599.4), "59:59");
  EXPECT_EQ(Duration(4000), "1:06:40");
  EXPECT_EQ(Duration(360000), "100:00:00");
  // Rounding must not reach the next form
  EXPECT_EQ(Duration(9.999), "10.0 s");
  EXPECT_EQ(Duration(59.97), "1:00");
  EXPECT_EQ(Duration(3599.6), "1:00:00");
}

TEST(Plural, OfRegularNouns) {
  EXPECT_EQ(Plural(1, "light"), "1 light");
  EXPECT_EQ(Plural(0, "light"), "0 lights");
  EXPECT_EQ(Plural(1000, "light"), "1,000 lights");
  EXPECT_EQ(Plural(1, "branch"), "1 branch");
  EXPECT_EQ(Plural(2, "branch"), "2 branches");
  EXPECT_EQ(Plural(2, "mesh"), "2 meshes");
  EXPECT_EQ(Plural(2, "box"), "2 boxes");
  EXPECT_EQ(Plural(2, "radius"), "2 radiuses");
}

TEST(Place, IsWrittenAsEditorsReadIt) {
  EXPECT_EQ(ToString(Place{}), "");
  EXPECT_EQ(ToString(Place{"a.toml"}), "a.toml");
  EXPECT_EQ(ToString(Place{"a.toml", 12}), "a.toml:12");
  EXPECT_EQ(ToString(Place{"a.toml", 12, 9}), "a.toml:12:9");
  EXPECT_EQ(ToString(Place{"a.ply", 0, 0, 4711}), "a.ply, byte 4711");
  EXPECT_EQ(ToString(Place{"a.ply", 0, 0, 0}), "a.ply, byte 0");
}

TEST(Error, HoldsALinePerDiagnostic) {
  EXPECT_STREQ(Error("bad").what(), "bad");
  EXPECT_STREQ(Error("bad", {"a.toml", 3, 4}, "do good").what(), "a.toml:3:4: bad; do good");
  const Error two({{"one", {"a"}}, {"two", {}, "hint"}});
  EXPECT_STREQ(two.what(), "a: one\ntwo; hint");
  EXPECT_EQ(two.diagnostics().size(), 2u);
}

TEST(CheckDeathTest, SaysWhereAndInWhatContext) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto describe = [](const void* data, char* text, int size) {
    std::snprintf(text, std::size_t(size), "in %s", static_cast<const char*>(data));
  };
  EXPECT_DEATH(CHECK(1 + 1 == 3), "text_test.cpp:[0-9]+: check failed: 1 \\+ 1 == 3");
  EXPECT_DEATH(
      {
        const CheckContext outer(describe, "the outer");
        const CheckContext inner(describe, "the inner");
        CHECK(false);
      },
      "check failed: false\nin the inner\n");
  EXPECT_DEATH(
      {
        const CheckContext outer(describe, "the outer");
        { const CheckContext inner(describe, "the inner"); }
        CHECK(false);
      },
      "in the outer\n");
  CHECK(true);
}

TEST(Memory, IsTold) {
  EXPECT_GT(PeakMemoryBytes(), 100000u);
#ifdef __linux__
  EXPECT_GT(AvailableMemoryBytes(), 1000000u);
#endif
  const Timer timer;
  const double first = timer.Seconds();
  EXPECT_GE(first, 0);
  EXPECT_GE(timer.Seconds(), first);
}

}  // namespace
}  // namespace snell
