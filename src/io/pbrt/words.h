// SPDX-License-Identifier: Apache-2.0
//
// The words of a pbrt text and the places where they stand: names, numbers, "strings", and brackets. White
// space separates them; '#' starts a comment that lasts to the end of the line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "util/error.h"

namespace snell::io {

struct PbrtWord {
  enum class Kind { End, Bare, String, Open, Close };
  Kind kind = Kind::End;
  std::string_view text;  // of a string without its quotes, escapes as they are
  int line = 1;
  int column = 1;
};

// Walks over a text that outlives it. Throws Error where a string does not end.
class PbrtWords {
 public:
  PbrtWords(std::string_view text, std::string file);

  const PbrtWord& Peek() const { return next_; }
  PbrtWord Next();
  Place PlaceOf(const PbrtWord& word) const { return {file_, word.line, word.column}; }

 private:
  void SkipBlank();
  void StepOver(char c);
  PbrtWord Read();

  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0;
  int line_ = 1;
  std::size_t lineStart_ = 0;
  PbrtWord next_;
};

// A string's text with its escapes (\n, \", \\ …) resolved.
std::string Unescaped(std::string_view text);

// "'word'", cut and made printable, or "the end of the file".
std::string Quoted(const PbrtWord& word);

}  // namespace snell::io
