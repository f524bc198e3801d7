// SPDX-License-Identifier: Apache-2.0
//
// What a render took: for people at its end, as JSON for --stats.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "api/snell.h"

namespace snell::cli {

struct RenderSummary {
  std::string scene;
  int width = 0;  // of the picture as it is written
  int height = 0;
  RenderReport report;
  double loadSeconds = 0;
  double writeSeconds = 0;
  double totalSeconds = 0;
  std::uint64_t peakBytes = 0;
  std::vector<std::string> files;     // that were written
  std::vector<std::string> warnings;  // of loading and rendering
};

// Several lines.
std::string SummaryText(const RenderSummary& summary);
std::string SummaryJson(const RenderSummary& summary);

// "16", or "3.25" if not all pixels have the same number of samples.
std::string SamplesText(double samplesPerPixel);

}  // namespace snell::cli
