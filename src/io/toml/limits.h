// SPDX-License-Identifier: Apache-2.0
//
// What a TOML file may not do to its parser. toml++ limits how deep values nest but not how many parts a
// dotted key has, and builds and destroys tables by recursion; it also searches lists of the tables that
// dotted keys and headers make, and version 3.3 relies on some things that it has not checked. A pass over
// the characters sees to all of that before the parser runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace snell::io {

// Parts of a dotted key, and open brackets and braces. A scene needs 3 and 7.
inline constexpr int MaxKeyParts = 16;
inline constexpr std::size_t MaxBrackets = 32;

// Table headers and dotted keys, times how many of them differ: the parser's searches. About 10 s.
inline constexpr std::uint64_t MaxTableSearches = 10'000'000'000;

// Throws Error with the place where `text` goes beyond a limit. What passes may still not be TOML.
void CheckTomlLimits(std::string_view text, const std::string& file);

}  // namespace snell::io
