// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: what this build is. Installed as <snell/api/version.h>.
#pragma once

#include <string>
#include <vector>

#include "../util/error.h"

namespace snell {

// "0.1.0"
SNELL_EXPORT std::string Version();
// Compiler and build type.
SNELL_EXPORT std::string BuildDescription();
// Instruction sets of the BVH that this processor runs, slowest first.
SNELL_EXPORT std::vector<std::string> InstructionSets();
// The one that is used.
SNELL_EXPORT std::string ActiveInstructionSet();

}  // namespace snell
