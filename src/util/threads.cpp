// SPDX-License-Identifier: Apache-2.0
#include "util/threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace snell {

int HardwareThreads() { return std::max(1, tbb::info::default_concurrency()); }

int ActiveThreads() {
  const std::size_t allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return int(std::min(allowed, std::size_t(HardwareThreads())));
}

ThreadLimit::ThreadLimit(int count) : count_(count > 0 ? count : HardwareThreads()) {
  control_ =
      new tbb::global_control(tbb::global_control::max_allowed_parallelism, std::size_t(count_));
}

ThreadLimit::~ThreadLimit() { delete static_cast<tbb::global_control*>(control_); }

void ParallelInOrder(std::uint64_t count,
                     const std::function<void(std::uint64_t item, int worker)>& body) {
  const int workers = int(std::min(count, std::uint64_t(ActiveThreads())));
  std::atomic<std::uint64_t> next{0};
  std::atomic<bool> failed{false};
  tbb::parallel_for(
      0, workers,
      [&](int worker) {
        try {
          for (std::uint64_t item = next++; item < count && !failed; item = next++)
            body(item, worker);
        } catch (...) {
          failed = true;
          throw;
        }
      },
      tbb::simple_partitioner());
}

}  // namespace snell
