// SPDX-License-Identifier: Apache-2.0
//
// The kinds of values that keys take: how one is read from TOML, how a default is shown, and how it is
// described to people and to editors. Every reader refuses what is out of range, infinite or not a number.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "io/toml/reader.h"
#include "scene/scene.h"

namespace snell::io {

using scene::ColorInput;
using scene::Spectrum;
using scene::vec2;
using scene::vec3;

template <class T>
struct Type {
  std::string expected;  // "a number > 0", as in "expected a number > 0, found -1"
  std::string unit;      // "m"
  std::string schema;    // JSON Schema
  std::string example;   // in TOML
  std::function<bool(Reader&, const Node&, T&)> read;  // false: reported
  std::function<std::string(const T&)> write;          // as TOML; may be null
};

// The numbers between two bounds, which belong to it unless they are open.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool open = false;

  bool Contains(double x) const;
  std::string Words() const;   // " > 0", " from 0 to 1", ""
  std::string Schema() const;  // ", \"minimum\": 0"
};

inline constexpr Range Any = {};
inline constexpr Range Positive = {0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range NotNegative = {0};

// --- Numbers, truth, text

Type<float> Number(Range range, std::string unit = "");
Type<float> Degrees(Range range);  // in radians in the record
Type<bool> Boolean();
Type<std::string> Text(std::string example);
Type<std::string> LightGroupName();

Type<int> Integer(int lower, int upper);
Type<std::uint32_t> Seed();

// --- Vectors

Type<vec3> Point();                    // metres
Type<vec3> NotZero(std::string unit);  // any length but 0
Type<vec3> Direction();                // not zero; unit length in the record
Type<std::array<int, 2>> ImageSize();  // pixels
Type<vec2> TexturePoint();
Type<scene::uvec3> TriangleIndices();

// --- Colours

// Up to 1, or of any strength.
enum class Brightness { Reflectance, Unlimited };

// [r, g, b], one number or "#rrggbb".
Type<Spectrum> Color(Brightness brightness);

// A colour, the name of a texture, or { texture, tint }.
Type<ColorInput> ColorOrTexture(Brightness brightness);

// --- Combinations

// One of several words. The words' meanings are the values.
template <class E>
Type<E> Choice(std::vector<std::pair<std::string, E>> words);

// A list of at least `least` and at most `most` values, or of just that many.
template <class T>
Type<std::vector<T>> ListOf(Type<T> type, std::string plural, std::size_t least = 0,
                            std::size_t most = std::numeric_limits<std::size_t>::max());

// --- What the readers of values are made of

// The number, if it is finite and in the range. Reports if not.
bool ReadNumber(Reader& reader, const Node& value, Range range, const std::string& expected,
                double& number);

// A list of `count` numbers in the range.
bool ReadNumbers(Reader& reader, const Node& value, Range range, const std::string& expected,
                 double* numbers, std::size_t count);

// "one", "two" and so on with commas between them.
std::string WordList(const std::vector<std::string>& words);

// The index of the word that the value is, -1 if it is none of them, which is reported.
int ReadWord(Reader& reader, const Node& value, const std::vector<std::string>& words);

// Report and return false if the list has not between `least` and `most` elements.
bool ReadLength(Reader& reader, const Node& value, const std::string& expected, std::size_t least,
                std::size_t most);

// "0.5", "1e+10": the shortest text that gives the number again.
std::string ToToml(float number);

// A text as a string of TOML and JSON.
std::string InQuotes(const std::string& text);

std::string WordSchema(const std::vector<std::string>& words);
std::string ListSchema(const std::string& element, std::size_t least, std::size_t most);

template <class E>
Type<E> Choice(std::vector<std::pair<std::string, E>> words) {
  std::vector<std::string> names;
  for (const auto& [name, value] : words) names.push_back(name);
  Type<E> type;
  type.expected = WordList(names);
  type.schema = WordSchema(names);
  type.example = InQuotes(names.back());
  type.read = [words, names](Reader& reader, const Node& value, E& result) {
    const int index = ReadWord(reader, value, names);
    if (index >= 0) result = words[std::size_t(index)].second;
    return index >= 0;
  };
  type.write = [words](const E& value) {
    for (const auto& [name, meaning] : words)
      if (meaning == value) return InQuotes(name);
    return std::string();
  };
  return type;
}

template <class T>
Type<std::vector<T>> ListOf(Type<T> element, std::string plural, std::size_t least,
                            std::size_t most) {
  Type<std::vector<T>> type;
  const std::string count = least == most ? std::to_string(least) + " " : "";
  type.expected = "a list of " +
                  (least > 1 && count.empty() ? "at least " + std::to_string(least) + " " : count) +
                  plural;
  type.unit = element.unit;
  type.schema = ListSchema(element.schema, least, most);
  type.read = [element, least, most, expected = type.expected](Reader& reader, const Node& value,
                                                               std::vector<T>& list) {
    if (!ReadLength(reader, value, expected, least, most)) return false;
    list.assign(value.size(), T());
    for (std::size_t i = 0; i < list.size(); ++i)
      if (!element.read(reader, value[i], list[i])) return false;
    return true;
  };
  return type;
}

}  // namespace snell::io
