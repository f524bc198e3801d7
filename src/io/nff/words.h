// SPDX-License-Identifier: Apache-2.0
//
// The words of an NFF text and the places where they stand. White space and line ends separate words and
// mean nothing else; '#' starts a comment that lasts to the end of the line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

// A view into the text; empty at its end.
struct NffWord {
  std::string_view text;
  int line = 1;
  int column = 1;
  bool startsLine = false;
};

// Walks over a text that outlives it. The functions that read a value throw Error at the word which is not
// one; `form`, what the whole entity looks like, becomes the hint.
class NffWords {
 public:
  NffWords(std::string_view text, std::string file);

  bool AtEnd() const { return next_.text.empty(); }
  bool AtNumber() const { return LooksNumeric(next_); }
  const NffWord& Peek() const { return next_; }
  NffWord Next();
  // Forget words up to the next line that begins with a letter.
  void SkipToNextEntity();

  float Number(std::string_view form);
  scene::vec3 Vector(std::string_view form);
  int Integer(std::string_view form, int least, int most);

  Place PlaceOf(const NffWord& word) const { return {file_, word.line, word.column}; }
  [[noreturn]] void Fail(const NffWord& word, std::string message, std::string hint = {}) const;

  // "the form is: s X Y Z RADIUS", or nothing without a form.
  static std::string Hint(std::string_view form);
  static bool LooksNumeric(const NffWord& word);
  // The word in quotes, cut to a readable length, without control characters; "the end of the file".
  static std::string Quoted(const NffWord& word);

 private:
  void SkipBlank();
  void StepOver(char c);
  double Parse(const NffWord& word, std::string_view form) const;

  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0;
  int line_ = 1;
  std::size_t lineStart_ = 0;
  bool lineIsBlank_ = true;  // so far
  NffWord next_;
};

}  // namespace snell::io
