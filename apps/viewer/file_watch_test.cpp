// SPDX-License-Identifier: Apache-2.0
#include "viewer/file_watch.h"

#include <gtest/gtest.h>

#include "support/scratch_folder.h"

namespace snell::viewer {
namespace {

class Watching : public testing::Test, protected test::ScratchFolder {};

TEST_F(Watching, NoticesChangesThatHaveCometoRest) {
  Write("scene.toml", "a");
  FileWatch watch;
  watch.Watch(folder_ / "scene.toml");
  EXPECT_FALSE(watch.Changed());
  Write("scene.toml", "ab");
  EXPECT_FALSE(watch.Changed());  // it may go on
  EXPECT_TRUE(watch.Changed());
  EXPECT_FALSE(watch.Changed());
}

TEST_F(Watching, SeesPartsBesideTheSceneButNoPictures) {
  Write("scene.toml", "a");
  FileWatch watch;
  watch.Watch(folder_ / "scene.toml");
  Write("picture.png", "p");
  watch.Changed();
  EXPECT_FALSE(watch.Changed());
  Write("part.obj", "v 0 0 0");
  watch.Changed();
  EXPECT_TRUE(watch.Changed());
}

TEST_F(Watching, WaitsForASceneThatIsAwayForAMoment) {
  Write("scene.toml", "a");
  FileWatch watch;
  watch.Watch(folder_ / "scene.toml");
  std::filesystem::remove(folder_ / "scene.toml");
  watch.Changed();
  EXPECT_FALSE(watch.Changed());
  Write("scene.toml", "abc");
  watch.Changed();
  EXPECT_TRUE(watch.Changed());
}

}  // namespace
}  // namespace snell::viewer
