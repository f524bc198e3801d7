// SPDX-License-Identifier: Apache-2.0
//
// Writes JSON (RFC 8259), indented by two spaces. Numbers that JSON cannot express become null; bytes that
// are not UTF-8 become U+FFFD.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace snell {

class JsonWriter {
 public:
  JsonWriter() { Open('{'); }

  // Members of the object that is open; within an array the name is not written.
  void Add(std::string_view name, std::string_view value);
  void Add(std::string_view name, const char* value) { Add(name, std::string_view(value)); }
  void Add(std::string_view name, const std::string& value) { Add(name, std::string_view(value)); }
  void Add(std::string_view name, double value);
  void Add(std::string_view name, std::uint64_t value);
  void Add(std::string_view name, int value);
  void Add(std::string_view name, bool value);
  void Add(std::string_view name, const std::vector<std::string>& values);
  // An array on one line.
  void Add(std::string_view name, std::initializer_list<float> values);

  void BeginObject(std::string_view name) { Begin(name, '{'); }
  void BeginArray(std::string_view name) { Begin(name, '['); }
  void End();

  // Close what is open; the text, with a line end.
  std::string Finish();

 private:
  void Name(std::string_view name);
  void Begin(std::string_view name, char bracket);
  void Open(char bracket);

  std::string text_;
  std::string open_;  // the brackets that are open
  bool first_ = true;
};

}  // namespace snell
