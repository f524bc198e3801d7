// SPDX-License-Identifier: Apache-2.0
//
// The tree of a pixel's rays in the panel: each ray is a node, what it met stands below it.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "viewer/explanation_tree.h"
#include "viewer/panels.h"

namespace snell::viewer {

namespace {

void DrawLine(const std::string& text, int depth) {
  const float indent = 6.0f * float(depth) + 1;
  ImGui::Indent(indent);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Unindent(indent);
}

// The lines from `at` on that lie deeper than `depth`; returns the first one that does not.
std::size_t DrawBelow(const std::vector<ExplanationLine>& lines, std::size_t at, int depth,
                      bool visible) {
  while (at < lines.size() && lines[at].depth > depth) {
    const ExplanationLine& line = lines[at];
    if (!line.isRay) {
      if (visible) DrawLine(line.text, std::max(0, line.depth - depth - 5));
      ++at;
      continue;
    }
    bool isOpen = false;
    if (visible) {
      // Where the ray goes stands below its name
      const std::size_t way = std::min(line.text.find(" from ("), line.text.size());
      ImGui::SetNextItemOpen(true, ImGuiCond_Once);
      isOpen = ImGui::TreeNode(reinterpret_cast<const void*>(at + 1), "%s",
                               line.text.substr(0, way).c_str());
      if (isOpen && way < line.text.size()) DrawLine(line.text.substr(way + 1), 0);
    }
    at = DrawBelow(lines, at + 1, line.depth, isOpen);
    if (isOpen) ImGui::TreePop();
  }
  return at;
}

}  // namespace

void DrawExplanation(const PixelAnswer& answer) {
  ImGui::TextUnformatted(fmt::format("Pixel {},{} of {} × {}{}", answer.x, answer.y, answer.width,
                                     answer.height, answer.isOld ? ", as it was before" : "")
                             .c_str());
  if (ImGui::Button("Copy the text")) ImGui::SetClipboardText(answer.explanation.text.c_str());
  const std::vector<ExplanationLine> lines = LinesOfExplanation(answer.explanation.text);
  DrawBelow(lines, lines.empty() ? 0 : 1, -1, true);  // the first line repeats the pixel
}

}  // namespace snell::viewer
