// SPDX-License-Identifier: Apache-2.0
//
// Why a pixel looks as it does: many of its samples, sorted by what happened to them.
#pragma once

#include <cstdint>
#include <string>

#include "explain/explain.h"

namespace snell::explain {

enum class Question { Black, Bright, Noisy };

// The answer from the samples 0 … samples − 1 of pixel (x, y), as lines to read.
std::string Why(const Explainer& explainer, Question question, int x, int y, std::uint32_t samples);

}  // namespace snell::explain
