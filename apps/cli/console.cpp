// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "util/utf8.h"

namespace snell::cli {

namespace {

// That nobody reads it is no reason to stop.
void WriteLines(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

// One line whatever the names of files contain.
void PrintLine(std::string_view kind, std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  WriteLines(fmt::format("snell: {}{}\n", kind, Printable(text)));
}

}  // namespace

void ReserveStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest free number is the stream's; what is open for reading cannot be written to
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDONLY) != stream) return;
  }
}

void PrintNote(std::string_view text) { PrintLine("", std::string(text)); }
void PrintParagraph(std::string_view text) { WriteLines("snell: " + Printable(text)); }
void PrintWarning(const Diagnostic& warning) { PrintLine("warning: ", ToString(warning)); }
void PrintError(std::string_view text) { PrintLine("error: ", std::string(text)); }

void PrintError(const Error& error) {
  for (const Diagnostic& diagnostic : error.diagnostics()) PrintError(ToString(diagnostic));
}

void PrintOut(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
    return;
  throw Error(fmt::format("cannot write to the standard output: {}", std::strerror(errno)));
}

std::string Printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = Utf8Length(text);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const bool c0 = (byte(0) < 0x20 && byte(0) != '\n' && byte(0) != '\t') || byte(0) == 0x7F;
    const bool c1 = length == 2 && byte(0) == 0xC2 && byte(1) < 0xA0;  // U+0080 to U+009F
    if (c1)
      shown += fmt::format("\\x{:02x}", byte(1));
    else if (c0 || length == 0)
      shown += fmt::format("\\x{:02x}", byte(0));
    else
      shown += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return shown;
}

}  // namespace snell::cli
