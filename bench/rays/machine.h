// SPDX-License-Identifier: Apache-2.0
//
// What the figures were measured with.
#pragma once

#include <string>

namespace snell::bench {

// Processor and threads, what the two libraries make of them, and the compiler, on one line.
std::string DescribeMachine();

}  // namespace snell::bench
