// SPDX-License-Identifier: Apache-2.0
#include "json_values.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace snell::test {

namespace {

class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  bool Parse(JsonValues& values) {
    values_ = &values;
    if (!Value("")) return false;
    Skip();
    return rest_.empty();
  }

 private:
  void Skip() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }
  bool TakeHere(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  bool Take(std::string_view word) {
    Skip();
    return TakeHere(word);
  }
  bool Digits() {
    const std::size_t count = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    rest_.remove_prefix(count);
    return count > 0;
  }

  bool Number() {
    TakeHere("-");
    if (!TakeHere("0") && !Digits()) return false;
    if (TakeHere(".") && !Digits()) return false;
    if (!TakeHere("e") && !TakeHere("E")) return true;
    if (!TakeHere("+")) TakeHere("-");
    return Digits();
  }
  bool String(std::string& text) {
    if (!Take("\"")) return false;
    const std::string_view start = rest_;
    while (!rest_.empty() && rest_[0] != '"') {
      const bool escape = rest_[0] == '\\';
      if (static_cast<unsigned char>(rest_[0]) < 0x20) return false;
      rest_.remove_prefix(1);
      if (escape && !Escape()) return false;
    }
    text = start.substr(0, start.size() - rest_.size());
    return TakeHere("\"");
  }
  bool Escape() {
    if (rest_.empty() || std::string_view("\"\\/bfnrtu").find(rest_[0]) == std::string_view::npos)
      return false;
    const std::size_t digits = rest_[0] == 'u' ? 4 : 0;
    if (rest_.size() <= digits) return false;
    for (std::size_t i = 1; i <= digits; ++i)
      if (!std::isxdigit(static_cast<unsigned char>(rest_[i]))) return false;
    rest_.remove_prefix(1 + digits);
    return true;
  }

  bool Value(const std::string& path) {
    if (Take("{")) return Members(path);
    if (Take("[")) return Elements(path);
    const std::string_view start = rest_;
    std::string text;
    if (!String(text)) {
      const bool word = TakeHere("true") || TakeHere("false") || TakeHere("null");
      if (!word && !Number()) return false;
      text = start.substr(0, start.size() - rest_.size());
    }
    (*values_)[path] = text;
    return true;
  }
  bool Members(const std::string& path) {
    if (Take("}")) return true;
    do {
      std::string name;
      if (!String(name) || !Take(":") || !Value(path.empty() ? name : path + "." + name))
        return false;
    } while (Take(","));
    return Take("}");
  }
  bool Elements(const std::string& path) {
    if (Take("]")) return true;
    int index = 0;
    do {
      if (!Value(path + "." + std::to_string(index++))) return false;
    } while (Take(","));
    return Take("]");
  }

  std::string_view rest_;
  JsonValues* values_ = nullptr;
};

}  // namespace

std::optional<JsonValues> ParseJson(const std::string& text) {
  JsonValues values;
  return Parser(text).Parse(values) ? std::optional(values) : std::nullopt;
}

}  // namespace snell::test
