// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/words.h"

#include <utility>

#include "io/mesh/text.h"

namespace snell::io {

using Kind = PbrtWord::Kind;

static bool IsWhite(char c) { return IsBlank(c) || IsLineEnd(c) || c == '\f' || c == '\v'; }

PbrtWords::PbrtWords(std::string_view text, std::string file)
    : text_(text), file_(std::move(file)) {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = lineStart_ = 3;
  next_ = Read();
}

PbrtWord PbrtWords::Next() {
  const PbrtWord word = next_;
  next_ = Read();
  return word;
}

// Lines end with LF, CR LF or CR alone.
void PbrtWords::StepOver(char c) {
  ++position_;
  const bool endsLine = c == '\n' || (c == '\r' && text_.substr(position_, 1) != "\n");
  if (!endsLine) return;
  ++line_;
  lineStart_ = position_;
}

void PbrtWords::SkipBlank() {
  bool inComment = false;
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (IsLineEnd(c)) inComment = false;
    if (c == '#') inComment = true;
    if (!inComment && !IsWhite(c)) break;
    StepOver(c);
  }
}

PbrtWord PbrtWords::Read() {
  SkipBlank();
  PbrtWord word;
  word.line = line_;
  word.column = int(position_ - lineStart_) + 1;
  if (position_ == text_.size()) return word;

  const std::size_t start = position_;
  const char first = text_[position_++];
  if (first == '[' || first == ']') {
    word.kind = first == '[' ? Kind::Open : Kind::Close;
    word.text = text_.substr(start, 1);
  } else if (first == '"') {
    word.kind = Kind::String;
    while (position_ < text_.size() && text_[position_] != '"' && !IsLineEnd(text_[position_]))
      position_ += text_[position_] == '\\' ? 2 : 1;
    if (position_ >= text_.size() || text_[position_] != '"')
      throw Error("the string has no closing quote on its line", PlaceOf(word));
    word.text = text_.substr(start + 1, position_ - start - 1);
    ++position_;
  } else {
    word.kind = Kind::Bare;
    const auto ends = [](char c) {
      return IsWhite(c) || c == '"' || c == '[' || c == ']' || c == '#';
    };
    while (position_ < text_.size() && !ends(text_[position_])) ++position_;
    word.text = text_.substr(start, position_ - start);
  }
  return word;
}

std::string Unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '\\' && i + 1 < text.size()) {
      c = text[++i];
      if (c == 'n') c = '\n';
      if (c == 'r') c = '\r';
      if (c == 't') c = '\t';
      if (c == 'b') c = '\b';
      if (c == 'f') c = '\f';
    }
    result += c;
  }
  return result;
}

std::string Quoted(const PbrtWord& word) {
  return word.kind == Kind::End ? "the end of the file" : Quoted(word.text);
}

}  // namespace snell::io
