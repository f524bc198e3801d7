// SPDX-License-Identifier: Apache-2.0
//
// Small helpers for messages: the nearest known word to a mistyped one, counts and sizes for people.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace snell {

// The candidate nearest to `word` by Damerau–Levenshtein distance (a swap of neighbours counts one), or
// "" if none is within a third of the word's length plus one.
std::string NearestWord(std::string_view word, const std::vector<std::string>& candidates);

// "did you mean 'radius'?" or "" without a near candidate; ready to be an Error's hint.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates);

// 1234567 → "1,234,567".
std::string WithCommas(std::uint64_t count);

// 1536 → "1.5 KiB".
std::string ByteSize(std::uint64_t bytes);

// 75.25 → "1:15"; 4000 → "1:06:40"; 0.5 → "0.50 s"; 12.3 → "12.3 s".
std::string Duration(double seconds);

// "1 light", "2 lights", "2 branches": of nouns whose plural ends in -s or -es.
std::string Plural(std::uint64_t count, std::string_view noun);

}  // namespace snell
