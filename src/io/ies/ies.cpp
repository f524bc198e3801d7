// SPDX-License-Identifier: Apache-2.0
//
// A file is lines of labels up to TILT=, then numbers: what the lamp is, the angles, and the candela of each horizontal
// angle in turn. Ends of lines mean nothing between numbers.
#include "io/ies/ies.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "io/ies/planes.h"
#include "util/error.h"

namespace snell::io {

namespace {

constexpr double LumensPerWatt = 683;

class Text {
 public:
  Text(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  [[noreturn]] void Refuse(const std::string& why, std::string hint = {}) const {
    throw Error(why, {file_, line_}, std::move(hint));
  }

  // The next line, without blanks at its end; false at the end of the file.
  bool Line(std::string_view& line) {
    if (at_ >= bytes_.size()) return false;
    line_ = nextLine_;
    const std::size_t end = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
    line = bytes_.substr(at_, end - at_);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    at_ = end;
    StepOverLineEnd();
    return true;
  }

  double Number(const char* what) {
    while (at_ < bytes_.size() && IsBlank(bytes_[at_])) {
      if (bytes_[at_] == '\r' || bytes_[at_] == '\n') {
        StepOverLineEnd();
      } else {
        ++at_;
      }
    }
    line_ = nextLine_;
    if (at_ >= bytes_.size()) Refuse(fmt::format("the file ends before {}", what));
    std::size_t end = at_;
    while (end < bytes_.size() && !IsBlank(bytes_[end])) ++end;
    std::string_view word = bytes_.substr(at_, end - at_);
    at_ = end;
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [rest, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc() || rest != word.data() + word.size() || !(std::abs(value) < 1e30))
      Refuse(fmt::format("a number is missing: {}", what));
    return value;
  }

  // How many of something; as many numbers must follow.
  std::size_t Count(const char* what) {
    const double value = Number(what);
    if (value != std::floor(value) || value < 1 || value > double(bytes_.size() - at_))
      Refuse(fmt::format("{} cannot be {:.6g}", what, value));
    return std::size_t(value);
  }

  std::vector<double> Numbers(std::size_t count, const char* what) {
    if (count > bytes_.size() - at_) Refuse(fmt::format("the file ends before {}", what));
    std::vector<double> numbers(count);
    for (double& number : numbers) number = Number(what);
    return numbers;
  }

 private:
  static bool IsBlank(char c) {
    return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n' || c == '\x1a';
  }
  void StepOverLineEnd() {
    if (at_ < bytes_.size() && bytes_[at_] == '\r') ++at_;
    if (at_ < bytes_.size() && bytes_[at_] == '\n') ++at_;
    ++nextLine_;
  }

  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  int nextLine_ = 1;
};

// Go on behind the labels. How the output changes as the lamp is tilted is read and not used, as its tilt is not known.
void SkipLabels(Text& text) {
  std::string_view line;
  bool isFirst = true;
  while (text.Line(line)) {
    if (line.starts_with("TILT=")) {
      line.remove_prefix(5);
      if (line == "NONE") return;
      if (line != "INCLUDE")
        text.Refuse("the lamp's tilt is in another file", "TILT=NONE and TILT=INCLUDE are read");
      text.Number("the lamp's place in the luminaire");
      const std::size_t count = text.Count("the number of tilt angles");
      text.Numbers(count, "the tilt angles");
      text.Numbers(count, "the factors of the tilt angles");
      return;
    }
    const bool isText =
        std::ranges::none_of(line, [](char c) { return c >= 0 && c < 0x20 && c != '\t'; });
    if (!isText) break;
    isFirst = false;
  }
  text.Refuse(isFirst ? "this is no IES file" : "this is no IES file: it has no line TILT=");
}

void RequireRising(const Text& text, const std::vector<double>& angles, const char* what) {
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (!(angles[i] > angles[i - 1]))
      text.Refuse(fmt::format("the {} angles do not rise: {:.6g} after {:.6g}", what, angles[i],
                              angles[i - 1]));
  }
}

}  // namespace

scene::LightProfile ReadIes(std::string_view bytes, const std::string& file) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  Text text(bytes, file);
  SkipLabels(text);

  text.Number("the number of lamps");
  text.Number("the lumens of a lamp");
  double factor = text.Number("the multiplier");
  const std::size_t verticals = text.Count("the number of vertical angles");
  const std::size_t horizontals = text.Count("the number of horizontal angles");
  const double type = text.Number("the type of photometry");
  text.Numbers(4, "the luminaire's size");
  factor *= text.Number("the ballast factor");
  // Of ballast and lamp; later issues of the standard keep the place for future use
  const double future = text.Number("the ballast-lamp factor");
  factor *= future > 0 ? future : 1;
  text.Number("the watts");

  Measurement measured;
  measured.verticals = text.Numbers(verticals, "the vertical angles");
  RequireRising(text, measured.verticals, "vertical");
  measured.horizontals = text.Numbers(horizontals, "the horizontal angles");
  RequireRising(text, measured.horizontals, "horizontal");
  if (verticals < 2) text.Refuse("there must be two vertical angles at least");
  if (verticals * horizontals > bytes.size()) text.Refuse("the file ends before the candela");
  measured.values = text.Numbers(verticals * horizontals, "the candela");
  for (double& value : measured.values) value = std::max(value * factor / LumensPerWatt, 0.0);
  if (!(*std::ranges::max_element(measured.values) < 1e30)) text.Refuse("the candela are too many");

  const bool isC = type == 1;
  if (!isC && type != 2 && type != 3)
    text.Refuse(fmt::format("photometry of type {:.6g} is not known", type),
                "1, 2 and 3 stand for C, B and A");
  const std::string fault = isC ? FaultOfC(measured) : FaultOfAOrB(measured);
  if (!fault.empty()) text.Refuse(fault);
  scene::LightProfile profile = isC         ? ProfileOfC(measured)
                                : type == 2 ? ProfileOfB(measured)
                                            : ProfileOfA(measured);
  profile.name = file;
  return profile;
}

}  // namespace snell::io
