// SPDX-License-Identifier: Apache-2.0
#include "viewer/preferences.h"

#include <gtest/gtest.h>

#include "support/scratch_folder.h"

namespace snell::viewer {
namespace {

class Remembering : public testing::Test, protected test::ScratchFolder {};

TEST_F(Remembering, ReadsWhatItHasWritten) {
  const std::filesystem::path path = folder_ / "new" / "viewer.conf";
  WritePreferences(path, {false, false, 1000, 700});
  const Preferences read = ReadPreferences(path);
  EXPECT_FALSE(read.dark);
  EXPECT_FALSE(read.showsPanel);
  EXPECT_EQ(read.width, 1000);
  EXPECT_EQ(read.height, 700);
}

TEST_F(Remembering, TakesNoNonsense) {
  Write("viewer.conf", "dark = maybe\nwidth = -5\nheight = 99999999999\n\xff\n= 3\npanel=0\n");
  const Preferences read = ReadPreferences(folder_ / "viewer.conf");
  EXPECT_TRUE(read.dark);
  EXPECT_TRUE(read.showsPanel);
  EXPECT_EQ(read.width, Preferences{}.width);
  EXPECT_EQ(read.height, Preferences{}.height);
  EXPECT_EQ(ReadPreferences(folder_ / "none").width, Preferences{}.width);
}

}  // namespace
}  // namespace snell::viewer
