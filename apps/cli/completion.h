// SPDX-License-Identifier: Apache-2.0
//
// Completion scripts for shells, from the definitions of the commands. They complete commands, options, the
// words of choices, and files of the right kind.
#pragma once

#include <string>

#include "cli/definitions.h"

namespace snell::cli {

std::string BashCompletion(const Definitions& definitions);
std::string ZshCompletion(const Definitions& definitions);
std::string FishCompletion(const Definitions& definitions);

}  // namespace snell::cli
