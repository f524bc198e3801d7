// SPDX-License-Identifier: Apache-2.0
#include "io/toml/limits.h"

#include <fmt/format.h>

#include <cctype>
#include <functional>
#include <unordered_set>

#include "util/error.h"

namespace snell::io {

namespace {

// Of a bare key, a number or a date.
bool IsWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '+';
}

// Goes over the characters once and keeps count of what is limited.
class LimitScanner {
 public:
  LimitScanner(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void Scan() {
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // a byte order mark
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == '"' || c == '\'') {
        SkipString(c);
      } else {
        Punctuation(c);
        ++at_;
      }
    }
  }

 private:
  void Punctuation(char c) {
    switch (c) {
      case '\n':
        EndKey(false);
        atLineStart_ = true;
        break;
      case ' ':
      case '\t':
      case '\r': break;
      case '.':
        if (++dots_ >= MaxKeyParts)
          Fail(fmt::format("a dotted key has more than {} parts", MaxKeyParts));
        break;
      case '[':
      case '{':
        open_ += c;
        if (open_.size() > MaxBrackets)
          Fail(fmt::format("lists and tables are nested more than {} deep", MaxBrackets));
        if (open_.size() == 1) inHeader_ = c == '[' && atLineStart_;
        if (inHeader_) CheckHeader();
        EndKey(false);
        break;
      case ']':
      case '}':
        EndKey(inHeader_);
        inHeader_ = false;
        CloseBracket(c);
        break;
      case '=': EndKey(dots_ > 0); break;
      case ',': EndKey(false); break;
      default:
        if (static_cast<unsigned char>(c) >= 0x80) FailAtCharacter();
        break;
    }
    if (c != ' ' && c != '\t' && c != '\n') atLineStart_ = false;
  }

  void CloseBracket(char c) {
    const char opening = c == ']' ? '[' : '{';
    if (open_.empty() || open_.back() != opening)
      Fail(fmt::format("syntax error: '{}' without '{}' before it", c, opening));
    open_.pop_back();
  }

  // toml++ 3.3 takes for granted that a key follows the bracket of a header.
  void CheckHeader() const {
    const std::size_t next = std::min(text_.find_first_not_of(" \t", at_ + 1), text_.size());
    const char c = next < text_.size() ? text_[next] : '\n';
    const bool isKey = IsWord(c) || c == '"' || c == '\'' || c == ']';
    const bool isSecond = c == '[' && open_.size() == 1 && next == at_ + 1;
    if (!isKey && !isSecond)
      Fail("syntax error in table header: expected a name after the bracket");
  }

  // Outside strings and comments TOML is ASCII; toml++ 3.3 is not sure what it makes of the rest.
  [[noreturn]] void FailAtCharacter() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xc0) == 0x80) ++end;
    Fail(fmt::format("unexpected character '{}' outside a string", text_.substr(at_, end - at_)));
  }

  // Start the next key; the last one, if it made tables, adds to the parser's searches.
  void EndKey(bool madeTables) {
    if (madeTables) {
      const std::size_t name =
          std::hash<std::string_view>()(text_.substr(keyStart_, at_ - keyStart_));
      tables_.insert(inHeader_ ? name : name + at_);
      if (++tableCount_ * tables_.size() > MaxTableSearches)
        Fail(fmt::format("the file has more than {} dotted keys and headers", tableCount_ - 1));
    }
    dots_ = 0;
    keyStart_ = at_ + 1;
  }

  // Go behind the string that starts here; one that is never closed ends with its line or the text.
  void SkipString(char quote) {
    if (at_ > 0 && IsWord(text_[at_ - 1])) Fail("syntax error: a quotation mark within a word");
    const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
    const bool multiLine = text_.substr(at_, 3) == three;
    at_ += multiLine ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\\' && quote == '"') {
        at_ += 2;
      } else if (multiLine ? text_.substr(at_, 3) == three : c == quote) {
        at_ += multiLine ? 3 : 1;
        break;
      } else if (c == '\n' && !multiLine) {
        break;
      } else {
        ++at_;
      }
    }
    // A multi-line string may end in up to two more quotes that belong to it
    while (multiLine && at_ < text_.size() && text_[at_] == quote) ++at_;
    at_ = std::min(at_, text_.size());
    atLineStart_ = false;
  }

  [[noreturn]] void Fail(const std::string& message) const {
    Place place{file_, 1, 1};
    for (const char c : text_.substr(0, at_)) {
      const bool continuation = (static_cast<unsigned char>(c) & 0xc0) == 0x80;
      if (!continuation) ++place.column;
      if (c == '\n') {
        ++place.line;
        place.column = 1;
      }
    }
    throw Error(message, place);
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t keyStart_ = 0;
  int dots_ = 0;
  std::string open_;  // brackets and braces
  bool atLineStart_ = true;
  bool inHeader_ = false;
  std::uint64_t tableCount_ = 0;
  std::unordered_set<std::size_t> tables_;
};

}  // namespace

void CheckTomlLimits(std::string_view text, const std::string& file) {
  LimitScanner(text, file).Scan();
}

}  // namespace snell::io
