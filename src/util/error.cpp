// SPDX-License-Identifier: Apache-2.0
#include "util/error.h"

#include <fmt/format.h>

#include <utility>

namespace snell {

std::string ToString(const Place& place) {
  if (place.line > 0 && place.column > 0)
    return fmt::format("{}:{}:{}", place.file, place.line, place.column);
  if (place.line > 0) return fmt::format("{}:{}", place.file, place.line);
  if (place.offset >= 0) return fmt::format("{}, byte {}", place.file, place.offset);
  return place.file;
}

std::string ToString(const Diagnostic& diagnostic) {
  std::string text = ToString(diagnostic.place);
  if (!text.empty()) text += ": ";
  text += diagnostic.message;
  if (!diagnostic.hint.empty()) text += "; " + diagnostic.hint;
  return text;
}

static std::string Lines(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += ToString(diagnostic);
  }
  return text;
}

Error::Error(std::string message, Place place, std::string hint)
    : Error(std::vector<Diagnostic>{{std::move(message), std::move(place), std::move(hint)}}) {}

Error::Error(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(Lines(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace snell
