// SPDX-License-Identifier: Apache-2.0
#include "io/toml/node.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "io/mesh/text.h"
#include "io/toml/limits.h"

namespace snell::io {

static Place ToPlace(const toml::source_region& source) {
  return {source.path ? *source.path : "", int(source.begin.line), int(source.begin.column)};
}

bool Node::IsTable() const { return node_->is_table(); }
bool Node::IsArray() const { return node_->is_array(); }

std::optional<bool> Node::Boolean() const {
  const auto* value = node_->as_boolean();
  return value ? std::optional(value->get()) : std::nullopt;
}

std::optional<std::int64_t> Node::Integer() const {
  const auto* value = node_->as_integer();
  return value ? std::optional(value->get()) : std::nullopt;
}

std::optional<double> Node::Number() const {
  if (const auto whole = Integer()) return double(*whole);
  const auto* value = node_->as_floating_point();
  return value ? std::optional(value->get()) : std::nullopt;
}

std::optional<std::string_view> Node::String() const {
  const auto* value = node_->as_string();
  return value ? std::optional(std::string_view(value->get())) : std::nullopt;
}

std::size_t Node::size() const {
  const toml::array* array = node_->as_array();
  return array ? array->size() : 0;
}

Node Node::operator[](std::size_t index) const { return Node(node_->as_array()->get(index)); }

std::vector<Node::Entry> Node::Entries() const {
  std::vector<Entry> entries;
  const toml::table* table = node_->as_table();
  if (!table) return entries;
  entries.reserve(table->size());
  for (const auto& [key, value] : *table) entries.push_back({key.str(), Node(&value), &key});

  // The library keeps keys by the alphabet
  const auto position = [](const Entry& entry) { return entry.key->source().begin; };
  std::stable_sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    return position(a).line != position(b).line ? position(a).line < position(b).line
                                                : position(a).column < position(b).column;
  });
  return entries;
}

Place Node::place() const { return ToPlace(node_->source()); }

Place Node::Entry::place() const { return ToPlace(key->source()); }

std::string Node::Description() const {
  if (const auto value = Boolean()) return *value ? "true" : "false";
  if (const auto value = Integer()) return fmt::format("{}", *value);
  if (const auto value = Number()) return fmt::format("{}", *value);
  if (String()) return "a string";
  if (IsArray()) return size() == 0 ? "an empty list" : fmt::format("a list of {}", size());
  return IsTable() ? "a table" : "a date or time";
}

std::shared_ptr<const toml::node> ParseToml(std::string_view text, const std::string& file) {
  RequireText(text, file);
  CheckTomlLimits(text, file);
  try {
    return std::make_shared<toml::table>(toml::parse(text, file));
  } catch (const toml::parse_error& error) {
    std::string message(error.description());
    const std::string_view preamble = "Error while parsing ";
    if (message.starts_with(preamble))
      message = "syntax error in " + message.substr(preamble.size());
    throw Error(message, ToPlace(error.source()));
  }
}

}  // namespace snell::io
