// SPDX-License-Identifier: Apache-2.0
#include "api/version.h"

#include "bvh/instruction_set.h"

namespace snell {

std::string Version() { return SNELL_VERSION; }

std::string BuildDescription() {
  std::string text;
#if defined(__clang__)
  text = "clang " __clang_version__;
#elif defined(__GNUC__)
  text = "gcc " __VERSION__;
#endif
#ifdef SNELL_DEBUG_CHECKS
  text += ", debug checks";
#endif
  return text;
}

std::vector<std::string> InstructionSets() {
  std::vector<std::string> names;
  for (const bvh::InstructionSet set : bvh::SupportedInstructionSets())
    names.emplace_back(bvh::NameOf(set));
  return names;
}

std::string ActiveInstructionSet() { return std::string(bvh::NameOf(bvh::BestInstructionSet())); }

}  // namespace snell
