// SPDX-License-Identifier: Apache-2.0
//
// The stack of refractive objects around a point, against a list that does the same.
#include "kernel/medium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random.h"

namespace snell::kernel {
namespace {

TEST(MediumStack, BehavesLikeAList) {
  test::Random random(81);
  for (int trial = 0; trial < 2000; ++trial) {
    MediumStack media = NoMedia();
    std::vector<uint> list;
    for (int step = 0; step < 60; ++step) {
      const uint object = random.Index(12);
      if (random.Chance(0.6)) {
        media = EnterMedium(media, object);
        if (std::find(list.begin(), list.end(), object) == list.end()) {
          if (list.size() == MaxNestedMedia) list.erase(list.begin());
          list.push_back(object);
        }
      } else {
        media = LeaveMedium(media, object);
        std::erase(list, object);
      }
      ASSERT_EQ(media.count, list.size());
      for (uint i = 0; i < media.count; ++i) ASSERT_EQ(media.object[i], list[i]);
      for (uint o = 0; o < 12; ++o)
        ASSERT_EQ(IsInside(media, o), std::find(list.begin(), list.end(), o) != list.end());
    }
  }
}

TEST(MediumStack, StartsEmptyAndForgetsTheOutermostFirst) {
  MediumStack media = NoMedia();
  EXPECT_EQ(media.count, 0u);
  EXPECT_EQ(LeaveMedium(media, 3).count, 0u);
  for (uint i = 0; i < MaxNestedMedia + 2; ++i) media = EnterMedium(media, i);
  EXPECT_EQ(media.count, MaxNestedMedia);
  EXPECT_FALSE(IsInside(media, 1));
  EXPECT_TRUE(IsInside(media, 2));
  EXPECT_EQ(media.object[0], 2u);
  EXPECT_EQ(media.object[MaxNestedMedia - 1], MaxNestedMedia + 1);
}

}  // namespace
}  // namespace snell::kernel
