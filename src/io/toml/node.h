// SPDX-License-Identifier: Apache-2.0
//
// A value of a TOML file with its place: the only view of toml++ that the rest of the reader has, so that
// its large header is compiled once. ParseToml first refuses what would overflow the parser's stack or
// take it forever (toml_limits.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "util/error.h"

namespace toml {
inline namespace v3 {
class key;
class node;
}  // namespace v3
}  // namespace toml

namespace snell::io {

// A value; valid as long as the tree that it belongs to.
class Node {
 public:
  struct Entry;

  explicit Node(const toml::node* node) : node_(node) {}

  bool IsTable() const;
  bool IsArray() const;

  // The value if it is of the kind, else nothing. Whole numbers are numbers too.
  std::optional<bool> Boolean() const;
  std::optional<std::int64_t> Integer() const;
  std::optional<double> Number() const;
  std::optional<std::string_view> String() const;

  // Elements of an array; 0 of them for other kinds.
  std::size_t size() const;
  Node operator[](std::size_t index) const;

  // The keys of a table in the order of the file; none for other kinds.
  std::vector<Entry> Entries() const;

  Place place() const;

  // What it is, for messages: "a string", "a list of 2", "a table", "-1", "nan".
  std::string Description() const;

 private:
  const toml::node* node_;
};

// A key of a table and its value.
struct Node::Entry {
  std::string_view name;
  Node value;
  const toml::key* key;

  Place place() const;  // of the key
};

// Parse a whole file. `file` is what messages call it. Throws Error with the place of the first mistake.
std::shared_ptr<const toml::node> ParseToml(std::string_view text, const std::string& file);

}  // namespace snell::io
