// SPDX-License-Identifier: Apache-2.0
#include "util/threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "util/error.h"

namespace snell {
namespace {

TEST(ParallelInOrder, DoesEveryItemOnce) {
  for (const int threads : {1, 2, 3, 0}) {
    const ThreadLimit limit(threads);
    for (const std::uint64_t count : {0, 1, 2, 3, 1000, 100000}) {
      const auto times = std::make_unique<std::atomic<int>[]>(count + 1);
      ParallelInOrder(count, [&](std::uint64_t item, int) { ++times[item]; });
      for (std::uint64_t i = 0; i < count; ++i) ASSERT_EQ(times[i], 1) << i;
    }
  }
}

TEST(ParallelInOrder, StartsItemsInRisingOrder) {
  {
    const ThreadLimit limit(1);
    std::vector<std::uint64_t> order;
    ParallelInOrder(1000, [&](std::uint64_t item, int) { order.push_back(item); });
    for (std::uint64_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
  }
  // With more threads each of them sees rising numbers
  const std::size_t workers = std::size_t(HardwareThreads());
  std::vector<std::vector<std::uint64_t>> seen(workers);
  ParallelInOrder(
      100000, [&](std::uint64_t item, int worker) { seen[std::size_t(worker)].push_back(item); });
  for (const auto& items : seen) EXPECT_TRUE(std::is_sorted(items.begin(), items.end()));
}

TEST(ParallelInOrder, GivesRunningBodiesDifferentWorkers) {
  const auto busy = std::make_unique<std::atomic<int>[]>(std::size_t(HardwareThreads()));
  std::atomic<int> faults{0};
  ParallelInOrder(20000, [&](std::uint64_t, int worker) {
    if (worker < 0 || worker >= HardwareThreads()) {
      ++faults;
      return;
    }
    if (busy[std::size_t(worker)]++ != 0) ++faults;
    std::this_thread::yield();
    --busy[std::size_t(worker)];
  });
  EXPECT_EQ(faults, 0);
}

TEST(ParallelInOrder, PassesExceptionsOnAndStops) {
  for (const int threads : {1, 2, 0}) {
    const ThreadLimit limit(threads);
    std::atomic<int> done{0};
    const auto body = [&](std::uint64_t item, int) {
      if (item == 10) throw Error("the tenth", {"a.toml", 1, 2});
      ++done;
    };
    try {
      ParallelInOrder(10000000, body);
      FAIL() << "nothing was thrown";
    } catch (const Error& error) {
      EXPECT_EQ(error.diagnostics().front().place.column, 2);
    }
    EXPECT_GE(done, 1);
    EXPECT_LT(done, 5000000);
  }
  // And works again afterwards
  std::atomic<int> done{0};
  ParallelInOrder(100, [&](std::uint64_t, int) { ++done; });
  EXPECT_EQ(done, 100);
}

TEST(ParallelInOrder, MayBeNested) {
  std::atomic<int> done{0};
  ParallelInOrder(
      10, [&](std::uint64_t, int) { ParallelInOrder(10, [&](std::uint64_t, int) { ++done; }); });
  EXPECT_EQ(done, 100);
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const int all = HardwareThreads();
  ASSERT_GE(all, 1);
  EXPECT_EQ(ActiveThreads(), all);
  {
    const ThreadLimit one(1);
    EXPECT_EQ(one.count(), 1);
    EXPECT_EQ(ActiveThreads(), 1);
    std::atomic<bool> otherThread{false};
    const std::thread::id here = std::this_thread::get_id();
    ParallelInOrder(1000, [&](std::uint64_t, int worker) {
      if (std::this_thread::get_id() != here || worker != 0) otherThread = true;
    });
    EXPECT_FALSE(otherThread);
    const ThreadLimit more(all);  // the lowest holds
    EXPECT_EQ(ActiveThreads(), 1);
  }
  EXPECT_EQ(ActiveThreads(), all);
  const ThreadLimit every(0);
  EXPECT_EQ(every.count(), all);
  const ThreadLimit many(1000);
  EXPECT_EQ(ActiveThreads(), all);
}

}  // namespace
}  // namespace snell
