// SPDX-License-Identifier: Apache-2.0
//
// The table of the scene language against the reader: every key that it names is accepted with its example
// and its default, and every usual mistake leads to a key.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/toml/sections.h"
#include "io/toml/test_scene.h"
#include "util/file.h"

namespace snell::io {
namespace {

// How a file looks with a table of each section; `$` stands for its keys.
const std::map<std::string, std::string> Frames = {
    {"render", "[render]\n$"},
    {"camera", "[camera]\n$"},
    {"environment", "[environment]\n$"},
    {"sky", "[environment]\nsky = { $ }"},
    {"light", "[[light]]\n$"},
    {"object", "[[object]]\n$\n[group.tree]"},
    {"mesh", "[[object]]\nmesh = { $ }"},
    {"step", "[[object]]\nshape = \"box\"\ntransform = [{ $ }]"},
    {"rotation", "[[object]]\nshape = \"box\"\nrotate = { $ }"},
    {"look_at", "[[object]]\nshape = \"box\"\ntransform = [{ look_at = { $ } }]"},
    {"material", "[material.m]\n$"},
    {"subdivision", "[[object]]\nfile = \"bunny.ply\"\nsubdivision = { $ }"},
    {"crease",
     "[[object]]\nmesh = { positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = "
     "[[0, 1, 2]], creases = [{ $ }] }"},
    {"displacement", "[material.m]\ndisplacement = { $ }"},
    {"term", "[material.m]\nterms = [{ $ }]"},
    {"texture", "[texture.t]\n$"},
    {"shape_key", "[[object]]\nfile = \"bunny.ply\"\ndeformation = [{ $ }, { time = 2 }]"},
    {"motion_key", "[[object]]\nshape = \"box\"\nmotion = [{ $ }, { time = 2 }]"},
    {"camera_key", "[camera]\nmotion = [{ $ }, { time = 2 }]"},
    {"medium", "[environment]\nmedium = { $ }"},
    {"channel", "[material.m]\ntype = \"openpbr\"\nspecular_roughness = { $ }"},
    {"tint", "[material.m]\ntype = \"phong\"\ndiffuse = { $ }"}};

// A key with the section and the variant (or null) that it stands in.
struct Case {
  const Section* section;
  const Variant* variant;
  const Key* key;

  std::string Name() const {
    return fmt::format("{} {} {}", section->name, variant ? variant->Title() : "", key->name);
  }
};

std::vector<Case> AllCases() {
  std::vector<Case> cases;
  for (const Section* section : AllSections()) {
    if (!Frames.contains(section->name)) continue;
    std::vector<const Variant*> variants;
    for (const Variant& variant : section->variants) variants.push_back(&variant);
    if (variants.empty()) variants.push_back(nullptr);
    for (const Variant* variant : variants) {
      for (const Key& key : section->keys) cases.push_back({section, variant, &key});
      if (!variant) continue;
      for (const Key& key : variant->keys) cases.push_back({section, variant, &key});
    }
  }
  return cases;
}

// A file with this key, and what else its table needs.
std::string FileWith(const Case& one, const std::string& name, const std::string& value) {
  std::map<std::string, std::string> keys;
  const auto add = [&](const Key& key) { keys.emplace(key.name, key.example); };
  if (name != "preset" && one.variant && !one.variant->name.empty())
    keys[one.variant->selector] = InQuotes(one.variant->name);
  std::vector<const Key*> known;
  for (const Key& key : one.section->keys) known.push_back(&key);
  if (one.variant)
    for (const Key& key : one.variant->keys) known.push_back(&key);
  for (const Key* key : known)
    if (key->required) add(*key);
  for (const Either& either : one.section->eithers) {
    const auto given = [&](const auto& side) { return side[0] == name; };
    if (!either.required || std::any_of(either.sides.begin(), either.sides.end(), given)) continue;
    for (const Key* key : known)
      if (key->name == either.sides[0][0]) add(*key);
  }
  // What no mesh can do
  static const std::set<std::string> OfScenes = {"materials", "lights",  "light_scale", "cameras",
                                                 "scene",     "variant", "time",        "duration"};
  if (keys.contains("file") && OfScenes.contains(name)) keys["file"] = "\"chair.gltf\"";
  // A time is one at a place
  static const std::set<std::string> OfTimes = {"time", "latitude", "longitude"};
  if (one.section->name == "sky" && OfTimes.contains(name))
    for (const Key* key : known)
      if (OfTimes.contains(key->name)) add(*key);
  keys[name] = value;

  std::string file = Frames.at(one.section->name);
  // Files have no positions of a mesh that is written in the scene
  if (one.section->name == "shape_key" && name == "positions")
    file.replace(
        file.find("file = \"bunny.ply\""), 18,
        "mesh = { positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]] }");
  const bool isInline = file.find("{ $ }") != std::string::npos;
  std::string text;
  for (const auto& [key, toml] : keys)
    text += (text.empty() ? "" : isInline ? ", " : "\n") + key + " = " + toml;
  return file.replace(file.find('$'), 1, text);
}

const char* const Bunny =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

const char* const Chair = R"({"asset": {"version": "2.0"}, "materials": [{"name": "Seat"}],
"extensions": {"KHR_materials_variants": {"variants": [{"name": "Red"}]}},
"buffers": [{"byteLength": 36, "uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
"nodes": [{"mesh": 0}], "scenes": [{"name": "Night", "nodes": [0]}]})";

const char* const Lamp = "IESNA91\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 9\n0 90\n0\n100 50\n";

std::vector<std::string> ErrorsOf(const std::string& text) {
  TestScene scene(text);
  if (text.find("bricks.png") != std::string::npos) scene.Write("bricks.png", OnePixel);
  if (text.find("sky.hdr") != std::string::npos) scene.Write("sky.hdr", OnePixel);
  if (text.find("bunny.ply") != std::string::npos) scene.Write("bunny.ply", Bunny);
  if (text.find("bunny-2.ply") != std::string::npos) scene.Write("bunny-2.ply", Bunny);
  if (text.find("chair.gltf") != std::string::npos) scene.Write("chair.gltf", Chair);
  if (text.find("lamp.ies") != std::string::npos) scene.Write("lamp.ies", Lamp);
  if (text.find("cloud.nvdb") != std::string::npos) scene.Write("cloud.nvdb", ReadFile(SNELL_GRID));
  return scene.Errors();
}

TEST(TomlTable, HasAFrameForEverySection) {
  for (const Section* section : AllSections())
    EXPECT_TRUE(Frames.contains(section->name) || section == &FileSection() ||
                section == &GroupSection())
        << section->name;
}

TEST(TomlTable, AcceptsEveryKeyWithItsExample) {
  int count = 0;
  for (const Case& one : AllCases()) {
    ASSERT_FALSE(one.key->example.empty()) << one.Name();
    const std::string text = FileWith(one, one.key->name, one.key->example);
    EXPECT_EQ(ErrorsOf(text), std::vector<std::string>()) << one.Name() << "\n" << text;
    ++count;
  }
  EXPECT_GT(count, 300);
}

TEST(TomlTable, AcceptsEveryDefaultThatItShows) {
  for (const Case& one : AllCases()) {
    if (!one.key->standard.empty() || one.key->required) continue;
    const std::string standard = DefaultOf(*one.section, one.variant, *one.key);
    if (standard.empty()) continue;
    const std::string text = FileWith(one, one.key->name, standard);
    EXPECT_EQ(ErrorsOf(text), std::vector<std::string>()) << one.Name() << "\n" << text;
  }
}

TEST(TomlTable, ShowsADefaultForEveryKeyThatMayBeLeftOut) {
  for (const Case& one : AllCases()) {
    const bool told = one.key->required || !one.key->standard.empty() ||
                      !DefaultOf(*one.section, one.variant, *one.key).empty();
    EXPECT_TRUE(told || one.section == &TransformStepSection()) << one.Name();
  }
}

TEST(TomlTable, LeadsFromEveryUsualMistakeToAKey) {
  for (const Case& one : AllCases()) {
    for (const std::string& mistake : one.key->mistakes) {
      // What one kind of material lacks another may have
      const auto isIt = [&](const Key& key) { return key.name == mistake; };
      if (one.variant && std::ranges::any_of(one.variant->keys, isIt)) continue;
      const std::string text = FileWith(one, mistake, "1");
      const std::vector<std::string> errors = ErrorsOf(text);
      ASSERT_FALSE(errors.empty()) << one.Name() << ": '" << mistake << "' is a key";
      EXPECT_NE(errors[0].find("unknown key '" + mistake), std::string::npos) << errors[0];
      EXPECT_NE(errors[0].find("did you mean '"), std::string::npos) << errors[0];
    }
  }
}

TEST(TomlTable, SaysInASentenceWhatEveryKeyDoes) {
  for (const Section* section : AllSections()) {
    EXPECT_TRUE(section->text.ends_with(".")) << section->name;
    for (const Key& key : section->keys) EXPECT_TRUE(key.text.ends_with(".")) << key.name;
    for (const Variant& variant : section->variants) {
      EXPECT_TRUE(variant.text.ends_with(".")) << variant.Title();
      for (const Key& key : variant.keys) EXPECT_TRUE(key.text.ends_with(".")) << key.name;
    }
  }
}

}  // namespace
}  // namespace snell::io
