// SPDX-License-Identifier: Apache-2.0
#include "bvh/instruction_set.h"

#include <algorithm>
#include <cstdlib>

namespace snell::bvh {

namespace portable {
extern const Traversal traversal;
}
#ifdef __x86_64__
namespace sse42 {
extern const Traversal traversal;
}
namespace avx2 {
extern const Traversal traversal;
}
namespace avx512 {
extern const Traversal traversal;
}
#endif

namespace {

struct Entry {
  InstructionSet set;
  std::string_view name;
  std::string_view key;  // in SNELL_ISA
  const Traversal* traversal;
};

constexpr Entry Entries[] = {
    {InstructionSet::Portable, "portable", "portable", &portable::traversal},
#ifdef __x86_64__
    {InstructionSet::Sse42, "SSE4.2", "sse4.2", &sse42::traversal},
    {InstructionSet::Avx2, "AVX2", "avx2", &avx2::traversal},
    {InstructionSet::Avx512, "AVX-512", "avx512", &avx512::traversal},
#endif
};

const Entry* Find(InstructionSet set) {
  return std::find_if(std::begin(Entries), std::end(Entries),
                      [&](const Entry& e) { return e.set == set; });
}

bool ProcessorRuns(InstructionSet set) {
#ifdef __x86_64__
  switch (set) {
    case InstructionSet::Portable: return true;
    case InstructionSet::Sse42: return __builtin_cpu_supports("sse4.2");
    case InstructionSet::Avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
             __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    case InstructionSet::Avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
             ProcessorRuns(InstructionSet::Avx2);
  }
#endif
  return set == InstructionSet::Portable;
}

}  // namespace

std::string_view NameOf(InstructionSet set) {
  const Entry* entry = Find(set);
  return entry == std::end(Entries) ? "?" : entry->name;
}

const std::vector<InstructionSet>& SupportedInstructionSets() {
  static const std::vector<InstructionSet> supported = [] {
    std::vector<InstructionSet> sets;
    for (const Entry& entry : Entries) {
      if (ProcessorRuns(entry.set)) sets.push_back(entry.set);
    }
    return sets;
  }();
  return supported;
}

InstructionSet BestInstructionSet() {
  const std::vector<InstructionSet>& supported = SupportedInstructionSets();
  if (const char* wanted = std::getenv("SNELL_ISA")) {
    for (const InstructionSet set : supported) {
      if (Find(set)->key == wanted) return set;
    }
  }
  return supported.back();
}

const Traversal& TraversalFor(InstructionSet set) { return *Find(set)->traversal; }

}  // namespace snell::bvh
