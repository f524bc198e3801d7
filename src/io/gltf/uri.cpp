// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "util/error.h"
#include "util/file.h"

namespace snell::io {
namespace {

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Of base64 and its variant for URLs; -1 for other characters.
constexpr std::array<signed char, 256> Base64Digits = [] {
  std::array<signed char, 256> digits{};
  digits.fill(-1);
  constexpr std::string_view Alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < Alphabet.size(); ++i)
    digits[static_cast<unsigned char>(Alphabet[i])] = static_cast<signed char>(i);
  digits['-'] = 62;
  digits['_'] = 63;
  return digits;
}();

std::string DecodeBase64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int digit = Base64Digits[static_cast<unsigned char>(text[i])];
    if (digit < 0) {
      const bool isPadding =
          text.size() - i <= 2 && text.substr(i) == std::string(text.size() - i, '=');
      if (isPadding) break;
      throw Error(fmt::format("the base64 of the data URI has a wrong character at {}", i));
    }
    bits = bits << 6 | std::uint32_t(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(char(bits >> count & 0xff));
    }
  }
  return bytes;
}

// "http" of "http://…"; "" of relative references.
std::string_view SchemeOf(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon < 2) return {};
  const std::string_view scheme = uri.substr(0, colon);
  const bool isScheme = std::ranges::all_of(scheme, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
  });
  return isScheme ? scheme : std::string_view{};
}

}  // namespace

std::string DecodePercent(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? HexDigit(text[i + 1]) : -1;
    const int low = high >= 0 ? HexDigit(text[i + 2]) : -1;
    if (low >= 0) {
      decoded.push_back(char(high << 4 | low));
      i += 2;
    } else {
      decoded.push_back(text[i]);
    }
  }
  return decoded;
}

bool IsDataUri(std::string_view uri) {
  constexpr std::string_view Scheme = "data:";
  return uri.size() >= Scheme.size() &&
         std::ranges::equal(uri.substr(0, Scheme.size()), Scheme, {}, [](char c) {
           return char(std::tolower(static_cast<unsigned char>(c)));
         });
}

std::string DecodeDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) throw Error("the data URI has no comma before its data");
  const std::string_view data = uri.substr(comma + 1);
  if (!uri.substr(0, comma).ends_with(";base64")) return DecodePercent(data);
  return data.find('%') == std::string_view::npos ? DecodeBase64(data)
                                                  : DecodeBase64(DecodePercent(data));
}

std::string ReadGltfUri(const std::vector<std::filesystem::path>& folders, std::string_view uri,
                        const ReadLimits& limits) {
  if (IsDataUri(uri)) return DecodeDataUri(uri);
  if (const std::string_view scheme = SchemeOf(uri); !scheme.empty())
    throw Error(fmt::format("'{}' is no file of the scene's folder", ShortUri(uri)));
  return ReadWithin(ConfinedPath(folders, folders.front(), DecodePercent(uri)), limits);
}

std::string ShortUri(std::string_view uri) {
  if (IsDataUri(uri)) return "data URI";
  std::string text(uri.substr(0, 100));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  return text;
}

}  // namespace snell::io
