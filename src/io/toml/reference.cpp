// SPDX-License-Identifier: Apache-2.0
//
// The reference page of the scene language in Markdown: an introduction and notes, which are written here,
// and a table of keys for every section, which come from the sections themselves.
#include <fmt/format.h>

#include <cctype>
#include <tuple>

#include "io/toml/scene.h"
#include "io/toml/sections.h"

namespace snell::io {

namespace {

const char* const Introduction = R"(# The scene language

A Snell scene is a text file in [TOML](https://toml.io), `NAME.toml`. This one shows a glass ball on a
checkered floor:

```toml
[camera]
position = [0, 1.5, 6]
look_at = [0, 1, 0]

[[light]]
type = "point"
position = [3, 5, 4]
intensity = 60

[[object]]
shape = "plane"
material = { type = "phong", diffuse = "checker" }

[[object]]
shape = "sphere"
center = [0, 1, 0]
material = "glass"
```

`snell render NAME.toml -o picture.png` renders it, `snell check NAME.toml` only looks for mistakes. All of
them are reported at once, each with file, line and column; an unknown key is a mistake too. Editors that
know JSON Schema complete and check scenes as you type with `snell-scene.schema.json`, which stands beside
this page; with the TOML language server Taplo, for example, by a first line
`#:schema PATH/snell-scene.schema.json`.

This page is made from the table that the reader itself works by (`snell reference --markdown`).

)";

const char* const Values = R"(## Values

**Units** are metres, degrees, watts. The space is right-handed with y up. The tables below name the unit of
each key; numbers may be written with or without a decimal point. Infinity and NaN are refused.

**Colours** are linear Rec.709 and written in one of three ways:

| written | means |
|---|---|
| `[0.8, 0.2, 0.1]` | red, green, blue, linear |
| `0.5` | the same for all three |
| `"#c01818"`, `"#fa0"` | as in CSS and paint programs: sRGB, decoded to linear |

Where a table says *colour or texture*, the value may also be the name of a texture, `"checker"`, which is a
`[texture.checker]` of the scene or else the ready texture of that type; or a texture with a colour that
multiplies it: `{ texture = "marble", tint = "#ffd0a0" }`. Reflectances lie between 0 and 1; the colours of
lights, of the environment and of `emission` may be of any strength.

**Files** are named relative to the file that names them and must lie in the folder of the scene or in
folders inside it, or in one that `--allow FOLDER` adds; symbolic links that lead elsewhere are refused.
Includes may be nested 16 deep; a file that is included twice counts once. No material,
texture or group may be defined twice.

**Transforms** are given by `scale`, `rotate` and `translate`, which are applied in this order, or by a list
of steps that are applied from first to last:

```toml
scale = [1, 2, 1]
rotate = { axis = "y", angle = 30 }
translate = [0, 1, 0]

transform = [{ translate = [1, 0, 0] }, { rotate = { axis = "y", angle = 90 } }]
```

Transforms of nested groups multiply, the outer ones last. Mirroring and uneven scales are allowed
everywhere, but not scales of 0.

)";

const char* const PresetNotes = R"(## Ready materials

These names can be used as materials at once, and as a `preset` to start from:

```toml
[material.red_plastic]
preset = "plastic"
diffuse = "#c01818"
```

A scene's own material of the same name comes first.

)";

// --- Tables of keys -----------------------------------------------------------------------------------------

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string Code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

std::string WithoutArticle(const std::string& text) {
  for (const char* article : {"a ", "an ", "the "})
    if (text.starts_with(article)) return text.substr(std::string(article).size());
  return text;
}

// The default of a key; where the variants differ, each with its name.
std::string Default(const Section& section, const Variant* variant, const Key& key) {
  if (key.required) return "required";
  if (!key.standard.empty()) return key.standard;
  const std::string standard = DefaultOf(section, variant, key);
  if (variant) return Code(standard);
  std::string text;
  std::string last = standard;
  for (const Variant& one : section.variants) {
    const std::string value = DefaultOf(section, &one, key);
    if (value != standard) text += fmt::format("; {}: {}", one.Title(), Code(value));
  }
  return Code(last) + text;
}

std::string TableOfKeys(const Section& section, const Variant* variant,
                        const std::vector<Key>& keys) {
  if (keys.empty()) return "";
  std::string table = "| key | value | unit | default | what it does |\n|---|---|---|---|---|\n";
  for (const Key& key : keys)
    table += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name,
                         Escaped(WithoutArticle(key.expected)), key.unit,
                         Escaped(Default(section, variant, key)), Escaped(key.text));
  return table + "\n";
}

// --- Sections -----------------------------------------------------------------------------------------------

std::string TitleOf(const Section& section) {
  return section.title == FileSection().title ? section.title : Code(section.title);
}

// "`type` is one of …", for sections whose variants are chosen by a word.
std::string ChoiceOf(const Section& section) {
  std::string words;
  std::string selector;
  for (const Variant& variant : section.variants) {
    if (variant.name.empty()) continue;
    selector = variant.selector;
    words += (words.empty() ? "" : ", ") + Code(variant.name);
    if (variant.name == section.standard) words += " (the default)";
  }
  return words.empty() ? "" : fmt::format("`{}` is one of {}.\n\n", selector, words);
}

std::string SectionText(const Section& section) {
  std::string text = fmt::format("## {}\n\n{}\n\n", TitleOf(section), section.text);
  text += ChoiceOf(section);
  if (!section.variants.empty() && !section.keys.empty()) text += "Keys of all kinds:\n\n";
  text += TableOfKeys(section, nullptr, section.keys);
  std::string lastKeys, lastChoice;
  for (const Variant& variant : section.variants) {
    const std::string choice = variant.name.empty()
                                   ? Code(variant.selector + " = …")
                                   : fmt::format("`{} = \"{}\"`", variant.selector, variant.name);
    text += fmt::format("### {}\n\n{}\n\n", choice, variant.text);
    const std::string keys = TableOfKeys(section, &variant, variant.keys);
    const bool same = !keys.empty() && keys == lastKeys;
    text += same ? fmt::format("The same keys as with {}.\n\n", lastChoice) : keys;
    if (!same) std::tie(lastKeys, lastChoice) = std::tie(keys, choice);
  }
  return text;
}

// A link to a heading; anchors are made as GitHub makes them.
std::string LinkTo(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') anchor += char(std::tolower(c));
    if (c == ' ') anchor += '-';
  }
  return fmt::format("[{}](#{})", heading, anchor);
}

std::string TableOfContents() {
  std::string text = "Contents: " + LinkTo("Values");
  for (const Section* section : AllSections()) text += ", " + LinkTo(TitleOf(*section));
  return text + ", " + LinkTo("Ready materials") + ".\n\n";
}

std::string PresetTable() {
  std::string text = PresetNotes;
  text += "| name | what it is | the same as |\n|---|---|---|\n";
  for (const Preset& preset : Presets()) {
    std::string keys = preset.toml;
    for (std::size_t at = keys.find('\n'); at != std::string::npos; at = keys.find('\n'))
      keys.replace(at, 1, ", ");
    text += fmt::format("| `{}` | {} | `{}` |\n", preset.name, preset.text, keys);
  }
  return text;
}

}  // namespace

std::string SceneReferenceMarkdown() {
  std::string page = Introduction;
  page += TableOfContents();
  page += Values;
  for (const Section* section : AllSections()) page += SectionText(*section);
  return page + PresetTable();
}

}  // namespace snell::io
