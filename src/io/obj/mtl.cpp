// SPDX-License-Identifier: Apache-2.0
#include "io/obj/mtl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "io/mesh/text.h"

namespace snell::io {
namespace {

// Keywords, in lower case.
constexpr std::pair<std::string_view, MtlColor> Colors[] = {
    {"kd", MtlColor::Kd}, {"ks", MtlColor::Ks}, {"ke", MtlColor::Ke}, {"tf", MtlColor::Tf}};
constexpr std::pair<std::string_view, MtlNumber> Numbers[] = {
    {"ns", MtlNumber::Ns},   {"d", MtlNumber::D},         {"tr", MtlNumber::Tr},
    {"ni", MtlNumber::Ni},   {"illum", MtlNumber::Illum}, {"pr", MtlNumber::Pr},
    {"pm", MtlNumber::Pm},   {"ps", MtlNumber::Ps},       {"pc", MtlNumber::Pc},
    {"pcr", MtlNumber::Pcr}, {"aniso", MtlNumber::Aniso}, {"anisor", MtlNumber::Anisor}};
constexpr std::pair<std::string_view, MtlMapKey> Maps[] = {
    {"map_kd", MtlMapKey::Kd},    {"map_ks", MtlMapKey::Ks},       {"map_ns", MtlMapKey::Ns},
    {"map_ke", MtlMapKey::Ke},    {"map_d", MtlMapKey::D},         {"map_pr", MtlMapKey::Pr},
    {"map_pm", MtlMapKey::Pm},    {"map_ps", MtlMapKey::Ps},       {"map_pc", MtlMapKey::Pc},
    {"map_pcr", MtlMapKey::Pcr},  {"map_aniso", MtlMapKey::Aniso}, {"map_bump", MtlMapKey::Bump},
    {"bump", MtlMapKey::Bump},    {"norm", MtlMapKey::Normal},     {"disp", MtlMapKey::Disp},
    {"map_disp", MtlMapKey::Disp}};
// Maps that have no counterpart, or none yet.
constexpr std::pair<std::string_view, std::string_view> UnreadMaps[] = {
    {"refl", "reflection map"}, {"map_refl", "reflection map"},
    {"decal", "decal"},         {"map_tr", "transparency map (map_Tr)"},
    {"map_ka", "ambient map"},  {"map_anisor", "map of anisotropy's direction"}};
// Without a meaning here: ambient light is not a material's, and hints to old renderers.
constexpr std::string_view Silent[] = {"ka", "sharpness", "map_aat"};

template <class Table>
auto* FindKey(const Table& table, std::string_view word) {
  const auto entry = std::find_if(std::begin(table), std::end(table),
                                  [&](const auto& e) { return EqualsIgnoringCase(word, e.first); });
  return entry == std::end(table) ? nullptr : &entry->second;
}

// Takes the statements one by one.
class MtlReader {
 public:
  MtlReader(std::string_view text, const std::string& file, MtlMaterials& materials,
            Findings& findings)
      : text_(text), materials_(materials), findings_(findings), place_{.file = file} {}

  void Read() {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    TextScanner scanner(text_);
    while (scanner.left() > 0) {
      ++place_.line;
      TextScanner line(scanner.RestOfLine());
      const std::string_view keyword = line.WordOnLine();
      if (!keyword.empty() && keyword[0] != '#') ReadStatement(keyword, line);
    }
  }

 private:
  void ReadStatement(std::string_view keyword, TextScanner& line) {
    if (EqualsIgnoringCase(keyword, "newmtl")) return StartMaterial(line.RestOfLine());
    if (!current_ && !skipping_) {
      findings_.Add("statement", "before the first material left out", keyword, place_);
      return;
    }
    if (skipping_) return;
    if (const auto* color = FindKey(Colors, keyword))
      ReadColor(current_->colors[std::size_t(*color)], line);
    else if (const auto* number = FindKey(Numbers, keyword))
      ReadNumber(current_->numbers[std::size_t(*number)], keyword, line);
    else if (const auto* map = FindKey(Maps, keyword))
      current_->maps[std::size_t(*map)] = ReadMtlMap(line.RestOfLine(), place_, findings_);
    else if (const auto* unread = FindKey(UnreadMaps, keyword))
      findings_.Add(*unread, "not read", line.RestOfLine(), place_);
    else if (std::none_of(std::begin(Silent), std::end(Silent),
                          [&](auto word) { return EqualsIgnoringCase(keyword, word); }))
      findings_.Add("unknown material statement", "left out", keyword, place_);
  }

  // Names without use, and second materials of a name, are stepped over.
  void StartMaterial(std::string_view name) {
    if (name.empty()) throw Error("'newmtl' needs a name", place_);
    const auto entry = materials_.find(std::string(name));
    skipping_ = entry == materials_.end() || entry->second;
    if (entry != materials_.end() && entry->second)
      findings_.Add("material", "defined twice; the first definition counts", name, place_);
    if (skipping_) return;
    current_ = &entry->second.emplace();
    current_->name = name;
    current_->file = place_.file;
    current_->line = place_.line;
  }

  // Three numbers, one for all three, or three of CIE XYZ.
  void ReadColor(std::optional<scene::vec3>& color, TextScanner& line) {
    scene::vec3 value(0.0f);
    std::string_view word = line.WordOnLine();
    if (word == "spectral")
      return findings_.Add("spectral color", "left out", line.RestOfLine(), place_);
    const bool xyz = word == "xyz";
    if (xyz) word = line.WordOnLine();
    int count = 0;
    for (; count < 3 && !word.empty() && word[0] != '#'; word = line.WordOnLine())
      value[count++] = Number(word);
    if (count == 0) throw Error("a color needs one number or three", place_);
    for (; count < 3; ++count) value[count] = value[count - 1];
    if (!std::isfinite(value.x + value.y + value.z)) return NotFinite("color");
    // To Rec.709 (IEC 61966-2-1)
    if (xyz)
      value = scene::vec3(3.2406f * value.x - 1.5372f * value.y - 0.4986f * value.z,
                          -0.9689f * value.x + 1.8758f * value.y + 0.0415f * value.z,
                          0.0557f * value.x - 0.2040f * value.y + 1.0570f * value.z);
    color = value;
  }

  void ReadNumber(std::optional<float>& number, std::string_view keyword, TextScanner& line) {
    std::string_view word = line.WordOnLine();
    if (word == "-halo") {
      findings_.Add("option '-halo'", "read as an even opacity", "", place_);
      word = line.WordOnLine();
    }
    if (word.empty()) throw Error(fmt::format("{} needs a number", Quoted(keyword)), place_);
    const float value = Number(word);
    if (!std::isfinite(value)) return NotFinite("number");
    number = value;
  }

  float Number(std::string_view word) const {
    double value = 0;
    if (!ParseNumber(word, value)) throw Error(Quoted(word) + " is not a number", place_);
    return float(value);
  }

  void NotFinite(std::string_view noun) {
    findings_.Add(noun, "of materials infinite or undefined, left out", "", place_);
  }

  std::string_view text_;
  MtlMaterials& materials_;
  Findings& findings_;
  Place place_;
  MtlMaterial* current_ = nullptr;
  bool skipping_ = false;
};

}  // namespace

void ReadMtl(std::string_view text, const std::string& file, MtlMaterials& materials,
             Findings& findings) {
  RequireText(text, file);
  MtlReader(text, file, materials, findings).Read();
}

}  // namespace snell::io
