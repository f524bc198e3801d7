// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "util/text.h"

namespace snell::io {

static constexpr std::size_t KindLimit = 200;

void GltfFindings::Note(std::string message, std::string where) {
  if (findings_.size() >= KindLimit) {
    message = "further findings are not shown";
    where.clear();
  }
  const auto known = std::ranges::find(findings_, message, &Finding::message);
  if (known != findings_.end()) {
    ++known->times;
  } else {
    findings_.push_back({std::move(message), std::move(where), 1});
  }
}

void GltfFindings::Report(const std::string& file, const WarningSink& warn) const {
  if (!warn) return;
  for (const Finding& finding : findings_) {
    std::string message = finding.message;
    if (finding.times > 1) {
      const std::string first = finding.first.empty() ? "" : ", first in " + finding.first;
      message += fmt::format(" ({} times{})", WithCommas(finding.times), first);
    } else if (!finding.first.empty()) {
      message += fmt::format(" ({})", finding.first);
    }
    warn({message, {file}});
  }
}

std::string GltfPart(std::string_view kind, std::size_t index, std::string_view name) {
  if (name.empty()) return fmt::format("{} {}", kind, index);
  std::string printable(name.substr(0, 60));
  for (char& c : printable)
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  return fmt::format("{} {} '{}'", kind, index, printable);
}

}  // namespace snell::io
