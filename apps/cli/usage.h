// SPDX-License-Identifier: Apache-2.0
//
// What to tell someone who typed a command line that makes no sense: one line, with what was probably meant.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace snell::cli {

// The line for a complaint of CLI11, which has parsed `words` up to it.
std::string ComplaintText(const CLI::App& program, const CLI::ParseError& error,
                          const std::vector<std::string>& words);

// The line for the first option that nobody knows, if there is one: it explains whatever went wrong after it.
std::optional<std::string> UnknownOptionText(const CLI::App& program);

// "unknown command 'rendr'; did you mean 'render'?"
std::string UnknownCommandText(const CLI::App& program, const std::string& word);

}  // namespace snell::cli
