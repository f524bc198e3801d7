// SPDX-License-Identifier: Apache-2.0
//
// Work that may not survive its input, such as a library's that was not written for malformed files.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace snell::io {

struct TrialLimits {
  std::uint64_t bytes = 0;  // of memory beyond what is in use
  int seconds = 0;          // of processor time
};

// Do `work` in a process of its own, which ends with it. Returns what is wrong: the work's own words, that it
// crashed, or that it took too much; "" if all is well, so that it can be done again here.
std::string TryInProcess(const std::function<std::string()>& work, const TrialLimits& limits);

}  // namespace snell::io
