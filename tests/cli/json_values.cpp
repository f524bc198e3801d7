// SPDX-License-Identifier: Apache-2.0
#include "json_values.h"

#include <regex>

namespace snell::test {

namespace {

class Parser {
 public:
  explicit Parser(const std::string& text) : rest_(text.cbegin()), end_(text.cend()) {}

  bool Parse(JsonValues& values) {
    values_ = &values;
    return Value("") && (Skip(), rest_ == end_);
  }

 private:
  void Skip() {
    while (rest_ != end_ && std::string(" \t\r\n").find(*rest_) != std::string::npos) ++rest_;
  }
  bool Take(char c) {
    Skip();
    if (rest_ == end_ || *rest_ != c) return false;
    ++rest_;
    return true;
  }
  bool Match(const char* pattern, std::string& text) {
    Skip();
    std::smatch match;
    const auto here = std::regex_constants::match_continuous;
    if (!std::regex_search(rest_, end_, match, std::regex(pattern), here)) return false;
    text = match.str();
    rest_ += match.length();
    return true;
  }
  bool String(std::string& text) {
    if (!Match(R"("([^"\\\x00-\x1f]|\\(["\\/bfnrt]|u[0-9a-fA-F]{4}))*")", text)) return false;
    text = text.substr(1, text.size() - 2);
    return true;
  }

  bool Value(const std::string& path) {
    std::string text;
    if (Take('{')) return Members(path);
    if (Take('[')) return Elements(path);
    if (String(text) || Match(R"(-?(0|[1-9]\d*)(\.\d+)?([eE][-+]?\d+)?|true|false|null)", text)) {
      (*values_)[path] = text;
      return true;
    }
    return false;
  }
  bool Members(const std::string& path) {
    if (Take('}')) return true;
    do {
      std::string name;
      if (!String(name) || !Take(':') || !Value(path.empty() ? name : path + "." + name))
        return false;
    } while (Take(','));
    return Take('}');
  }
  bool Elements(const std::string& path) {
    if (Take(']')) return true;
    int index = 0;
    do {
      if (!Value(path + "." + std::to_string(index++))) return false;
    } while (Take(','));
    return Take(']');
  }

  std::string::const_iterator rest_;
  std::string::const_iterator end_;
  JsonValues* values_ = nullptr;
};

}  // namespace

std::optional<JsonValues> ParseJson(const std::string& text) {
  JsonValues values;
  return Parser(text).Parse(values) ? std::optional(values) : std::nullopt;
}

}  // namespace snell::test
