// SPDX-License-Identifier: Apache-2.0
//
// The explanation of a pixel, which is a text with branches drawn in it, as a tree of lines.
#pragma once

#include <string>
#include <vector>

namespace snell::viewer {

struct ExplanationLine {
  int depth =
      0;  // of the line in the text, in columns; a line belongs to the last one before it of a smaller depth
  bool isRay = false;
  std::string text;
};

// Without empty lines.
std::vector<ExplanationLine> LinesOfExplanation(const std::string& text);

}  // namespace snell::viewer
