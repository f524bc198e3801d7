// SPDX-License-Identifier: Apache-2.0
//
// How transforms are written: `scale`, `rotate` and `translate` as keys, or steps in a list. All maps are
// made in double precision; rotations by multiples of 90 degrees are exact.
#include <fmt/format.h>

#include <cmath>
#include <glm/matrix.hpp>

#include "io/toml/sections.h"

namespace snell::io {

using glm::dvec3;
using glm::dvec4;

// --- The maps -----------------------------------------------------------------------------------------------

static Affine FromColumns(const dvec3& x, const dvec3& y, const dvec3& z, const dvec3& origin) {
  return Affine(dvec4(x, 0.0), dvec4(y, 0.0), dvec4(z, 0.0), dvec4(origin, 1.0));
}

static Affine Scale(const dvec3& s) {
  return FromColumns(dvec3(s.x, 0, 0), dvec3(0, s.y, 0), dvec3(0, 0, s.z), dvec3(0.0));
}

static Affine Translate(const dvec3& t) {
  return FromColumns(dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), t);
}

// Rodrigues' formula, column by column.
static Affine Rotate(const Rotation& rotation) {
  const dvec3 axis = glm::normalize(rotation.axis);
  int quadrants = 0;
  const double rest = std::remquo(rotation.degrees, 90.0, &quadrants) * (std::acos(-1.0) / 180.0);
  const double sines[4] = {std::sin(rest), std::cos(rest), -std::sin(rest), -std::cos(rest)};
  const double sine = sines[quadrants & 3];
  const double cosine = sines[(quadrants + 1) & 3];
  const auto turned = [&](const dvec3& v) {
    return v * cosine + glm::cross(axis, v) * sine + axis * (glm::dot(axis, v) * (1 - cosine));
  };
  return FromColumns(turned(dvec3(1, 0, 0)), turned(dvec3(0, 1, 0)), turned(dvec3(0, 0, 1)),
                     dvec3(0.0));
}

// Puts the origin at `from` and turns +z to `to` and +y to the side of `up`.
static Affine Look(const LookAt& look) {
  const dvec3 from(look.from);
  const dvec3 z = glm::normalize(dvec3(look.to) - from);
  const dvec3 x = glm::normalize(glm::cross(dvec3(look.up), z));
  return FromColumns(x, glm::cross(z, x), z, from);
}

bool HaveNoArea(const vec3& u, const vec3& v) {
  const dvec3 a(u), b(v);
  return !(glm::length(glm::cross(a, b)) > 1e-7 * glm::length(a) * glm::length(b));
}

bool IsUsable(const Affine& map, std::string& reason) {
  static constexpr double Smallest = 1e-15;
  static constexpr double Largest = 1e15;
  double volume = 1;
  for (int column = 0; column < 3; ++column) {
    const double length = glm::length(dvec3(map[column]));
    volume *= length;
    reason = fmt::format("it scales by {:.3g}; the limits are {:.0e} and {:.0e}", length, Smallest,
                         Largest);
    if (!(length >= Smallest && length <= Largest)) return false;
  }
  reason = "it flattens all things";
  if (!(std::abs(glm::determinant(glm::dmat3(map))) > 1e-12 * volume)) return false;
  const double distance = glm::length(dvec3(map[3]));
  reason = fmt::format("it moves things by {:.3g} m; the limit is {:.0e}", distance, Largest);
  return distance <= Largest;
}

// --- The values ---------------------------------------------------------------------------------------------

static bool ReadVector(Reader& reader, const Node& value, const std::string& expected,
                       dvec3& vector) {
  double v[3];
  if (!ReadNumbers(reader, value, Any, expected, v, 3)) return false;
  vector = dvec3(v[0], v[1], v[2]);
  return true;
}

static Type<Affine> Scaling() {
  Type<Affine> type;
  type.expected = "a number or 3 numbers, none of them 0";
  type.schema = R"({"anyOf": [{"type": "number", "not": {"const": 0}},
      {"type": "array", "items": {"type": "number", "not": {"const": 0}}, "minItems": 3, "maxItems": 3}]})";
  type.example = "[2, 0.5, 1.5]";
  type.read = [expected = type.expected](Reader& reader, const Node& value, Affine& map) {
    dvec3 factors;
    if (value.Number()) {
      double factor = 0;
      if (!ReadNumber(reader, value, Any, expected, factor)) return false;
      factors = dvec3(factor);
    } else if (!ReadVector(reader, value, expected, factors)) {
      return false;
    }
    if (factors.x == 0 || factors.y == 0 || factors.z == 0) {
      reader.Report(fmt::format("'{}': expected {}", reader.key, expected), value.place(),
                    "a scale of 0 flattens all things");
      return false;
    }
    map = Scale(factors);
    return true;
  };
  type.write = [](const Affine& map) {
    const bool uniform = map[0][0] == map[1][1] && map[0][0] == map[2][2];
    return uniform ? fmt::format("{}", map[0][0])
                   : fmt::format("[{}, {}, {}]", map[0][0], map[1][1], map[2][2]);
  };
  return type;
}

static Type<Affine> Translation() {
  Type<Affine> type;
  type.expected = "3 numbers";
  type.unit = "m";
  type.schema = R"({"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3})";
  type.example = "[1, 0, -2]";
  type.read = [](Reader& reader, const Node& value, Affine& map) {
    dvec3 offset;
    if (!ReadVector(reader, value, "3 numbers", offset)) return false;
    map = Translate(offset);
    return true;
  };
  type.write = [](const Affine& map) {
    return fmt::format("[{}, {}, {}]", map[3][0], map[3][1], map[3][2]);
  };
  return type;
}

// One { axis, angle } or a list of them, the first applied first.
static Type<Affine> Turning() {
  Type<Affine> type;
  type.expected = "{ axis, angle } or a list of such";
  type.unit = "degrees";
  type.schema = R"({"anyOf": [{"$ref": "#/definitions/rotation"},
      {"type": "array", "items": {"$ref": "#/definitions/rotation"}}]})";
  type.example = R"([{ axis = "y", angle = 30 }, { axis = [1, 1, 0], angle = -15 }])";
  type.read = [expected = type.expected](Reader& reader, const Node& value, Affine& map) {
    const auto readOne = [&](const Node& table) {
      if (!table.IsTable()) return reader.Refuse(table, expected);
      Rotation rotation;
      if (!ReadTable(reader, RotationSection(), Fields("rotate", table), rotation)) return false;
      map = Rotate(rotation) * map;
      return true;
    };
    map = Affine(1.0);
    if (!value.IsArray()) return readOne(value);
    for (std::size_t i = 0; i < value.size(); ++i)
      if (!readOne(value[i])) return false;
    return true;
  };
  return type;
}

static Type<Affine> Looking() {
  const Type<LookAt> table = TableOf(LookAtSection, "{ from, to, up }");
  Type<Affine> type;
  type.expected = table.expected;
  type.unit = "m";
  type.schema = table.schema;
  type.example = "{ from = [0, 1, 4], to = [0, 1, 0] }";
  type.read = [read = table.read](Reader& reader, const Node& value, Affine& map) {
    LookAt look;
    if (!read(reader, value, look)) return false;
    map = Look(look);
    return true;
  };
  return type;
}

static Type<Affine> Matrix() {
  Type<Affine> type;
  type.expected = "12 or 16 numbers, row by row";
  type.schema = R"({"type": "array", "items": {"type": "number"}, "minItems": 12, "maxItems": 16})";
  type.example = "[1, 0, 0, 2,  0, 1, 0.5, 0,  0, 0, 1, 0]";
  type.read = [expected = type.expected](Reader& reader, const Node& value, Affine& map) {
    double m[16] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    if (!value.IsArray() || (value.size() != 12 && value.size() != 16))
      return reader.Refuse(value, expected);
    if (!ReadNumbers(reader, value, Any, expected, m, value.size())) return false;
    std::string reason = "the last row is not 0, 0, 0, 1";
    const bool affine = m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1;
    Affine result(1.0);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) result[column][row] = m[4 * row + column];
    if (!affine || !IsUsable(result, reason)) {
      reader.Report(fmt::format("'{}': this matrix cannot be used: {}", reader.key, reason),
                    value.place());
      return false;
    }
    map = result;
    return true;
  };
  return type;
}

static Type<Affine> Steps() {
  const auto list = ListOf(
      TableOf(TransformStepSection, "{ translate, rotate, scale, look_at or matrix }"), "steps");
  Type<Affine> type;
  type.expected = "a list of steps";
  type.schema = list.schema;
  type.example =
      "[{ scale = 2 }, { look_at = { from = [0, 0, 0], to = [1, 0, 0] } }, { translate = [0, 1, 0] "
      "}]";
  type.read = [read = list.read](Reader& reader, const Node& value, Affine& map) {
    std::vector<TransformStep> steps;
    if (!read(reader, value, steps)) return false;
    map = Affine(1.0);
    for (const TransformStep& step : steps) map = step.map * map;
    return true;
  };
  return type;
}

static Type<dvec3> Axis() {
  Type<dvec3> type;
  type.expected = "\"x\", \"y\", \"z\" or 3 numbers, not all 0";
  type.schema = R"({"anyOf": [{"enum": ["x", "y", "z"]},
      {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}]})";
  type.example = "[0, 1, 1]";
  type.read = [expected = type.expected](Reader& reader, const Node& value, dvec3& axis) {
    if (const auto text = value.String()) {
      const int index = ReadWord(reader, value, {"x", "y", "z"});
      if (index >= 0) axis = dvec3(index == 0, index == 1, index == 2);
      return index >= 0;
    }
    if (!ReadVector(reader, value, expected, axis)) return false;
    if (axis != dvec3(0.0)) return true;
    reader.Report(fmt::format("'{}': expected {}", reader.key, expected), value.place());
    return false;
  };
  return type;
}

static Type<double> AngleInDegrees() {
  Type<double> type;
  type.expected = "a number";
  type.unit = "degrees";
  type.schema = R"({"type": "number"})";
  type.example = "45";
  type.read = [](Reader& reader, const Node& value, double& degrees) {
    return ReadNumber(reader, value, Any, "a number", degrees);
  };
  return type;
}

// --- The sections -------------------------------------------------------------------------------------------

const SectionOf<Rotation>& RotationSection() {
  static const SectionOf<Rotation> section(
      "rotation", "rotate", "A turn about an axis through the origin, by the right-hand rule.",
      {Field("axis", &Rotation::axis, Axis(), "What to turn about.").Required(),
       Field("angle", &Rotation::degrees, AngleInDegrees(), "How far to turn.").Required()});
  return section;
}

static void CheckLookAt(Reader& reader, const Fields& fields, LookAt& look) {
  const dvec3 forward = dvec3(look.to) - dvec3(look.from);
  if (look.from == look.to) {
    reader.Report("'to' is the same point as 'from' in look_at", fields.PlaceOf("to"));
  } else if (glm::length(glm::cross(glm::normalize(forward), glm::normalize(dvec3(look.up)))) <
             1e-6) {
    reader.Report("'up' is parallel to the line of sight in look_at", fields.PlaceOf("up"));
  }
}

const SectionOf<LookAt>& LookAtSection() {
  static const SectionOf<LookAt> section =
      SectionOf<LookAt>("look_at", "look_at",
                        "Moves the origin to a point and turns the +z axis, the front of most "
                        "models, to another.",
                        {Field("from", &LookAt::from, Point(), "Where the origin goes.")
                             .Required()
                             .Example("[0, 0, 0]"),
                         Field("to", &LookAt::to, Point(), "Where the +z axis points.")
                             .Required()
                             .Example("[1, 0, 1]"),
                         Field("up", &LookAt::up, NotZero(""), "The +y axis leans to this side.")
                             .Example("[0, 1, 0.5]")})
          .Checked(CheckLookAt);
  return section;
}

const SectionOf<TransformStep>& TransformStepSection() {
  static const SectionOf<TransformStep> section =
      SectionOf<TransformStep>(
          "step", "transform", "One step of `transform`: exactly one of these keys.",
          {Field("translate", &TransformStep::map, Translation(), "Moves.")
               .Not({"move", "position", "translation"}),
           Field("rotate", &TransformStep::map, Turning(), "Turns.").Not({"rotation", "turn"}),
           Field("scale", &TransformStep::map, Scaling(),
                 "Stretches, along each axis by its own factor if there are three; a negative one "
                 "mirrors.")
               .Not({"scaling", "size"}),
           Field("look_at", &TransformStep::map, Looking(), "Moves and aims.").Not({"lookat"}),
           Field("matrix", &TransformStep::map, Matrix(), "Any affine map; points are columns.")})
          .OnlyOne({{"translate"}, {"rotate"}, {"scale"}, {"look_at"}, {"matrix"}}, true);
  return section;
}

Keys<Placement> PlacementKeys() {
  return {Field("scale", &Placement::scale, Scaling(), "Stretches, before turning and moving.")
              .Not({"size", "scaling"}),
          Field("rotate", &Placement::rotate, Turning(), "Turns, after scaling and before moving.")
              .Standard("none")
              .Not({"rotation"}),
          Field("translate", &Placement::translate, Translation(), "Moves, last of the three.")
              .Not({"position", "translation", "move", "offset"}),
          Field("transform", &Placement::steps, Steps(),
                "Steps that are applied from first to last, in place of the three keys above.")
              .Standard("none")
              .Not({"transforms", "matrix"})};
}

}  // namespace snell::io
