// SPDX-License-Identifier: Apache-2.0
//
// Words and numbers of the text formats. Lines end with "\n", "\r\n" or "\r"; words are separated by
// blanks and line ends. Independent of the locale.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace snell::io {

inline bool IsBlank(char c) { return c == ' ' || c == '\t'; }
inline bool IsLineEnd(char c) { return c == '\n' || c == '\r'; }

// Reads a text word by word.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  // The next word, on whatever line; empty at the end of the text.
  std::string_view Word();
  // The next word before the end of the line; empty there.
  std::string_view WordOnLine();
  // What is left of the line without blanks around it; goes on to the next line.
  std::string_view RestOfLine();

  // Where the next character stands.
  std::size_t at() const { return at_; }
  std::size_t left() const { return text_.size() - at_; }
  // The number of the line that the last word stands on. Counts them all: for messages.
  int Line() const;

 private:
  std::string_view TakeWord();

  std::string_view text_;
  std::size_t at_;
};

// Throws Error if the bytes are no text in ASCII or UTF-8, which has no zero bytes.
void RequireText(std::string_view bytes, const std::string& file);

// The same for formats that are also found in UTF-16: that is turned to UTF-8, if it begins with its mark.
void MakeUtf8(std::string& bytes, const std::string& file);

// The whole word as a number; false if it is none. Numbers too large for a double become infinite; "inf"
// and "nan", in whatever way C libraries print them, are numbers.
bool ParseNumber(std::string_view word, double& value);

// 'the word' for messages: cut short if it is long, and with '?' for what cannot be printed.
std::string Quoted(std::string_view word);

// Whether two ASCII words are the same but for upper and lower case; `lower` is in lower case.
bool EqualsIgnoringCase(std::string_view word, std::string_view lower);

}  // namespace snell::io
