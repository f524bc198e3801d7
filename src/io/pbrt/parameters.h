// SPDX-License-Identifier: Apache-2.0
//
// Parameter lists of pbrt's statements: "type name" followed by a value or by several in brackets. What a
// statement's reader does not ask for is reported.
#pragma once

#include <glm/vec3.hpp>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/findings.h"
#include "io/pbrt/words.h"
#include "util/error.h"

namespace snell::io {

enum class PbrtType {
  Integer,
  Float,
  Point2,
  Vector2,
  Point3,
  Vector3,
  Normal,
  Rgb,
  Blackbody,
  Spectrum,
  Bool,
  String,
  Texture
};

struct PbrtParameter {
  PbrtType type = PbrtType::Float;
  std::string name;
  std::vector<double> numbers;  // also of bools, as 0 and 1
  std::vector<std::string> strings;
  Place place;
};

// What stands in an Attribute statement for all statements of a kind that follow.
using PbrtDefaults = std::vector<std::shared_ptr<const PbrtParameter>>;

class PbrtParameters {
 public:
  PbrtParameters() = default;
  // Reads parameters as long as there are some. `statement` names what they belong to, in messages. Throws
  // Error at the word that does not fit.
  PbrtParameters(PbrtWords& words, std::string statement, const Place& place);

  void AddDefaults(const PbrtDefaults& defaults);
  const std::string& statement() const { return statement_; }
  void set_statement(std::string statement) { statement_ = std::move(statement); }
  const Place& place() const { return place_; }
  PbrtDefaults All() const;

  // A parameter by name, or null. Throws Error if it is of a type that `types` does not have.
  const PbrtParameter* Find(std::string_view name, std::initializer_list<PbrtType> types) const;
  // The parameter, of whatever type, or null; not marked as used.
  const PbrtParameter* Peek(std::string_view name) const;
  bool Has(std::string_view name) const { return Peek(name) != nullptr; }

  // Throw Error if there is not exactly one value, or it is not finite as a float.
  float Number(std::string_view name, float absent) const;
  // The same, within limits: clamped with a finding.
  float Number(std::string_view name, float absent, float least, float most,
               Findings& findings) const;
  int Integer(std::string_view name, int absent) const;
  bool Bool(std::string_view name, bool absent) const;
  std::string String(std::string_view name, std::string_view absent) const;
  glm::dvec3 Vector(std::string_view name, const glm::dvec3& absent) const;
  // All values; empty if there are none.
  const std::vector<double>& Numbers(std::string_view name, PbrtType type) const;
  std::vector<std::string> Strings(std::string_view name) const;

  // Marks parameters as known though nothing is made of them.
  void Ignore(std::initializer_list<std::string_view> names) const;
  // The same, with a finding for each that is there: "'x' parameter of Shape 'y'", `verdict`.
  void Leave(std::initializer_list<std::string_view> names, std::string_view verdict,
             Findings& findings) const;
  // A finding for each parameter that nobody has asked for.
  void ReportUnused(Findings& findings) const;

 private:
  struct Entry {
    std::shared_ptr<const PbrtParameter> parameter;
    bool isDefault = false;
    mutable bool used = false;
  };
  void Read(PbrtWords& words);

  std::string statement_;
  Place place_;
  std::vector<Entry> entries_;
};

std::string_view NameOf(PbrtType type);

}  // namespace snell::io
