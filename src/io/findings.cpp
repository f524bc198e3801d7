// SPDX-License-Identifier: Apache-2.0
#include "io/findings.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/mesh/text.h"
#include "util/text.h"

namespace snell::io {

// A file may have words of its own without end.
static constexpr std::size_t MaxKinds = 200;
static constexpr std::string_view More = "further finding";

void Findings::Add(std::string_view noun, std::string_view verdict, std::string_view example,
                   const Place& place) {
  auto kind = std::find_if(kinds_.begin(), kinds_.end(),
                           [&](const Kind& k) { return k.noun == noun && k.verdict == verdict; });
  if (kind == kinds_.end() && kinds_.size() >= MaxKinds && noun != More)
    return Add(More, "not shown", "", place);
  if (kind == kinds_.end())
    kind =
        kinds_.insert(kind, {std::string(noun), std::string(verdict), std::string(example), place});
  ++kind->count;
}

void Findings::Report(const WarningSink& warn) const {
  if (!warn) return;
  for (const Kind& kind : kinds_) {
    std::string message = fmt::format("{} {}", Plural(kind.count, kind.noun), kind.verdict);
    if (!kind.example.empty())
      message +=
          fmt::format("{}{}", kind.count > 1 ? ", the first one " : ": ", Quoted(kind.example));
    warn({std::move(message), kind.place});
  }
}

}  // namespace snell::io
