// SPDX-License-Identifier: Apache-2.0
//
// How many threads work, and a parallel loop over numbered items in order of their numbers.
#pragma once

#include <cstdint>
#include <functional>

namespace snell {

// Processors that this process may use.
int HardwareThreads();

// Threads that parallel work of this process runs on at present.
int ActiveThreads();

// Limits the parallel work of this process to `count` threads while it lives; 0 means all processors.
class ThreadLimit {
 public:
  explicit ThreadLimit(int count);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

  int count() const { return count_; }

 private:
  int count_;
  void* control_;
};

// Run `body(item, worker)` for item = 0 … count−1 on all threads. Items start in rising order; `worker`
// is a number below HardwareThreads() that no other running body has. Exceptions from a body stop the
// loop and are rethrown here.
void ParallelInOrder(std::uint64_t count,
                     const std::function<void(std::uint64_t item, int worker)>& body);

}  // namespace snell
