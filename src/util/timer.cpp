// SPDX-License-Identifier: Apache-2.0
#include "util/timer.h"

#include <sys/resource.h>

namespace snell {

std::uint64_t PeakMemoryBytes() {
  rusage usage = {};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
  return std::uint64_t(usage.ru_maxrss);
#else
  return std::uint64_t(usage.ru_maxrss) * 1024;
#endif
}

}  // namespace snell
