// SPDX-License-Identifier: Apache-2.0
//
// The manual page in roff, from the definitions of the commands. Macros as in man(7); shown by "man -l".
#pragma once

#include <string>

#include "cli/definitions.h"

namespace snell::cli {

std::string ManPage(const Definitions& definitions);

}  // namespace snell::cli
