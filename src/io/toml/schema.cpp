// SPDX-License-Identifier: Apache-2.0
//
// The scene language as a JSON Schema (draft 7), which editors use to complete and check TOML. Each section
// becomes a definition: the keys of all its variants as properties, and for each variant a condition that
// narrows them. What a schema cannot say (degenerate shapes, unknown names) is left to the reader.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/toml/scene.h"
#include "io/toml/sections.h"

namespace snell::io {

namespace {

// --- JSON as text -------------------------------------------------------------------------------------------

std::string Join(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string Array(const std::vector<std::string>& parts) { return "[" + Join(parts) + "]"; }

std::string Object(const std::vector<std::string>& members) { return "{" + Join(members) + "}"; }

std::string String(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return quoted + "\"";
}

std::string Strings(const std::vector<std::string>& texts) {
  std::vector<std::string> parts;
  for (const std::string& text : texts) parts.push_back(String(text));
  return Array(parts);
}

std::string Member(const std::string& name, const std::string& value) {
  return String(name) + ": " + value;
}

// Lays JSON out in lines: what fits into one line stays in one.
class Layout {
 public:
  explicit Layout(const std::string& json) : json_(json) {}

  std::string Print() {
    Value(0);
    return out_ + "\n";
  }

 private:
  static constexpr std::size_t Width = 100;

  // The end of the value that starts here.
  std::size_t End(std::size_t at) const {
    int depth = 0;
    for (; at < json_.size(); ++at) {
      const char c = json_[at];
      if (c == '"') {
        for (++at; json_[at] != '"'; ++at) at += json_[at] == '\\' ? 1 : 0;
      } else if (c == '{' || c == '[') {
        ++depth;
      } else if ((c == '}' || c == ']') && depth-- == 0) {
        break;
      } else if (c == ',' && depth == 0) {
        break;
      }
      if ((c == '}' || c == ']') && depth == 0) return at + 1;
    }
    return at;
  }

  void Value(std::size_t indent) {
    SkipSpace();
    if (json_[at_] == '"') Name();
    const std::size_t end = End(at_);
    const bool isList = json_[at_] == '{' || json_[at_] == '[';
    const std::size_t column = out_.size() - (out_.rfind('\n') + 1);
    if (!isList || column + end - at_ < Width) {
      for (; at_ < end; ++at_)
        if (json_[at_] != '\n') out_ += json_[at_];
      return;
    }
    out_ += json_[at_++];
    while (json_[at_ - 1] != '}' && json_[at_ - 1] != ']') {
      out_ += "\n" + std::string(indent + 2, ' ');
      Value(indent + 2);
      SkipSpace();
      if (json_[at_] == ',') out_ += ',';
      if (json_[at_] != ',') out_ += "\n" + std::string(indent, ' ') + json_[at_];
      ++at_;
    }
  }

  // Copy `"name": ` if a member starts here.
  void Name() {
    std::size_t end = at_ + 1;
    while (json_[end] != '"') end += json_[end] == '\\' ? 2 : 1;
    if (json_[end + 1] != ':') return;
    out_ += json_.substr(at_, end + 1 - at_) + ": ";
    at_ = end + 2;
    SkipSpace();
  }

  void SkipSpace() {
    while (json_[at_] == ' ' || json_[at_] == '\n') ++at_;
  }

  const std::string& json_;
  std::size_t at_ = 0;
  std::string out_;
};

// --- Sections -----------------------------------------------------------------------------------------------

// `schema` with a description; a reference may not have siblings.
std::string Described(const std::string& schema, std::vector<std::string> members) {
  if (schema.starts_with("{\"$ref\""))
    members.push_back(Member("allOf", Array({schema})));
  else
    members.push_back(schema.substr(1, schema.size() - 2));
  return Object(members);
}

std::string PropertyOf(const Section& section, const Variant* variant, const Key& key) {
  const std::string unit = key.unit.empty() ? "" : " In " + key.unit + ".";
  std::vector<std::string> members = {Member("description", String(key.text + unit))};
  const std::string standard = key.standard.empty() ? DefaultOf(section, variant, key) : "";
  if (!standard.empty() && !key.required) members.push_back(Member("default", standard));
  return Described(key.schema, std::move(members));
}

std::string Has(const std::string& key) { return Object({Member("required", Strings({key}))}); }

std::string HasAny(const std::vector<std::string>& keys) {
  std::vector<std::string> parts;
  for (const std::string& key : keys) parts.push_back(Has(key));
  return Object({Member("anyOf", Array(parts))});
}

std::string Not(const std::string& schema) { return Object({Member("not", schema)}); }

class SectionSchema {
 public:
  explicit SectionSchema(const Section& section) : section_(section) {}

  std::vector<std::string> Members() {
    Properties();
    for (const Variant& variant : section_.variants) VariantRule(variant);
    SelectorRule();
    for (const Either& either : section_.eithers) EitherRules(either);

    std::vector<std::string> members = {
        Member("type", String("object")), Member("description", String(section_.text)),
        Member("properties", Object(properties_)), Member("additionalProperties", "false")};
    if (const auto names = Required(section_.keys); !names.empty())
      members.push_back(Member("required", Strings(names)));
    if (!rules_.empty()) members.push_back(Member("allOf", Array(rules_)));
    return members;
  }

 private:
  static std::vector<std::string> Required(const std::vector<Key>& keys) {
    std::vector<std::string> names;
    for (const Key& key : keys)
      if (key.required) names.push_back(key.name);
    return names;
  }

  // The selectors of the variants, such as `shape` and `file`, and the words of each.
  std::vector<std::pair<std::string, std::vector<std::string>>> Selectors() const {
    std::vector<std::pair<std::string, std::vector<std::string>>> selectors;
    for (const Variant& variant : section_.variants) {
      auto found = std::find_if(selectors.begin(), selectors.end(), [&](const auto& selector) {
        return selector.first == variant.selector;
      });
      if (found == selectors.end()) found = selectors.insert(found, {variant.selector, {}});
      if (!variant.name.empty()) found->second.push_back(variant.name);
    }
    return selectors;
  }

  // All keys; one that differs between variants is any of its forms.
  void Properties() {
    for (const auto& [selector, words] : Selectors())
      if (!words.empty())
        properties_.push_back(Member(selector, Object({Member("enum", Strings(words))})));
    for (const Key& key : section_.keys)
      properties_.push_back(Member(key.name, PropertyOf(section_, nullptr, key)));
    std::vector<std::string> done;
    for (const Variant& variant : section_.variants) {
      for (const Key& key : variant.keys) {
        if (std::find(done.begin(), done.end(), key.name) != done.end()) continue;
        done.push_back(key.name);
        const std::vector<std::string> forms = Forms(key.name);
        properties_.push_back(Member(
            key.name, forms.size() == 1 ? forms[0] : Object({Member("anyOf", Array(forms))})));
      }
    }
  }

  std::vector<std::string> Forms(const std::string& name) const {
    std::vector<std::string> forms;
    for (const Variant& variant : section_.variants) {
      for (const Key& key : variant.keys) {
        if (key.name != name) continue;
        const std::string form = PropertyOf(section_, &variant, key);
        if (std::find(forms.begin(), forms.end(), form) == forms.end()) forms.push_back(form);
      }
    }
    return forms;
  }

  std::string IsVariant(const Variant& variant) const {
    const std::string isChosen =
        variant.name.empty()
            ? Has(variant.selector)
            : Object({Member("required", Strings({variant.selector})),
                      Member("properties",
                             Object({Member(variant.selector,
                                            Object({Member("const", String(variant.name))}))}))});
    if (variant.name.empty() || variant.name != section_.standard) return isChosen;
    std::vector<std::string> choosing = {variant.selector};
    if (!section_.base.empty()) choosing.push_back(section_.base);
    return Object({Member("anyOf", Array({isChosen, Not(HasAny(choosing))}))});
  }

  void VariantRule(const Variant& variant) {
    std::vector<std::string> names = {variant.selector};
    std::vector<std::string> own;
    for (const Key& key : section_.keys) names.push_back(key.name);
    for (const Key& key : variant.keys) {
      if (key.name != variant.selector) names.push_back(key.name);
      if (Forms(key.name).size() > 1)
        own.push_back(Member(key.name, PropertyOf(section_, &variant, key)));
    }
    std::vector<std::string> then = {
        Member("propertyNames", Object({Member("enum", Strings(names))}))};
    if (const auto required = Required(variant.keys); !required.empty())
      then.push_back(Member("required", Strings(required)));
    if (!own.empty()) then.push_back(Member("properties", Object(own)));
    rules_.push_back(Object({Member("if", IsVariant(variant)), Member("then", Object(then))}));
  }

  // Exactly one selector, where one is needed; none beside the base.
  void SelectorRule() {
    if (section_.variants.empty()) return;
    std::vector<std::string> choices;
    for (const auto& [selector, words] : Selectors()) choices.push_back(Has(selector));
    if (section_.standard.empty()) rules_.push_back(Object({Member("oneOf", Array(choices))}));
    if (!section_.base.empty())
      rules_.push_back(Not(
          Object({Member("required", Strings({section_.variants[0].selector, section_.base}))})));
  }

  void EitherRules(const Either& either) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < either.sides.size(); ++i) {
      all.insert(all.end(), either.sides[i].begin(), either.sides[i].end());
      for (std::size_t j = i + 1; j < either.sides.size(); ++j)
        rules_.push_back(Not(
            Object({Member("allOf", Array({HasAny(either.sides[i]), HasAny(either.sides[j])}))})));
    }
    if (either.required) rules_.push_back(HasAny(all));
  }

  const Section& section_;
  std::vector<std::string> properties_;
  std::vector<std::string> rules_;
};

// --- Colours ------------------------------------------------------------------------------------------------

std::string ColorSchema(const char* limit) {
  return fmt::format(R"({{"anyOf": [{{"type": "number", "minimum": 0{0}}},
      {{"type": "array", "items": {{"type": "number", "minimum": 0{0}}}, "minItems": 3, "maxItems": 3}},
      {{"type": "string", "pattern": "^#([0-9a-fA-F]{{3}}){{1,2}}$"}}]}})",
                     limit);
}

std::string OrTexture(const char* color) {
  return fmt::format(
      R"({{"anyOf": [{{"$ref": "#/definitions/{}"}}, {{"type": "string", "pattern": "^[^#]"}},
      {{"$ref": "#/definitions/tint"}}]}})",
      color);
}

}  // namespace

std::string SceneJsonSchema() {
  std::vector<std::string> definitions = {Member("color", ColorSchema("")),
                                          Member("reflectance", ColorSchema(", \"maximum\": 1")),
                                          Member("colorOrTexture", OrTexture("color")),
                                          Member("reflectanceOrTexture", OrTexture("reflectance"))};
  for (const Section* section : AllSections())
    if (section != &FileSection())
      definitions.push_back(Member(section->name, Object(SectionSchema(*section).Members())));

  std::vector<std::string> root = {
      Member("$schema", String("http://json-schema.org/draft-07/schema#")),
      Member("title", String("Snell scene"))};
  for (const std::string& member : SectionSchema(FileSection()).Members()) root.push_back(member);
  root.push_back(Member("definitions", Object(definitions)));
  return Layout(Object(root)).Print();
}

}  // namespace snell::io
