// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/text.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "util/error.h"

namespace snell::io {

std::string_view TextScanner::TakeWord() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && !IsBlank(text_[at_]) && !IsLineEnd(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextScanner::Word() {
  while (at_ < text_.size() && (IsBlank(text_[at_]) || IsLineEnd(text_[at_]))) ++at_;
  return TakeWord();
}

std::string_view TextScanner::WordOnLine() {
  while (at_ < text_.size() && IsBlank(text_[at_])) ++at_;
  return TakeWord();
}

std::string_view TextScanner::RestOfLine() {
  while (at_ < text_.size() && IsBlank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  while (at_ < text_.size() && !IsLineEnd(text_[at_])) ++at_;
  std::size_t end = at_;
  while (end > begin && IsBlank(text_[end - 1])) --end;

  // Step over the line's end
  if (at_ < text_.size() && text_[at_++] == '\r' && at_ < text_.size() && text_[at_] == '\n') ++at_;
  return text_.substr(begin, end - begin);
}

int TextScanner::Line() const {
  int line = 1;
  for (std::size_t i = 0; i < at_; ++i) {
    const bool pair = text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n';
    if (IsLineEnd(text_[i]) && !pair) ++line;
  }
  return line;
}

void RequireText(std::string_view bytes, const std::string& file) {
  if (bytes.find('\0') == bytes.npos) return;
  const bool utf16 = bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
  throw Error("not a text file in ASCII or UTF-8: it holds zero bytes", {file},
              utf16 ? "it seems to be UTF-16; save it as UTF-8" : "");
}

static void AppendUtf8(std::string& text, std::uint32_t code) {
  if (code < 0x80) {
    text += char(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  constexpr std::uint32_t Lead[] = {0, 0xc0, 0xe0, 0xf0};
  text += char(Lead[more] | code >> 6 * more);
  for (int i = more - 1; i >= 0; --i) text += char(0x80 | (code >> 6 * i & 0x3f));
}

void MakeUtf8(std::string& bytes, const std::string& file) {
  const bool little = bytes.starts_with("\xff\xfe");
  if (!little && !bytes.starts_with("\xfe\xff")) return RequireText(bytes, file);
  const auto unit = [&](std::size_t at) {
    const auto low = std::uint8_t(bytes[at + (little ? 0 : 1)]);
    const auto high = std::uint8_t(bytes[at + (little ? 1 : 0)]);
    return std::uint32_t(high) << 8 | low;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  constexpr std::uint32_t Replacement = 0xfffd;
  for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    const bool leads = code >= 0xd800 && code < 0xdc00;
    const std::uint32_t next = leads && at + 3 < bytes.size() ? unit(at + 2) : 0;
    if (next >= 0xdc00 && next < 0xe000) {
      code = 0x10000 + ((code - 0xd800) << 10) + (next - 0xdc00);
      at += 2;
    } else if (code >= 0xd800 && code < 0xe000) {
      code = Replacement;
    }
    AppendUtf8(text, code);
  }
  bytes = std::move(text);
  RequireText(bytes, file);
}

bool ParseNumber(std::string_view word, double& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, fault] = std::from_chars(word.data(), end, value);
  if (fault == std::errc::result_out_of_range) {
    const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    return stop == end;
  }
  if (fault != std::errc()) return false;
  if (stop == end) return true;

  // Old Microsoft libraries print "1.#INF00", "-1.#IND00" and "1.#QNAN0"
  if (word.find(".#") == word.npos) return false;
  value = std::numeric_limits<double>::quiet_NaN();
  return true;
}

std::string Quoted(std::string_view word) {
  constexpr std::size_t Longest = 40;
  std::string text = "'" + std::string(word.substr(0, Longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text + (word.size() > Longest ? "…'" : "'");
}

bool EqualsIgnoringCase(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? char(a - 'A' + 'a') : a) == b;
  });
}

}  // namespace snell::io
