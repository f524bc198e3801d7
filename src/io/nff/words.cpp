// SPDX-License-Identifier: Apache-2.0
#include "io/nff/words.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace snell::io {

static bool IsBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

NffWords::NffWords(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = lineStart_ = 3;
  Next();
}

// Lines end with LF, CR LF or, as on old Macintoshes, CR alone.
void NffWords::StepOver(char c) {
  ++position_;
  const bool endsLine = c == '\n' || (c == '\r' && text_.substr(position_, 1) != "\n");
  if (!endsLine) return;
  ++line_;
  lineStart_ = position_;
  lineIsBlank_ = true;
}

void NffWords::SkipBlank() {
  bool inComment = false;
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (c == '\n' || c == '\r') inComment = false;
    if (c == '#') inComment = true;
    if (!inComment && !IsBlank(c)) break;
    StepOver(c);
  }
}

NffWord NffWords::Next() {
  SkipBlank();
  const std::size_t start = position_;
  while (position_ < text_.size() && !IsBlank(text_[position_]) && text_[position_] != '#')
    ++position_;
  NffWord word{text_.substr(start, position_ - start), line_, int(start - lineStart_) + 1,
               lineIsBlank_};
  lineIsBlank_ = false;
  return std::exchange(next_, word);
}

void NffWords::SkipToNextEntity() {
  while (!AtEnd() && !(next_.startsLine && !AtNumber())) Next();
}

bool NffWords::LooksNumeric(const NffWord& word) {
  if (word.text.empty()) return false;
  const char c = word.text[0];
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

std::string NffWords::Quoted(const NffWord& word) {
  if (word.text.empty()) return "the end of the file";
  std::string shown;
  for (const char c : word.text.substr(0, 24)) shown += c >= ' ' && c <= '~' ? c : '?';
  return fmt::format("'{}{}'", shown, word.text.size() > 24 ? "..." : "");
}

std::string NffWords::Hint(std::string_view form) {
  return form.empty() ? "" : fmt::format("the form is: {}", form);
}

void NffWords::Fail(const NffWord& word, std::string message, std::string hint) const {
  throw Error(std::move(message), PlaceOf(word), std::move(hint));
}

double NffWords::Parse(const NffWord& word, std::string_view form) const {
  std::string_view digits = word.text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole = end == digits.data() + digits.size() && !digits.empty();
  if (error == std::errc::invalid_argument || !whole || !LooksNumeric(word))
    Fail(word, fmt::format("expected a number, found {}", Quoted(word)), Hint(form));
  const double most = double(std::numeric_limits<float>::max());
  if (error == std::errc::result_out_of_range || !(std::abs(value) <= most))
    Fail(word, fmt::format("the number {} is out of range", Quoted(word)), Hint(form));
  return value;
}

float NffWords::Number(std::string_view form) {
  const float value = float(Parse(next_, form));
  Next();
  return value;
}

scene::vec3 NffWords::Vector(std::string_view form) {
  const float x = Number(form), y = Number(form), z = Number(form);
  return scene::vec3(x, y, z);
}

int NffWords::Integer(std::string_view form, int least, int most) {
  const double value = Parse(next_, form);
  if (value != std::floor(value) || value < least || value > most)
    Fail(next_,
         fmt::format("expected a whole number from {} to {}, found {}", least, most, Quoted(next_)),
         Hint(form));
  Next();
  return int(value);
}

}  // namespace snell::io
