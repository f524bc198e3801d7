// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "io/mesh/text.h"

namespace snell::io {
namespace {

using Kind = PbrtWord::Kind;

// The names of types, also pbrt-v3's, and how many numbers make one value; 0 for words.
struct TypeName {
  std::string_view name;
  PbrtType type;
  std::size_t size;
};
constexpr std::array<TypeName, 18> TypeNames = {{{"integer", PbrtType::Integer, 1},
                                                 {"float", PbrtType::Float, 1},
                                                 {"point2", PbrtType::Point2, 2},
                                                 {"vector2", PbrtType::Vector2, 2},
                                                 {"point3", PbrtType::Point3, 3},
                                                 {"vector3", PbrtType::Vector3, 3},
                                                 {"normal", PbrtType::Normal, 3},
                                                 {"rgb", PbrtType::Rgb, 3},
                                                 {"blackbody", PbrtType::Blackbody, 1},
                                                 {"spectrum", PbrtType::Spectrum, 1},
                                                 {"bool", PbrtType::Bool, 0},
                                                 {"string", PbrtType::String, 0},
                                                 {"texture", PbrtType::Texture, 0},
                                                 {"point", PbrtType::Point3, 3},
                                                 {"vector", PbrtType::Vector3, 3},
                                                 {"normal3", PbrtType::Normal, 3},
                                                 {"color", PbrtType::Rgb, 3},
                                                 {"point4", PbrtType::Float, 1}}};

const TypeName* FindType(std::string_view name) {
  const auto* type = std::ranges::find(TypeNames, name, &TypeName::name);
  return type == TypeNames.end() ? nullptr : type;
}

std::vector<std::string_view> Split(std::string_view text) {
  std::vector<std::string_view> words;
  TextScanner scanner(text);
  for (std::string_view word; !(word = scanner.Word()).empty();) words.push_back(word);
  return words;
}

void ReadValue(const PbrtWord& word, const PbrtWords& words, const TypeName& type,
               PbrtParameter& parameter) {
  const auto fail = [&](std::string_view wanted) {
    throw Error(
        fmt::format("parameter {} needs {}, not {}", Quoted(parameter.name), wanted, Quoted(word)),
        words.PlaceOf(word));
  };
  if (type.type == PbrtType::Bool) {
    if (word.text != "true" && word.text != "false") fail("true or false");
    parameter.numbers.push_back(word.text == "true" ? 1 : 0);
    return;
  }
  if (type.size == 0 || (type.type == PbrtType::Spectrum && word.kind == Kind::String)) {
    if (word.kind != Kind::String) fail("a string");
    parameter.strings.push_back(Unescaped(word.text));
    return;
  }
  double value = 0;
  if (word.kind != Kind::Bare || !ParseNumber(word.text, value)) fail("a number");
  if (!std::isfinite(value) || std::abs(value) > double(std::numeric_limits<float>::max()))
    fail("a number that is finite and not too large");
  if (type.type == PbrtType::Integer &&
      (value != std::floor(value) || std::abs(value) > 2147483647))
    fail("a whole number");
  parameter.numbers.push_back(value);
}

}  // namespace

std::string_view NameOf(PbrtType type) {
  return std::ranges::find(TypeNames, type, &TypeName::type)->name;
}

PbrtParameters::PbrtParameters(PbrtWords& words, std::string statement, const Place& place)
    : statement_(std::move(statement)), place_(place) {
  while (words.Peek().kind == Kind::String) Read(words);
}

void PbrtParameters::Read(PbrtWords& words) {
  const PbrtWord declaration = words.Next();
  const std::vector<std::string_view> parts = Split(declaration.text);
  const Place place = words.PlaceOf(declaration);
  if (parts.size() != 2)
    throw Error(
        fmt::format("a parameter's type and name are expected, not {}", Quoted(declaration)), place,
        "as in \"float radius\" 2");
  const TypeName* type = FindType(parts[0]);
  if (!type) throw Error(fmt::format("there is no type {}", Quoted(parts[0])), place);

  auto parameter = std::make_shared<PbrtParameter>();
  parameter->type = type->type;
  parameter->name = parts[1];
  parameter->place = place;
  if (words.Peek().kind == Kind::Open) {
    const PbrtWord open = words.Next();
    while (words.Peek().kind != Kind::Close) {
      if (words.Peek().kind == Kind::End)
        throw Error("the bracket is never closed", words.PlaceOf(open));
      ReadValue(words.Next(), words, *type, *parameter);
    }
    words.Next();
  } else {
    ReadValue(words.Next(), words, *type, *parameter);
  }
  if (type->size > 1 && parameter->numbers.size() % type->size != 0)
    throw Error(fmt::format("parameter {} has {} numbers, not a multiple of {}",
                            Quoted(parameter->name), parameter->numbers.size(), type->size),
                place);
  if (Peek(parameter->name))
    throw Error(fmt::format("parameter {} is given twice", Quoted(parameter->name)), place);
  if (entries_.size() >= 200) throw Error("the statement has too many parameters", place);
  entries_.push_back({std::move(parameter)});
}

void PbrtParameters::AddDefaults(const PbrtDefaults& defaults) {
  for (const auto& parameter : defaults)
    if (!Peek(parameter->name)) entries_.push_back({parameter, true});
}

PbrtDefaults PbrtParameters::All() const {
  PbrtDefaults all;
  for (const Entry& entry : entries_) all.push_back(entry.parameter);
  return all;
}

const PbrtParameter* PbrtParameters::Peek(std::string_view name) const {
  for (const Entry& entry : entries_)
    if (entry.parameter->name == name) return entry.parameter.get();
  return nullptr;
}

const PbrtParameter* PbrtParameters::Find(std::string_view name,
                                          std::initializer_list<PbrtType> types) const {
  for (const Entry& entry : entries_) {
    if (entry.parameter->name != name) continue;
    if (std::ranges::find(types, entry.parameter->type) == types.end())
      throw Error(fmt::format("parameter {} must be of type {}, not {}", Quoted(name),
                              NameOf(*types.begin()), NameOf(entry.parameter->type)),
                  entry.parameter->place);
    entry.used = true;
    return entry.parameter.get();
  }
  return nullptr;
}

// The values of a parameter that has exactly this many.
static const PbrtParameter& Sized(const PbrtParameter& parameter, std::size_t numbers,
                                  std::size_t strings) {
  if (parameter.numbers.size() != numbers || parameter.strings.size() != strings)
    throw Error(fmt::format("parameter {} needs one value", Quoted(parameter.name)),
                parameter.place);
  return parameter;
}

float PbrtParameters::Number(std::string_view name, float absent) const {
  const PbrtParameter* found = Find(name, {PbrtType::Float, PbrtType::Integer});
  return found ? float(Sized(*found, 1, 0).numbers[0]) : absent;
}

float PbrtParameters::Number(std::string_view name, float absent, float least, float most,
                             Findings& findings) const {
  const float value = Number(name, absent);
  if (value >= least && value <= most) return value;
  findings.Add("number", "out of range: set to the nearest sensible one", name, Peek(name)->place);
  return std::clamp(value, least, most);
}

int PbrtParameters::Integer(std::string_view name, int absent) const {
  const PbrtParameter* found = Find(name, {PbrtType::Integer});
  return found ? int(Sized(*found, 1, 0).numbers[0]) : absent;
}

bool PbrtParameters::Bool(std::string_view name, bool absent) const {
  const PbrtParameter* found = Find(name, {PbrtType::Bool});
  return found ? Sized(*found, 1, 0).numbers[0] != 0 : absent;
}

std::string PbrtParameters::String(std::string_view name, std::string_view absent) const {
  const PbrtParameter* found = Find(name, {PbrtType::String});
  return found ? Sized(*found, 0, 1).strings[0] : std::string(absent);
}

glm::dvec3 PbrtParameters::Vector(std::string_view name, const glm::dvec3& absent) const {
  const PbrtParameter* found = Find(name, {PbrtType::Point3, PbrtType::Vector3, PbrtType::Normal});
  if (!found) return absent;
  const std::vector<double>& n = Sized(*found, 3, 0).numbers;
  return {n[0], n[1], n[2]};
}

const std::vector<double>& PbrtParameters::Numbers(std::string_view name, PbrtType type) const {
  static const std::vector<double> none;
  const PbrtParameter* found = Find(name, {type});
  return found ? found->numbers : none;
}

std::vector<std::string> PbrtParameters::Strings(std::string_view name) const {
  const PbrtParameter* found = Find(name, {PbrtType::String});
  return found ? found->strings : std::vector<std::string>();
}

void PbrtParameters::Ignore(std::initializer_list<std::string_view> names) const {
  for (const Entry& entry : entries_)
    if (std::ranges::find(names, entry.parameter->name) != names.end()) entry.used = true;
}

void PbrtParameters::Leave(std::initializer_list<std::string_view> names, std::string_view verdict,
                           Findings& findings) const {
  for (const std::string_view name : names)
    if (const PbrtParameter* found = Peek(name))
      findings.Add(fmt::format("'{}' parameter", name),
                   fmt::format("of {} {}", statement_, verdict), "", found->place);
  Ignore(names);
}

void PbrtParameters::ReportUnused(Findings& findings) const {
  for (const Entry& entry : entries_)
    if (!entry.used && !entry.isDefault)
      findings.Add(fmt::format("{} parameter", Quoted(entry.parameter->name)),
                   fmt::format("not used by {}", statement_), "", entry.parameter->place);
}

}  // namespace snell::io
