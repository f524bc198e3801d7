// SPDX-License-Identifier: Apache-2.0
//
// Reads JSON (RFC 8259) strictly and flattens it: {"a": {"b": [1]}} becomes "a.b.0" → "1".
#pragma once

#include <map>
#include <optional>
#include <string>

namespace snell::test {

using JsonValues = std::map<std::string, std::string>;

// Nothing if `text` is not JSON. Strings come without their quotes, escapes as they are.
std::optional<JsonValues> ParseJson(const std::string& text);

}  // namespace snell::test
