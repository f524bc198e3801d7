// SPDX-License-Identifier: Apache-2.0
//
// What the program says on the standard error output: one line for each error, warning or note. Names and
// texts out of files are shown harmlessly, without the control characters that a terminal would obey.
#pragma once

#include <string>
#include <string_view>

#include "util/error.h"

namespace snell::cli {

// Give each standard stream that is closed a place, so that no file that is opened later takes it and
// receives what is printed. Printing to such a stream still fails.
void ReserveStandardStreams();

// "snell: text"
void PrintNote(std::string_view text);
// The same for several lines, which stay as they are.
void PrintParagraph(std::string_view text);

// "snell: warning: place: message; hint"
void PrintWarning(const Diagnostic& warning);

// "snell: error: place: message; hint", a line for each of the error's diagnostics.
void PrintError(const Error& error);
void PrintError(std::string_view text);

// Print on the standard output. Throws Error if that fails, a full disk for example.
void PrintOut(std::string_view text);

// Control characters other than line ends and tabs, and bytes that are not UTF-8, shown as "\x1b": a file's
// contents cannot steer the terminal.
std::string Printable(std::string_view text);

}  // namespace snell::cli
