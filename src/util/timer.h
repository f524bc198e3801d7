// SPDX-License-Identifier: Apache-2.0
//
// Wall-clock time, and the memory that this process has taken and could take.
#pragma once

#include <chrono>
#include <cstdint>

namespace snell {

// Seconds since construction, by a monotonic clock.
class Timer {
 public:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Largest resident memory of this process so far, in bytes; 0 where the system does not tell.
std::uint64_t PeakMemoryBytes();

// Memory that can still be taken without swapping, in bytes; 0 where the system does not tell.
std::uint64_t AvailableMemoryBytes();

}  // namespace snell
