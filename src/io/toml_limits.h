// SPDX-License-Identifier: Apache-2.0
//
// What a TOML file may not do to its parser. toml++ limits how deep values nest but not how many parts a
// dotted key has, and builds and destroys tables by recursion; it also searches lists of the tables that
// dotted keys and headers make. A pass over the characters bounds both before the parser runs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace snell::io {

// Bytes of all TOML files of a scene together. A byte of text becomes about 20 bytes of memory.
inline constexpr std::uint64_t MaxTomlBytes = std::uint64_t(128) << 20;

// Parts of a dotted key, and open brackets and braces. A scene needs 3 and 7.
inline constexpr int MaxKeyParts = 16;
inline constexpr int MaxBrackets = 32;

// Table headers and dotted keys, times how many of them differ: the parser's searches. About 10 s.
inline constexpr std::uint64_t MaxTableSearches = 10'000'000'000;

// Throws Error with the place where `text` goes beyond a limit. Text that is not TOML passes or not; the
// parser tells.
void CheckTomlLimits(std::string_view text, const std::string& file);

}  // namespace snell::io
