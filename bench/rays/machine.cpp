// SPDX-License-Identifier: Apache-2.0
#include "rays/machine.h"

#include <fmt/format.h>

#include <fstream>

#include "bvh/instruction_set.h"
#include "rays/contestant.h"
#include "util/text.h"
#include "util/threads.h"

namespace snell::bench {

namespace {

std::string ProcessorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

// What __VERSION__ leaves out.
#ifdef __clang__
constexpr const char* Compiler = "";
#else
constexpr const char* Compiler = "GCC ";
#endif

}  // namespace

std::string DescribeMachine() {
  return fmt::format("{}, {}; Snell with {}; Embree {}; {}{}", ProcessorName(),
                     Plural(std::uint64_t(HardwareThreads()), "thread"),
                     bvh::NameOf(bvh::BestInstructionSet()), EmbreeVersion(), Compiler,
                     __VERSION__);
}

}  // namespace snell::bench
