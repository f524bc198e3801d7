// SPDX-License-Identifier: Apache-2.0
#include "util/timer.h"

#include <sys/resource.h>

#include <fstream>
#include <string>

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

std::uint64_t AvailableMemoryBytes() {
  std::ifstream table("/proc/meminfo");
  std::string key;
  while (table >> key) {
    if (key == "MemAvailable:") {
      std::uint64_t kibibytes = 0;
      table >> kibibytes;
      return kibibytes * 1024;
    }
    std::getline(table, key);
  }
  return 0;
}

}  // namespace snell
