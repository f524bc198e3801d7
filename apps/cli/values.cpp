// SPDX-License-Identifier: Apache-2.0
#include "cli/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "api/snell.h"
#include "util/file.h"

namespace snell::cli {

namespace {

constexpr int MaxPixels = 65536;  // in width or height

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

// The number that `text` is from end to end, if it is one that fits.
template <class Integer>
std::optional<Integer> ToInteger(const std::string& text) {
  Integer number{};
  const char* end = text.data() + text.size();
  const auto [rest, fault] = std::from_chars(text.data(), end, number);
  if (fault != std::errc() || rest != end) return {};
  return number;
}

bool IsWhole(const std::string& text) {
  const std::size_t first = !text.empty() && text[0] == '-' ? 1 : 0;
  return text.size() > first && text.find_first_not_of("0123456789", first) == text.npos;
}

// "'y' or 'z'"
std::string InWords(const std::vector<std::string>& words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 < words.size() ? ", " : " or ";
    list += "'" + words[i] + "'";
  }
  return list;
}

}  // namespace

ValueReader<int> WholeNumber(int lower, int upper) {
  return [=](const std::string& text) {
    if (!IsWhole(text)) throw BadValue("must be a whole number");
    const std::optional<int> number = ToInteger<int>(text);
    const bool low = number ? *number < lower : text[0] == '-';
    if (low) throw BadValue(fmt::format("must be at least {}", lower));
    if (!number || *number > upper) throw BadValue(fmt::format("must be at most {}", upper));
    return *number;
  };
}

ValueReader<float> Number(float lower, float upper) {
  return [=](const std::string& text) {
    char* rest = nullptr;
    const float number = std::strtof(text.c_str(), &rest);
    if (text.empty() || *rest != '\0' || std::isnan(number)) throw BadValue("must be a number");
    if (number < lower) throw BadValue(fmt::format("must be at least {:g}", lower));
    if (number > upper) throw BadValue(fmt::format("must be at most {:g}", upper));
    return number;
  };
}

std::pair<int, int> ReadSize(const std::string& text) {
  std::string plain = text;
  std::replace(plain.begin(), plain.end(), 'X', 'x');
  std::vector<std::string> parts = Split(plain, 'x');
  parts.resize(std::max<std::size_t>(parts.size(), 2));
  const auto side = [](const std::string& digits) -> std::optional<int> {
    if (digits.empty()) return 0;
    const std::optional<int> pixels = ToInteger<int>(digits);
    return pixels && *pixels >= 1 && *pixels <= MaxPixels ? pixels : std::nullopt;
  };
  const std::optional<int> width = side(parts[0]);
  const std::optional<int> height = side(parts[1]);
  if (parts.size() > 2 || !width || !height || *width + *height == 0)
    throw BadValue(
        fmt::format("must be like 800x600, or 800 for the width alone, up to {}", MaxPixels));
  return {*width, *height};
}

std::array<int, 4> ReadCrop(const std::string& text) {
  const std::vector<std::string> parts = Split(text, ',');
  std::array<int, 4> crop{};
  bool valid = parts.size() == crop.size();
  for (std::size_t i = 0; valid && i < crop.size(); ++i) {
    const std::optional<int> pixel = ToInteger<int>(parts[i]);
    valid = pixel && *pixel >= 0 && *pixel <= MaxPixels;
    crop[i] = pixel.value_or(0);
  }
  if (!valid) throw BadValue("must be four pixel numbers x0,y0,x1,y1 like 100,50,300,200");
  if (crop[0] >= crop[2] || crop[1] >= crop[3])
    throw BadValue("must have x0 below x1 and y0 below y1");
  return crop;
}

std::pair<std::uint32_t, std::uint32_t> ReadSampleRange(const std::string& text) {
  const std::vector<std::string> parts = Split(text, ':');
  const bool two = parts.size() == 2;
  const auto first = two ? ToInteger<std::uint32_t>(parts[0]) : std::nullopt;
  const auto last = two ? ToInteger<std::uint32_t>(parts[1]) : std::nullopt;
  if (!first || !last) throw BadValue("must be two sample numbers A:B like 0:16");
  if (*first >= *last) throw BadValue("must have A below B, the first sample that is left out");
  return {*first, *last};
}

double ReadDuration(const std::string& text) {
  static constexpr std::pair<char, double> Units[] = {
      {'s', 1}, {'m', 60}, {'h', 3600}, {'d', 86400}};
  std::string digits = text;
  double unit = 1;
  for (const auto& [letter, seconds] : Units) {
    if (!digits.empty() && digits.back() == letter) {
      digits.pop_back();
      unit = seconds;
      break;
    }
  }
  char* rest = nullptr;
  const double number = std::strtod(digits.c_str(), &rest);
  const bool plain = digits.find_first_not_of("0123456789.") == digits.npos;
  if (digits.empty() || !plain || *rest != '\0' || !(number > 0) || number > 1e9)
    throw BadValue("must be a time such as 90, 45s, 2m or 1h");
  return number * unit;
}

std::string ReadText(const std::string& text) { return text; }

std::string ReadPictureName(const std::string& text) {
  if (text[0] == '=') throw BadValue("is written -o FILE or --output=FILE");
  const std::vector<std::string> known = Split(KnownPictureExtensions(), ',');
  const std::string extension = LowerExtension(text);
  for (const std::string& name : known) {
    if (!extension.empty() && name.substr(name.find_first_not_of(' ')) == extension) return text;
  }
  throw BadValue("must name a picture by one of the extensions " + KnownPictureExtensions());
}

std::string SpokenName(const std::string& names) { return names.substr(names.rfind(',') + 1); }

CLI::Option* AddChoice(CLI::App& command, const std::string& names, const std::string& value,
                       std::optional<std::string>& target, const std::string& text) {
  const auto read = [words = Split(value, '|')](const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end())
      throw BadValue("must be " + InWords(words));
    return word;
  };
  return AddValue<std::string>(command, names, value, read, target, text);
}

CLI::Option* AddValues(CLI::App& command, const std::string& names, const std::string& value,
                       ValueReader<std::string> read, std::vector<std::string>& target,
                       const std::string& text) {
  const auto take = [read = std::move(read), name = SpokenName(names), value,
                     &target](const CLI::results_t& results) {
    for (const std::string& result : results) target.push_back(ReadFor(name, value, read, result));
    return true;
  };
  return command.add_option(names, take, text)
      ->type_name(value)
      ->type_size(1)
      ->expected(1, std::numeric_limits<int>::max())
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

CLI::Option* AddArgument(CLI::App& command, const std::string& name, std::string& target,
                         const std::string& text) {
  return command.add_option(name, target, text)->type_name(name)->required();
}

CLI::Option* AddArguments(CLI::App& command, const std::string& name,
                          std::vector<std::string>& target, const std::string& text) {
  return command.add_option(name, target, text)->type_name(name)->required();
}

CLI::Option* AddFlag(CLI::App& command, const std::string& names, bool& target,
                     const std::string& text) {
  return command.add_flag(names, target, text)->disable_flag_override();
}

}  // namespace snell::cli
