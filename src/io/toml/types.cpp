// SPDX-License-Identifier: Apache-2.0
#include "io/toml/types.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace snell::io {

static constexpr double DegreesPerRadian = 57.295779513082320877;

// --- The readers' parts -------------------------------------------------------------------------------------

bool Range::Contains(double x) const {
  return open ? x > lower && x < upper : x >= lower && x <= upper;
}

std::string Range::Words() const {
  const bool above = std::isfinite(lower);
  const bool below = std::isfinite(upper);
  const char* orEqual = open ? "" : "=";
  if (above && below)
    return fmt::format("{} {} {} {}", open ? " between" : " from", lower, open ? "and" : "to",
                       upper);
  if (above) return fmt::format(" >{} {}", orEqual, lower);
  return below ? fmt::format(" <{} {}", orEqual, upper) : "";
}

std::string Range::Schema() const {
  std::string schema;
  const char* bound = open ? "exclusiveM" : "m";
  if (std::isfinite(lower)) schema += fmt::format(", \"{}inimum\": {}", bound, lower);
  if (std::isfinite(upper)) schema += fmt::format(", \"{}aximum\": {}", bound, upper);
  return schema;
}

bool ReadNumber(Reader& reader, const Node& value, Range range, const std::string& expected,
                double& number) {
  const auto given = value.Number();
  if (!given || !std::isfinite(*given) || !range.Contains(*given))
    return reader.Refuse(value, expected);
  if (std::abs(*given) > double(std::numeric_limits<float>::max()))
    return reader.Refuse(value, expected, "numbers may be as large as 3.4e38");

  // What rounds to nothing as a float must not slip into an open range
  if (!range.Contains(double(float(*given))))
    return reader.Refuse(value, expected, "numbers may be as small as 1.2e-38");
  number = *given;
  return true;
}

bool ReadLength(Reader& reader, const Node& value, const std::string& expected, std::size_t least,
                std::size_t most) {
  const bool fits = value.IsArray() && value.size() >= least && value.size() <= most;
  return fits || reader.Refuse(value, expected);
}

bool ReadNumbers(Reader& reader, const Node& value, Range range, const std::string& expected,
                 double* numbers, std::size_t count) {
  if (!ReadLength(reader, value, expected, count, count)) return false;
  for (std::size_t i = 0; i < count; ++i)
    if (!ReadNumber(reader, value[i], range, "a number" + range.Words(), numbers[i])) return false;
  return true;
}

std::string WordList(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + InQuotes(word);
  return list;
}

int ReadWord(Reader& reader, const Node& value, const std::vector<std::string>& words) {
  static constexpr std::size_t Few = 4;
  const std::string all = (words.size() > 1 ? "one of " : "") + WordList(words);
  const auto text = value.String();
  if (!text) {
    reader.Refuse(value, all);
    return -1;
  }
  const auto found = std::find(words.begin(), words.end(), *text);
  if (found != words.end()) return int(found - words.begin());
  const std::string suggestion = words.size() > Few ? Suggestion(*text, words) : "";
  reader.Report(fmt::format("'{}': unknown choice {}", reader.key, QuotedName(*text)),
                value.place(), suggestion.empty() ? "choose " + all : suggestion);
  return -1;
}

std::string ToToml(float number) { return fmt::format("{}", number); }

std::string InQuotes(const std::string& text) { return "\"" + text + "\""; }

std::string WordSchema(const std::vector<std::string>& words) {
  return fmt::format(R"({{"enum": [{}]}})", WordList(words));
}

std::string ListSchema(const std::string& element, std::size_t least, std::size_t most) {
  std::string schema = fmt::format(R"({{"type": "array", "items": {})", element);
  if (least > 0) schema += fmt::format(", \"minItems\": {}", least);
  if (most < std::numeric_limits<std::size_t>::max())
    schema += fmt::format(", \"maxItems\": {}", most);
  return schema + "}";
}

// --- Numbers, truth, text -----------------------------------------------------------------------------------

Type<float> Number(Range range, std::string unit) {
  Type<float> type;
  type.expected = "a number" + range.Words();
  type.unit = std::move(unit);
  type.schema = "{\"type\": \"number\"" + range.Schema() + "}";
  type.example = std::isfinite(range.upper) ? "0.75" : "2.5";
  type.read = [range, expected = type.expected](Reader& reader, const Node& value, float& result) {
    double number = 0;
    if (!ReadNumber(reader, value, range, expected, number)) return false;
    result = float(number);
    return true;
  };
  type.write = ToToml;
  return type;
}

Type<float> Degrees(Range range) {
  Type<float> type = Number(range, "degrees");
  type.example = "12.5";
  type.read = [read = type.read](Reader& reader, const Node& value, float& radians) {
    float degrees = 0;
    if (!read(reader, value, degrees)) return false;
    radians = float(double(degrees) / DegreesPerRadian);
    return true;
  };
  type.write = [](const float& radians) {
    return fmt::format("{:.5g}", double(radians) * DegreesPerRadian);
  };
  return type;
}

Type<bool> Boolean() {
  Type<bool> type;
  type.expected = "true or false";
  type.schema = R"({"type": "boolean"})";
  type.example = "false";
  type.read = [](Reader& reader, const Node& value, bool& result) {
    const auto given = value.Boolean();
    if (!given) return reader.Refuse(value, "true or false");
    result = *given;
    return true;
  };
  type.write = [](const bool& value) { return std::string(value ? "true" : "false"); };
  return type;
}

Type<std::string> LightGroupName() {
  Type<std::string> type = Text("key");
  type.expected = "a name of letters, digits, '_' and '-', 32 at most";
  type.schema = R"({"type": "string", "pattern": "^[A-Za-z0-9_-]{1,32}$"})";
  type.read = [expected = type.expected](Reader& reader, const Node& value, std::string& name) {
    const auto given = value.String();
    if (!given || !scene::IsLightGroupName(std::string(*given)))
      return reader.Refuse(value, expected);
    name = *given;
    return true;
  };
  return type;
}

Type<std::string> Text(std::string example) {
  Type<std::string> type;
  type.expected = "a string";
  type.schema = R"({"type": "string", "minLength": 1})";
  type.example = InQuotes(example);
  type.read = [](Reader& reader, const Node& value, std::string& result) {
    const auto given = value.String();
    if (!given || given->empty()) return reader.Refuse(value, "a string of at least one character");
    result = *given;
    return true;
  };
  return type;
}

template <class T>
static Type<T> WholeNumber(std::int64_t lower, std::int64_t upper) {
  Type<T> type;
  type.expected = fmt::format("a whole number from {} to {}", lower, upper);
  type.schema = fmt::format(R"({{"type": "integer", "minimum": {}, "maximum": {}}})", lower, upper);
  type.example = fmt::format("{}", std::min<std::int64_t>(upper, 7));
  type.read = [lower, upper, expected = type.expected](Reader& reader, const Node& value,
                                                       T& result) {
    const auto given = value.Integer();
    if (!given || *given < lower || *given > upper) return reader.Refuse(value, expected);
    result = T(*given);
    return true;
  };
  type.write = [](const T& value) { return fmt::format("{}", value); };
  return type;
}

Type<int> Integer(int lower, int upper) { return WholeNumber<int>(lower, upper); }

Type<std::uint32_t> Seed() {
  return WholeNumber<std::uint32_t>(0, std::numeric_limits<std::uint32_t>::max());
}

// --- Vectors ------------------------------------------------------------------------------------------------

static const char* const ThreeNumbers =
    R"({"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3})";

static std::string WritePoint(const vec3& v) {
  return fmt::format("[{}, {}, {}]", ToToml(v.x), ToToml(v.y), ToToml(v.z));
}

Type<vec3> Point() {
  Type<vec3> type;
  type.expected = "3 numbers";
  type.unit = "m";
  type.schema = ThreeNumbers;
  type.example = "[1, 2, 3.5]";
  type.read = [](Reader& reader, const Node& value, vec3& point) {
    double v[3];
    if (!ReadNumbers(reader, value, Any, "3 numbers", v, 3)) return false;
    point = vec3(float(v[0]), float(v[1]), float(v[2]));
    return true;
  };
  type.write = WritePoint;
  return type;
}

Type<vec3> NotZero(std::string unit) {
  Type<vec3> type = Point();
  type.unit = std::move(unit);
  type.expected = "3 numbers, not all 0";
  type.read = [read = type.read, expected = type.expected](Reader& reader, const Node& value,
                                                           vec3& edge) {
    if (!read(reader, value, edge)) return false;
    if (edge != vec3(0.0f)) return true;
    reader.Report(fmt::format("'{}': expected {}", reader.key, expected), value.place());
    return false;
  };
  return type;
}

Type<vec3> Direction() {
  Type<vec3> type = NotZero("");
  type.example = "[0.5, -1, 0.25]";
  type.read = [read = type.read](Reader& reader, const Node& value, vec3& direction) {
    if (!read(reader, value, direction)) return false;
    const double x = double(direction.x), y = double(direction.y), z = double(direction.z);
    const double length = std::sqrt(x * x + y * y + z * z);
    direction = vec3(float(x / length), float(y / length), float(z / length));
    return true;
  };
  return type;
}

Type<std::array<int, 2>> ImageSize() {
  static constexpr int Largest = 65536;
  Type<std::array<int, 2>> type;
  type.expected = fmt::format("2 whole numbers from 1 to {}", Largest);
  type.unit = "pixels";
  type.schema = ListSchema(
      fmt::format(R"({{"type": "integer", "minimum": 1, "maximum": {}}})", Largest), 2, 2);
  type.example = "[320, 240]";
  type.read = [expected = type.expected](Reader& reader, const Node& value,
                                         std::array<int, 2>& size) {
    if (!ReadLength(reader, value, expected, 2, 2)) return false;
    const Type<int> element = Integer(1, Largest);
    return element.read(reader, value[0], size[0]) && element.read(reader, value[1], size[1]);
  };
  type.write = [](const std::array<int, 2>& size) {
    return fmt::format("[{}, {}]", size[0], size[1]);
  };
  return type;
}

Type<vec2> TexturePoint() {
  Type<vec2> type;
  type.expected = "2 numbers";
  type.schema = R"({"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2})";
  type.example = "[0.5, 1]";
  type.read = [](Reader& reader, const Node& value, vec2& uv) {
    double v[2];
    if (!ReadNumbers(reader, value, Any, "2 numbers", v, 2)) return false;
    uv = vec2(float(v[0]), float(v[1]));
    return true;
  };
  return type;
}

Type<scene::uvec3> TriangleIndices() {
  Type<scene::uvec3> type;
  type.expected = "3 whole numbers";
  type.schema = ListSchema(R"({"type": "integer", "minimum": 0})", 3, 3);
  type.example = "[0, 1, 2]";
  type.read = [](Reader& reader, const Node& value, scene::uvec3& triangle) {
    if (!ReadLength(reader, value, "3 whole numbers", 3, 3)) return false;
    int index[3];
    static const Type<int> element = Integer(0, std::numeric_limits<int>::max());
    for (std::size_t i = 0; i < 3; ++i)
      if (!element.read(reader, value[i], index[i])) return false;
    triangle = scene::uvec3(unsigned(index[0]), unsigned(index[1]), unsigned(index[2]));
    return true;
  };
  return type;
}

}  // namespace snell::io
