// SPDX-License-Identifier: Apache-2.0
//
// Help at the terminal: the overview of the program and the page of one command.
#pragma once

#include <string>

#include "cli/definitions.h"

namespace snell::cli {

// What the program is, its commands and two examples.
std::string OverviewText(const Definitions& definitions);

// Synopsis, details and all options of a command.
std::string HelpText(const Command& command);

// `text` in lines of at most `width` characters, all but the first indented by `indent`.
std::string Wrap(const std::string& text, std::size_t indent, std::size_t width);

}  // namespace snell::cli
