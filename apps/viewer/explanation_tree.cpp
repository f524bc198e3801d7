// SPDX-License-Identifier: Apache-2.0
#include "viewer/explanation_tree.h"

#include <algorithm>
#include <string_view>

namespace snell::viewer {

namespace {

constexpr std::string_view Branches[] = {" ", "│", "├", "└"};

// Take one sign of a drawn branch away. False: the text begins.
bool TakeBranch(std::string_view& line) {
  for (const std::string_view sign : Branches) {
    if (!line.starts_with(sign)) continue;
    line.remove_prefix(sign.size());
    return true;
  }
  return false;
}

// "12. refracted ray from …"
bool NamesARay(std::string_view text) {
  const std::size_t digits = text.find_first_not_of("0123456789");
  return digits != 0 && digits != text.npos && text.substr(digits).starts_with(". ");
}

}  // namespace

std::vector<ExplanationLine> LinesOfExplanation(const std::string& text) {
  std::vector<ExplanationLine> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    int depth = 0;
    while (TakeBranch(line)) ++depth;
    if (!line.empty()) lines.push_back({depth, NamesARay(line), std::string(line)});
  }
  return lines;
}

}  // namespace snell::viewer
