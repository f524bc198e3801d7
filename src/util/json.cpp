// SPDX-License-Identifier: Apache-2.0
#include "util/json.h"

#include <fmt/format.h>

#include <cmath>

#include "util/utf8.h"

namespace snell {

namespace {

std::string Quote(std::string_view text) {
  std::string quoted = "\"";
  while (!text.empty()) {
    const std::size_t length = Utf8Length(text);
    const char c = text[0];
    if (length == 0)
      quoted += "\xEF\xBF\xBD";
    else if (c == '"' || c == '\\')
      quoted += std::string("\\") + c;
    else if (length == 1 && static_cast<unsigned char>(c) < 0x20)
      quoted += fmt::format("\\u{:04x}", c);
    else
      quoted += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return quoted + '"';
}

}  // namespace

void JsonWriter::Name(std::string_view name) {
  if (!first_) text_ += ',';
  text_ += '\n' + std::string(2 * open_.size(), ' ');
  if (open_.back() == '{') text_ += Quote(name) + ": ";
  first_ = false;
}

void JsonWriter::Open(char bracket) {
  text_ += bracket;
  open_ += bracket;
  first_ = true;
}

void JsonWriter::Begin(std::string_view name, char bracket) {
  Name(name);
  Open(bracket);
}

void JsonWriter::End() {
  const char bracket = open_.back();
  open_.pop_back();
  if (!first_) text_ += '\n' + std::string(2 * open_.size(), ' ');
  text_ += bracket == '{' ? '}' : ']';
  first_ = false;
}

void JsonWriter::Add(std::string_view name, std::string_view value) {
  Name(name);
  text_ += Quote(value);
}

void JsonWriter::Add(std::string_view name, double value) {
  Name(name);
  text_ += std::isfinite(value) ? fmt::format("{}", value) : "null";
}

void JsonWriter::Add(std::string_view name, std::uint64_t value) {
  Name(name);
  text_ += fmt::format("{}", value);
}

void JsonWriter::Add(std::string_view name, int value) {
  Name(name);
  text_ += fmt::format("{}", value);
}

void JsonWriter::Add(std::string_view name, bool value) {
  Name(name);
  text_ += value ? "true" : "false";
}

void JsonWriter::Add(std::string_view name, const std::vector<std::string>& values) {
  BeginArray(name);
  for (const std::string& value : values) Add("", value);
  End();
}

void JsonWriter::Add(std::string_view name, std::initializer_list<float> values) {
  Name(name);
  std::string list;
  for (const float value : values) {
    if (!list.empty()) list += ", ";
    list += std::isfinite(value) ? fmt::format("{}", value) : "null";
  }
  text_ += '[' + list + ']';
}

std::string JsonWriter::Finish() {
  while (!open_.empty()) End();
  return text_ + '\n';
}

}  // namespace snell
