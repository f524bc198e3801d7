// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

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
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F are control characters too: 0xC2 and then 0x80 to 0x9F in UTF-8
    const bool isC1 = byte == 0xC2 && i + 1 < text.size() &&
                      static_cast<unsigned char>(text[i + 1]) >= 0x80 &&
                      static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (isC1) {
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[++i]));
    } else if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F) {
      shown += fmt::format("\\x{:02x}", byte);
    } else {
      shown += char(byte);
    }
  }
  return shown;
}

}  // namespace snell::cli
