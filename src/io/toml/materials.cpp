// SPDX-License-Identifier: Apache-2.0
//
// The materials of a scene: those of tables, laid over their presets, the ready ones that names refer to,
// and the one of objects that name none.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "io/toml/sections.h"
#include "scene/framing.h"

namespace snell::io {

using scene::Material;
using scene::ReflectionModel;
using scene::Term;
using scene::TermKind;

// --- Energy -------------------------------------------------------------------------------------------------

// The largest value of a colour's channel, over all of its texture.
static float Largest(const Reader& reader, const ColorInput& color, int channel) {
  const float value = color.value[channel];
  if (color.texture < 0) return value;
  const scene::Texture& texture = reader.scene.textures[std::size_t(color.texture)];
  return value * std::max(texture.colorA[channel], texture.colorB[channel]);
}

// What the interface leaves to the matt terms at most (kernel/interface.h).
static float MattShare(const Material& material, int channel) {
  const auto least = [&](const ColorInput& color) {
    return color.texture < 0 ? color.value[channel] : 0.0f;
  };
  const float atNormal = (material.ior - 1) / (material.ior + 1);
  const bool fresnel = material.reflection == ReflectionModel::Fresnel;
  const float reflected = least(material.reflectivity) * (fresnel ? atNormal * atNormal : 1);
  return (1 - least(material.transparency)) * (1 - reflected);
}

static void WarnOfGain(Reader& reader, const Material& material, const Place& place) {
  float most = 0;
  for (int channel = 0; channel < 3; ++channel) {
    float sum = 0;
    for (const Term& term : material.terms) {
      const float color = Largest(reader, term.color, channel);
      if (term.kind == TermKind::Diffuse) sum += color * MattShare(material, channel);
      if (term.normalized) sum += color;
    }
    most = std::max(most, sum);
  }
  if (most <= 1.0001f) return;
  const std::string name =
      material.name.empty() ? "this material" : "the material " + QuotedName(material.name);
  reader.Warn(fmt::format("{} gives back more light than it receives: its diffuse and normalized "
                          "specular colours add up to {:.3g}",
                          name, most),
              place, "make the sum 1 or less");
}

// --- Materials ----------------------------------------------------------------------------------------------

static const Preset* FindPreset(std::string_view name) {
  for (const Preset& preset : Presets())
    if (name == preset.name) return &preset;
  return nullptr;
}

// Put the keys of the preset that `fields` names under its own. Returns what owns the preset's keys, null
// if there is no preset. False in `good`: reported.
static std::shared_ptr<const toml::node> ApplyPreset(Reader& reader, Fields& fields, bool& good) {
  const Node::Entry* base = fields.Find("preset");
  const Node::Entry* type = fields.Find("type");
  if (!base) return nullptr;
  if (type) {
    good = false;
    reader.Report(fmt::format("'preset' and 'type' exclude each other in {}", fields.title),
                  std::max(base, type)->place());
    return nullptr;
  }
  const auto name = base->value.String();
  const Preset* preset = name ? FindPreset(*name) : nullptr;
  if (!preset) {
    std::vector<std::string> names;
    for (const Preset& one : Presets()) names.emplace_back(one.name);
    const KeyScope scope(reader, "preset");
    ReadWord(reader, base->value, names);
    good = false;
    return nullptr;
  }
  auto text = ParseToml(preset->toml, preset->name);
  MergeUnder(MaterialSection(), Fields("", Node(text.get())), fields);
  return text;
}

scene::MaterialIndex AddMaterial(Reader& reader, const std::string& name, const Fields& fields) {
  MaterialDraft draft;
  Fields merged = fields;
  bool good = true;
  const auto owner = ApplyPreset(reader, merged, good);
  good = good && ReadTable(reader, MaterialSection(), merged, draft);
  draft.material.name = name;
  if (good) WarnOfGain(reader, draft.material, fields.place);
  reader.scene.materials.push_back(std::move(draft.material));
  return int(reader.scene.materials.size()) - 1;
}

static scene::MaterialIndex AddPreset(Reader& reader, const Preset& preset) {
  const auto text = ParseToml(preset.toml, preset.name);
  const auto index = AddMaterial(reader, preset.name, Fields(preset.name, Node(text.get())));
  reader.materials.emplace(preset.name, index);
  return index;
}

scene::MaterialIndex DefaultMaterial(Reader& reader) {
  static constexpr const char* Name = "(default)";
  const auto [entry, isNew] = reader.materials.emplace(Name, int(reader.scene.materials.size()));
  if (isNew) reader.scene.materials.push_back(scene::DefaultMaterial());
  return entry->second;
}

// --- References ---------------------------------------------------------------------------------------------

static bool ReadMaterialName(Reader& reader, const Node& value, std::string_view name,
                             scene::MaterialIndex& material) {
  if (const auto found = reader.materials.find(name); found != reader.materials.end()) {
    material = found->second;
    return true;
  }
  if (const Preset* preset = FindPreset(name)) {
    material = AddPreset(reader, *preset);
    return true;
  }
  if (!reader.filesMissing) {
    std::vector<std::string> known = NamesOf(reader.materials);
    for (const Preset& one : Presets()) known.emplace_back(one.name);
    reader.Report(fmt::format("unknown material {}", QuotedName(name)), value.place(),
                  Suggestion(name, known));
  }
  return false;
}

Type<scene::MaterialIndex> MaterialNameOrTable() {
  Type<scene::MaterialIndex> type;
  type.expected = "the name of a material or a table";
  type.schema = R"({"anyOf": [{"type": "string"}, {"$ref": "#/definitions/material"}]})";
  type.example = "{ type = \"phong\", diffuse = \"checker\" }";
  type.read = [expected = type.expected](Reader& reader, const Node& value,
                                         scene::MaterialIndex& material) {
    if (const auto name = value.String()) return ReadMaterialName(reader, value, *name, material);
    if (!value.IsTable()) return reader.Refuse(value, expected);
    material = AddMaterial(reader, "", Fields("material", value));
    return true;
  };
  return type;
}

}  // namespace snell::io
