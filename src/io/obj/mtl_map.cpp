// SPDX-License-Identifier: Apache-2.0
//
// The map statements of MTL files: a file name after options that scale, shift or select.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/mesh/text.h"
#include "io/obj/mtl.h"

namespace snell::io {
namespace {

// An option, how many words may follow it, and what is made of it if there is no use for it.
struct Option {
  std::string_view name;
  int least, most;
  std::string_view verdict;  // empty: it has a meaning, or none worth a word
};
constexpr Option Options[] = {
    {"-s", 1, 3, ""},          {"-o", 1, 3, ""},
    {"-mm", 2, 2, ""},         {"-bm", 1, 1, ""},
    {"-clamp", 1, 1, ""},      {"-imfchan", 1, 1, ""},
    {"-colorspace", 1, 1, ""}, {"-t", 1, 3, "not used: there is no turbulence in pictures"},
    {"-blendu", 1, 1, ""},     {"-blendv", 1, 1, ""},
    {"-cc", 1, 1, ""},         {"-texres", 1, 1, ""},
    {"-boost", 1, 1, ""},      {"-type", 1, 1, "not used: the map is laid out by uv"}};

const Option* FindOption(std::string_view word) {
  const auto* option = std::find_if(std::begin(Options), std::end(Options), [&](const Option& o) {
    return EqualsIgnoringCase(word, o.name);
  });
  return option == std::end(Options) ? nullptr : option;
}

// Options stand before the file's name, by some programs after it.
class MapReader {
 public:
  MapReader(std::string_view text, const Place& place, Findings& findings)
      : text_(text), scanner_(text), place_(place), findings_(findings) {}

  MtlMap Read() {
    std::size_t nameBegin = text_.size(), nameEnd = text_.size();
    bool inName = false;
    for (std::string_view word; !(word = scanner_.WordOnLine()).empty();) {
      const std::size_t at = scanner_.at() - word.size();
      const Option* option = FindOption(word);
      if (option) {
        if (inName) nameEnd = at;
        inName = false;
        Apply(*option);
      } else if (!inName) {
        inName = true;
        nameBegin = at;
        nameEnd = text_.size();
      }
    }
    std::string_view name = text_.substr(nameBegin, nameEnd - nameBegin);
    while (!name.empty() && IsBlank(name.back())) name.remove_suffix(1);
    if (name.size() > 1 && name.front() == '"' && name.back() == '"')
      name = name.substr(1, name.size() - 2);
    if (name.empty()) throw Error("the map needs a file's name", place_);
    map_.name = name;
    map_.line = place_.line;
    return map_;
  }

 private:
  void Apply(const Option& option) {
    if (!option.verdict.empty())
      findings_.Add(fmt::format("option '{}'", option.name), option.verdict, "", place_);
    if (option.name == "-clamp" || option.name == "-imfchan" || option.name == "-colorspace" ||
        option.name == "-type" || option.name.starts_with("-blend") || option.name == "-cc")
      return ApplyWord(option.name);

    float values[3] = {};
    int count = 0;
    for (; count < option.most; ++count) {
      // A number may also be the beginning of the name
      const TextScanner before = scanner_;
      const std::string_view word = scanner_.WordOnLine();
      double value = 0;
      if (ParseNumber(word, value)) {
        values[count] = float(value);
        continue;
      }
      scanner_ = before;
      break;
    }
    if (count < option.least)
      throw Error(fmt::format("option '{}' needs {} number{}", option.name, option.least,
                              option.least > 1 ? "s" : ""),
                  place_);
    if (!std::isfinite(values[0] + values[1])) {
      findings_.Add("option", "infinite or undefined, left out", option.name, place_);
      return;
    }
    ApplyNumbers(option.name, values, count);
  }

  void ApplyWord(std::string_view option) {
    const std::string_view word = scanner_.WordOnLine();
    if (word.empty()) throw Error(fmt::format("option '{}' needs a word", option), place_);
    if (option == "-clamp") map_.clamp = EqualsIgnoringCase(word, "on");
    if (option == "-imfchan") map_.channel = word[0];
    if (option != "-colorspace") return;
    map_.colorSpace = word;
    for (char& c : map_.colorSpace)
      if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }

  void ApplyNumbers(std::string_view option, const float (&values)[3], int count) {
    if (option == "-bm") map_.bump = values[0];
    if (option == "-o") map_.offset = {values[0], count > 1 ? values[1] : 0.0f};
    if (option == "-s") {
      const scene::vec2 scale(values[0], count > 1 ? values[1] : 1.0f);
      if (std::abs(scale.x) > 1e-6f && std::abs(scale.y) > 1e-6f)
        map_.scale = scale;
      else
        findings_.Add("option '-s'", "of 0 left out", "", place_);
    }
    if (option == "-mm" && (values[0] != 0 || values[1] != 1))
      findings_.Add("option '-mm'", "not read: brightness and contrast stay as they are", "",
                    place_);
  }

  std::string_view text_;
  TextScanner scanner_;
  const Place& place_;
  Findings& findings_;
  MtlMap map_;
};

}  // namespace

MtlMap ReadMtlMap(std::string_view text, const Place& place, Findings& findings) {
  return MapReader(text, place, findings).Read();
}

}  // namespace snell::io
