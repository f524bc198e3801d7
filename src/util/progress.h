// SPDX-License-Identifier: Apache-2.0
//
// The seam between long work and whoever watches it: phases, a fraction, and the wish to stop.
#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>

namespace snell {

// Where long work reports to. Implementations must be thread-safe: Update is called by worker threads.
class Progress {
 public:
  virtual ~Progress() = default;

  // A phase begins ("loading", "building", "rendering"); `total` counts its steps, 0 if unknown.
  virtual void Begin(std::string_view phase, std::uint64_t total) = 0;
  // `done` of the phase's steps are done; `rays` have been traced so far in this phase.
  virtual void Update(std::uint64_t done, std::uint64_t rays) = 0;
  virtual void End() = 0;
};

// A wish to stop early that any thread, or a signal handler, may raise.
class StopFlag {
 public:
  void Raise() { raised_.store(true, std::memory_order_relaxed); }
  bool raised() const { return raised_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> raised_{false};
  static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers raise it");
};

}  // namespace snell
